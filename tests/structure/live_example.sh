#!/bin/bash
# Builds the examples with an installed library, and runs them: a session of arrays, and a live calibration with an
# emulated device on a wire that turns itself, and with one that somebody turns. Usage: live_example.sh CMAKE PREFIX ROOT HEXODERM_CLI EMULATOR
set -euo pipefail
cmake="$1"
prefix="$2"
example="$3/resources/examples/live_calibration.cpp"
cli="$4"
emulator="$5"
[ "$(grep -cvE '^//|^$' "$example")" -le 20 ] || { echo "the example has more than 20 lines"; exit 1; }

folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
"$cmake" -G Ninja -D CMAKE_BUILD_TYPE=Release -D "CMAKE_PREFIX_PATH=$prefix" -S "$prefix/share/hexoderm/examples" -B "$folder/build"
"$cmake" --build "$folder/build"
cd "$folder"

# expect_calibration: of 17 cells, good enough to use, and written for robots too.
expect_calibration() {
  "$cli" inspect live.calibration.json --json >said.json
  grep -q '"cells": 17' said.json || { cat said.json; exit 1; }
  grep -q '<robot' live.urdf
  rm live.calibration.json live.urdf
}
mkfifo hand
exec {device}< <("$emulator" --tcp 0 --speed 20 <hand)
exec {turn}>hand
read -r _ _ address <&"$device"
build/live_calibration "$address" auto | tee said.txt
[ "$(grep -c '^Pose ' said.txt)" = 4 ] || { echo "4 poses were expected"; exit 1; }
expect_calibration
build/live_calibration "$address" >said.txt &
calibration=$!
while kill -0 "$calibration" 2>/dev/null; do
  echo pose >&"$turn"
  sleep 0.5
done
wait "$calibration"
echo quit >&"$turn"
[ "$(grep -c '^Pose ' said.txt)" = 4 ] || { echo "4 poses were expected"; cat said.txt; exit 1; }
expect_calibration

# What was made up comes back.
build/session_from_arrays | tee said.txt
[ "$(grep -cE '^Cell [123]: .* off by 0\.0[0-9]{2} mm$' said.txt)" = 3 ] || { echo "three cells where they are were expected"; exit 1; }
"$cli" inspect arrays.session.json --json >said.json
grep -q '"cells": 3' said.json || { cat said.json; exit 1; }

# A component that there is not is named.
mkdir other
cat >other/CMakeLists.txt <<'END'
cmake_minimum_required(VERSION 3.22)
project(Other LANGUAGES CXX)
find_package(Hexoderm 0.1 REQUIRED COMPONENTS core window)
END
! "$cmake" -G Ninja -D "CMAKE_PREFIX_PATH=$prefix" -S other -B other/build >said.txt 2>&1 || exit 1
grep -q 'Hexoderm has no component "window"' said.txt || { cat said.txt; exit 1; }

# A device that is not there, and a source that is none.
! build/live_calibration nonsense://x 2>said.txt || exit 1
grep -q 'nonsense' said.txt
