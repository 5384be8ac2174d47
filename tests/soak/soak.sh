#!/bin/bash
# Two hours of a streaming skin, compressed: soak.cpp has its course. Builds the program if it is not up to date.
# Usage: tests/soak/soak.sh [--minutes N] [--growth-mib M]
set -euo pipefail
cd "$(dirname "$0")/../.."
cmake --preset core >/dev/null
cmake --build --preset core --target soak
[ $# -gt 0 ] || set -- --minutes 120
exec build/core/tests/soak/soak "$@"
