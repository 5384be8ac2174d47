#!/bin/bash
# Runs the README's command line examples, one after the other, in an empty folder.
# Usage: readme_examples.sh ROOT HEXODERM_CLI
set -euo pipefail
examples="$(sed -n '/^```sh$/,/^```$/p' "$1/README.md" | grep '^hexoderm-cli ')"
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
cd "$folder"
while read -r _ arguments; do
  echo "\$ hexoderm-cli $arguments"
  # shellcheck disable=SC2086  # the examples need no quoting
  "$2" $arguments
done <<<"$examples"
