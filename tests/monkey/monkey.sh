#!/bin/bash
# Twenty minutes of random input on the window: monkey.cpp has its actions. Builds the program if it is not up to date.
# Usage: tests/monkey/monkey.sh [--minutes N] [--seed N] [--limit-ms N] [--discount-load]
set -euo pipefail
cd "$(dirname "$0")/../.."
source packaging/environment.sh
cmake --preset release >/dev/null
cmake --build --preset release --target monkey --parallel "$jobs"
[ $# -gt 0 ] || set -- --minutes 20
on_virtual_display build/release/tests/monkey/monkey "$@"
