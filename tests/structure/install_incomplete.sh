#!/bin/bash
# Fails unless an installation ends before it copies anything where a part is not built. Usage: install_incomplete.sh CMAKE BUILD
set -euo pipefail
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
cp "$2/install_check.cmake" "$2/built.cmake" "$folder"
"$1" -P "$folder/install_check.cmake"
sed -i 's|set(built_hexoderm_shared .*|set(built_hexoderm_shared "/none")|' "$folder/built.cmake"
if "$1" -P "$folder/install_check.cmake" 2>"$folder/said"; then
  echo "a library that is not built is not missed"
  exit 1
fi
grep -q "Nothing is installed, because hexoderm_shared is not built" "$folder/said"
"$1" -D CMAKE_INSTALL_COMPONENT=Runtime -P "$folder/install_check.cmake"
