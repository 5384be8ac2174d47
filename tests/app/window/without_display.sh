#!/bin/bash
# The program where there is no display: help and version are told, and a window that can't be is one line and exit code
# 4, not an abort. Usage: without_display.sh PROGRAM VERSION
set -euo pipefail
program="$1"
version="$2"
folder="$(mktemp -d)"
trap 'rm -r "$folder"' EXIT

fail() {
  echo "$1"
  exit 1
}

# run EXPECTED_CODE [NAME=VALUE...] -- ARGUMENTS...: without a display but for what the environment says.
run() {
  local expected="$1" code=0
  shift
  local environment=()
  while [ "$1" != "--" ]; do environment+=("$1"); shift; done
  shift
  env -u DISPLAY -u WAYLAND_DISPLAY -u QT_QPA_PLATFORM HOME="$folder" LC_ALL=C.UTF-8 "${environment[@]}" \
    timeout 60 "$program" "$@" >"$folder/out" 2>"$folder/err" || code=$?
  [ "$code" = "$expected" ] || fail "hexoderm $*: exit code $code, expected $expected: $(cat "$folder/err")"
}

one_line() {
  [ "$(wc -l <"$folder/err")" = 1 ] || fail "expected one line, found: $(cat "$folder/err")"
  grep -q "$1" "$folder/err" || fail "expected \"$1\", found: $(cat "$folder/err")"
}

run 0 -- --help
grep -q -- "--demo" "$folder/out" || fail "the help names no options: $(cat "$folder/out")"
run 0 -- --demo -h
run 0 -- --version
[ "$(cat "$folder/out")" = "hexoderm $version" ] || fail "expected the version, found: $(cat "$folder/out")"
run 0 -- --help --language de
grep -q "Demo" "$folder/out" || fail "the help is not in German: $(cat "$folder/out")"
run 4 --
one_line "needs a display"
run 4 -- --demo
one_line "needs a display"
run 4 DISPLAY=:4711 --
one_line "needs a display"
run 4 -- --language de
one_line "braucht einen Bildschirm"
