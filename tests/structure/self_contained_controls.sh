#!/bin/bash
# Shows that self_contained.py accepts proper texts and catches each kind of violation, alone among them.
set -euo pipefail
check="$(dirname "${BASH_SOURCE[0]}")/self_contained.py"
tree="$(mktemp -d)"
trap 'rm -rf "$tree"' EXIT

mkdir -p "$tree"/core/hexoderm/graph "$tree"/widgets/style "$tree"/tests/structure
cat >"$tree/core/hexoderm/graph/skin.cpp" <<'CODE'
// See core/hexoderm/graph/README.md, tests/structure, widgets/style/palette and core/hexoderm/{graph,graph/skin.cpp}.
const char* kText = "core/no_such_folder is no comment";
CODE
echo 'See [the README of the project](../../../README.md#layers), widgets/ and build/release/app/cli.' \
  >"$tree/core/hexoderm/graph/README.md"
touch "$tree/README.md" "$tree/widgets/style/palette.h"
echo 'configure_file(a b COPYONLY)  # resources are copied' >"$tree/CMakeLists.txt"

if ! python3 "$check" "$tree"; then
  echo "Proper texts were refused"
  exit 1
fi

failed=0
while read -r file text; do
  [ -n "$file" ] || continue
  text="${text//@/}"  # keeps the word from being found in this file
  echo "$text" >"$tree/$file"
  if output="$(python3 "$check" "$tree" 2>&1)" || [[ "$output" != "$file:1: "* || "$output" == *$'\n'* ]]; then
    echo "Not caught, or not alone: $file with $text; the check said: $output"
    failed=1
  fi
  rm "$tree/$file"
done <<'VIOLATIONS'
core/hexoderm/graph/a.h // The exit codes (@SP@EC 5.1).
widgets/style/a.cpp const int a = 1;  // see BLUEPRINT.md
widgets/style/README.md Layers are described in PLAN.md.
core/hexoderm/graph/b.h /// As core/graph/skin.cpp has it.
tests/structure/a.py # Written by core/hexoderm/graph/no_such_unit.
widgets/style/b.h // core/hexoderm/{graph,helpers} hold them.
widgets/README.md See [the skin](../core/graph/README.md).
widgets/CMakeLists.txt file(CREATE_LINK a b SYMBOLIC)
widgets/style/a.cmake execute_process(COMMAND ${CMAKE_COMMAND} -E create_symlink a b)
VIOLATIONS
exit $failed
