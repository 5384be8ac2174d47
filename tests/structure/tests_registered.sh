#!/bin/bash
# Fails for a test file that the CMakeLists.txt beside it does not name: it would be compiled by nobody.
# Usage: tests_registered.sh ROOT
set -euo pipefail
cd "$1/tests"
failed=0
while read -r file; do
  grep -qwF "$(basename "$file")" "$(dirname "$file")/CMakeLists.txt" || { echo "tests/$file is not registered"; failed=1; }
done < <(find . '(' -name '*_test.cpp' -o -name '*_test.py' ')' -printf '%P\n' | sort)
exit $failed
