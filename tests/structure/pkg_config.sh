#!/bin/bash
# Compiles the consumer with what pkg-config says of an installed library, without CMake, and runs it. With an older language
# the compiler's first complaint says which one is needed.
# Usage: pkg_config.sh PREFIX LIBRARY_FOLDER CXX CONSUMER
set -euo pipefail
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
export PKG_CONFIG_PATH="$1/$2/pkgconfig"
pkg-config --print-errors --exists 'hexoderm >= 0.1'
# shellcheck disable=SC2046  # several words
"$3" -std=c++20 -o "$folder/consumer" -D "CELL_MODELS=\"$(pkg-config --variable=cell_models hexoderm)\"" "$4/main.cpp" \
  $(pkg-config --cflags --libs hexoderm)
# shellcheck disable=SC2046
! "$3" -std=c++17 -fsyntax-only "$4/main.cpp" $(pkg-config --cflags hexoderm) 2>"$folder/said.txt" || exit 1
grep -m1 'error' "$folder/said.txt" | grep 'Hexoderm needs C++20' || { head "$folder/said.txt"; exit 1; }
LD_LIBRARY_PATH="$1/$2" "$folder/consumer"
