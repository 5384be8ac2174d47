#!/bin/bash
# Brings the files for Qt Linguist up to date with the sources, and says how many texts still lack a translation.
# Translate with: linguist resources/translations/hexoderm_de.ts
# Usage: packaging/translations.sh
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/environment.sh"
cd "$root"

for file in resources/translations/*.ts; do
  # Without places in the sources the file changes only where a text does; texts that are gone are dropped.
  lupdate -silent -I . -locations none -no-obsolete widgets app/window -ts "$file"
  echo "$file: $(grep -c '<message' "$file") texts, $(grep -c 'type="unfinished"' "$file" || true) without a translation"
done
