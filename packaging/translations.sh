#!/bin/bash
# Brings the files for Qt Linguist up to date with the sources, and says how many texts still lack a translation.
# Translate with: linguist resources/translations/hexoderm_de.ts
# Usage: packaging/translations.sh [FILE.ts...]   (default: all in resources/translations)
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/environment.sh"
files=()
for file in "$@"; do files+=("$(realpath "$file")"); done
cd "$root"
[ $# -gt 0 ] || files=(resources/translations/*.ts)

# The templates of messages stand in core, which knows no Qt.
templates="$(mktemp -d)"
trap 'rm -r "$templates"' EXIT
packaging/messages.py core widgets app/window >"$templates/messages.cpp"

for file in "${files[@]}"; do
  # Without places in the sources the file changes only where a text does; texts that are gone are dropped.
  lupdate -silent -I . -locations none -no-obsolete widgets app/window "$templates" -ts "$file"
  echo "$file: $(grep -c '<message' "$file") texts, $(grep -c 'type="unfinished"' "$file" || true) without a translation"
done
