#!/bin/bash
# Shows that top_level.sh accepts a proper tree and fails for a stray and for a missing name.
set -euo pipefail
check="$(dirname "${BASH_SOURCE[0]}")/top_level.sh"
tree="$(mktemp -d)"
trap 'rm -rf "$tree"' EXIT

# expect WHAT LINE: the check fails and prints the line.
expect() {
  local output
  if output="$(bash "$check" "$tree")" || ! grep -qxF "$2" <<<"$output"; then
    echo "$1 was not caught; the check said: $output"
    exit 1
  fi
}

mkdir "$tree"/{app,core,packaging,resources,tests,widgets,build,.ci}
touch "$tree"/{CHANGELOG.md,CMakeLists.txt,CMakePresets.json,LICENSE,README.md,.gitignore}
bash "$check" "$tree"

touch "$tree/notes.txt"
expect "A stray file" "notes.txt does not belong there"
rm "$tree/notes.txt"
rmdir "$tree/widgets"
expect "A missing folder" "widgets is missing"
