#!/bin/bash
# Fails for a public symbol without a comment, and for a comment that Doxygen can't follow. Fields whose name and type say all
# need none; functions, types, enumerations and constants do. Usage: documented.sh DOXYGEN DOXYFILE
set -euo pipefail
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT

{
  cat "$2"
  printf '%s\n' "OUTPUT_DIRECTORY = $folder" "WARN_LOGFILE = $folder/warnings" "GENERATE_HTML = NO" "GENERATE_XML = YES"
} | "$1" -
# Of a template of the standard library that is specialised, Doxygen says that it does not know it.
problems="$(sed -E '/\(variable\) of (struct|class|union) .* is not documented|Internal inconsistency: scope for class std::/d' \
  "$folder/warnings")"
[ -z "$problems" ] || { echo "$problems"; exit 1; }
