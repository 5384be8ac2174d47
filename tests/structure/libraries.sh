#!/bin/bash
# Fails, naming file and line, for an include of a library that a part of the project may not use (core/README.md); the
# order of the project's own folders is checked by rooms.py. Usage: libraries.sh ROOT
set -euo pipefail
cd "$1"

# Every include of a tree as "file:line:<name>" or file:line:"name".
includes() {
  grep -rnE --include='*.h' --include='*.cpp' --include='*.in' '^[[:space:]]*#[[:space:]]*include' "$@" |
    sed -E 's/^([^:]*:[0-9]+:).*include[[:space:]]*([<"][^>"]*[>"]).*/\1\2/' || true
}

violations=""
# forbid WHY PATTERN FOLDER...: no include in the folders may match the extended regular expression.
forbid() {
  local why="$1" pattern="$2" found
  shift 2
  [ "$#" -gt 0 ] && ls -d "$@" >/dev/null || { echo "There is nothing to look at: $why"; exit 1; }
  found="$(includes "$@" | grep -E ":[0-9]+:[<\"]($pattern)" | sed "s|\$| -- $why|" || true)"
  [ -z "$found" ] || violations+="$found"$'\n'
}

gui='Q[A-Z][A-Za-z]*[>"/]|Qt[A-Z5-9]|vtk'
forbid "core has neither Qt nor VTK" "$gui" core
forbid "the command line has neither Qt nor VTK" "$gui" app/cli
forbid "the emulator has neither Qt nor VTK" "$gui" app/emulator
forbid "the Python module has neither Qt nor VTK" "$gui" app/python
forbid "widgets show what core computed" 'ceres/|sqlite3|boost/|google/protobuf|nlohmann/|pugixml|assimp/|zip\.h|urdf|kdl' widgets
forbid "headers of core carry no third-party types but Eigen's" \
  'ceres/|sqlite3|google/protobuf|pugixml|assimp/|openssl/|CLI/|fmt/|zip\.h|urdf_|kdl|console_bridge' $(find core -name '*.h')
forbid "only the Python module knows Python" 'pybind11|Python\.h|numpy' core widgets app/cli app/emulator app/window

[ -z "$violations" ] || { printf '%s' "$violations"; exit 1; }
