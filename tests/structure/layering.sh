#!/bin/bash
# Fails, naming file and line, for an include that goes against the layers (core/README.md). Usage: layering.sh ROOT
set -euo pipefail
cd "$1"

# Every include of a tree as "file:line:<name>" or file:line:"name".
includes() {
  grep -rnE --include='*.h' --include='*.cpp' --include='*.in' '^[[:space:]]*#[[:space:]]*include' "$@" 2>/dev/null |
    sed -E 's/^([^:]*:[0-9]+:).*include[[:space:]]*([<"][^>"]*[>"]).*/\1\2/' || true
}

violations=""
# forbid WHY PATTERN FOLDER...: no include in the folders may match the extended regular expression.
forbid() {
  local why="$1" pattern="$2" found
  shift 2
  found="$(includes "$@" | grep -E ":[0-9]+:[<\"]($pattern)" | sed "s|\$| -- $why|" || true)"
  [ -z "$found" ] || violations+="$found"$'\n'
}

gui='Q[A-Z][A-Za-z]*[>"/]|Qt[A-Z5-9]|vtk'
forbid "core has neither Qt nor VTK" "$gui" core
forbid "core is below widgets and app" '(\.\./)*(widgets|app)/' core
forbid "the command line has neither Qt nor VTK" "$gui" app/cli
forbid "the command line is no part of the window" '(\.\./)*(widgets|app/window)/' app/cli
forbid "widgets show what core computed" 'ceres/|sqlite3|boost/|google/protobuf|nlohmann/|pugixml|assimp/' widgets
forbid "widgets are below app" '(\.\./)*app/' widgets
forbid "headers of core carry no third-party types but Eigen's" \
  'ceres/|sqlite3|google/protobuf|pugixml|assimp/|openssl/|CLI/|fmt/' $(find core -name '*.h')

# Inside core: a layer includes itself and those before it, by the full name, in which a layer may have folders. Only a
# header that is private to its folder goes by its bare name.
layers=(util geometry graph device capture session reconstruction io course)
for ((i = 0; i < ${#layers[@]}; ++i)); do
  layer="${layers[i]}"
  allowed="$(IFS='|'; echo "${layers[*]:0:i+1}")"
  above="$(includes "core/$layer" | grep ':"' | grep -vE ":\"(hexoderm/($allowed)/([a-z0-9_]+/)?)?[a-z0-9_]+\.h\"$" || true)"
  [ -z "$above" ] || violations+="$(sed "s#\$# -- $layer includes only $allowed, as \"hexoderm/LAYER/HEADER.h\"#" <<<"$above")"$'\n'
done
for folder in core/*/; do
  layer="$(basename "$folder")"
  [[ " ${layers[*]} " == *" $layer "* ]] || violations+="core/$layer is no layer that this check knows"$'\n'
done

[ -z "$violations" ] || { printf '%s' "$violations"; exit 1; }
