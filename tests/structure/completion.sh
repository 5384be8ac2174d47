#!/bin/bash
# Fails unless the command line's completion for bash offers what could come next. Usage: completion.sh COMPLETION HEXODERM_CLI
set -euo pipefail
# shellcheck source=/dev/null
source "$1"
cli="$2"
compopt() { :; }  # knows only what a shell that is waiting for a user completes
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
cd "$folder"
touch arm.hexo arm.calibration.json

# expect WORDS... -> WHAT...: the last of the words is completed.
expect() {
  local expected=()
  COMP_WORDS=("$cli")
  while [ "$1" != '->' ]; do
    COMP_WORDS+=("$1")
    shift
  done
  shift
  expected=("$@")
  COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
  _hexoderm
  local found
  found="$(printf '%s\n' "${COMPREPLY[@]}" | sort | tr '\n' ' ')"
  [ "$found" = "${expected[*]} " ] ||
    { echo "${COMP_WORDS[*]}: expected \"${expected[*]}\", found \"$found\""; exit 1; }
}
expect so '->' solve
expect --ver '->' --version
expect solve --so '->' --solver
expect solve a '->' arm.calibration.json arm.hexo
expect solve -o arm.c '->' arm.calibration.json
expect reproduce --only p '->' paper place
expect reproduce --only = p '->' paper place
expect reproduce --only = '->' accuracy check detection paper place uncertainty
expect --json solve --we '->' --weights
