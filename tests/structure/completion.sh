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

# expect WORDS... -> WHAT...: the last of the words is completed, the first being "$typed".
typed="$cli"
expect() {
  local expected=()
  COMP_WORDS=("$typed")
  while [ "$1" != '->' ]; do
    COMP_WORDS+=("$1")
    shift
  done
  shift
  expected=("$@")
  COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
  _hexoderm || true  # a shell that is waiting for a user does not end at errors
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
expect simulate --base m '->' motors
expect simulate --base = m '->' motors
expect simulate --base = '->' fixed hand motors
expect --json solve --we '->' --weights

# However the program is spelled, and from PATH where that says nothing.
mkdir "two words"
ln -s "$cli" "two words/hexoderm-cli"
PATH="$folder/two words:$PATH"
for typed in '"two words"/hexoderm-cli' "'two words'/hexoderm-cli" 'two\ words/hexoderm-cli' hexoderm-cli \
  "\$FOLDER/hexoderm-cli"; do
  expect solve --so '->' --solver
done

# One that does not answer is not waited for.
printf '#!/bin/sh\nexec sleep 60\n' >mute
chmod +x mute
typed=./mute
SECONDS=0
expect arm.h '->' arm.hexo
[ "$SECONDS" -lt 30 ] || { echo "waited $SECONDS s for a program that does not answer"; exit 1; }
