#!/bin/bash
# Sets up, builds all that can be installed, and starts Hexoderm on the demo skin. Without a display the same calibration
# runs headless.
# Usage: packaging/run.sh [arguments for the window, for example a session file]
# HEXODERM_OUT: where the headless run writes (default: out/demo)
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/environment.sh"

"$root/packaging/setup.sh"
cd "$root"
build() {
  cmake --preset release &&
    cmake --build --preset release --parallel "$jobs" --target hexoderm_installed
}
# A first build shows its progress; after that the build's few lines are of no interest.
if [ -x build/release/app/window/hexoderm ] && [ -x build/release/app/cli/hexoderm-cli ]; then
  build_log="$(build 2>&1)" || { echo "$build_log" >&2; exit 1; }
else
  echo "Building Hexoderm for the first time."
  build
fi
cli="$root/build/release/app/cli/hexoderm-cli"
window="$root/build/release/app/window/hexoderm"
cd - >/dev/null

if has_display; then
  demo=(--demo)
  for argument in "$@"; do
    [ ! -f "$argument" ] || demo=()  # a file to open takes the demo's place
  done
  exec "$window" "${demo[@]}" "$@"
fi

out="${HEXODERM_OUT:-$root/out/demo}"
mkdir -p "$out"
echo
echo "There is no display, so the window can't open (DISPLAY is ${DISPLAY:-not set})."
[ $# -eq 0 ] || echo "The arguments are for the window and are not used: $*"
echo "Running the same calibration of the simulated skin headless. Everything goes to $out"

step() {
  printf '\n$ hexoderm-cli'
  printf ' %q' "$@"
  printf '\n'
  "$cli" "$@"
}
session="$out/x17.session.json"
calibration="$out/x17.calibration.json"
step simulate --patch x17 --surface cylinder:r=0.0501 --poses 3 --seed 1 -o "$session"
# 1 says that the verdict is "not enough" or worse; the calibration is written all the same.
step solve "$session" -o "$calibration" || [ $? -eq 1 ]
step evaluate "$calibration" --fit cylinder --true-radius 0.0501 --against "$session"
step inspect "$calibration"
step export "$calibration" --to csv -o "$out/csv"
for format in urdf ply stl vtp dot; do
  step export "$calibration" --to "$format" -o "$out/x17.$format"
done
for theme in light dark; do
  on_virtual_display "$window" --demo --poses 3 --theme "$theme" --screenshot "$out/window-$theme.png"
done

echo
echo "Done. In $out:"
cd "$out"
find . -type f -printf '  %P\n' | sort
