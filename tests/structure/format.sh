#!/bin/bash
# Fails for a source file that clang-format would lay out differently. Usage: format.sh ROOT CLANG_FORMAT
set -euo pipefail
cd "$1"
find core widgets app tests -name '*.h' -print0 -o -name '*.cpp' -print0 | xargs -0 "$2" --dry-run -Werror
