#!/bin/bash
# Shows that rooms.py accepts a proper tree and catches each kind of violation, alone in that tree.
set -euo pipefail
check="$(dirname "${BASH_SOURCE[0]}")/rooms.py"
tree="$(mktemp -d)"
trap 'rm -rf "$tree"' EXIT

# plant FILE [INCLUDE]...: a source of these includes.
plant() {
  local file="$tree/$1"
  shift
  mkdir -p "$(dirname "$file")"
  if [ "$#" -gt 0 ]; then printf '#include %s\n' "$@" >"$file"; else : >"$file"; fi
}
plant core/hexoderm/util/ids.h '<vector>'
plant core/hexoderm/geometry/se3.h '"hexoderm/util/ids.h"' '<Eigen/Core>'
plant core/hexoderm/graph/skin_graph.h '"hexoderm/util/ids.h"'
plant core/hexoderm/device/sample_frame.h
plant core/hexoderm/device/skin_source.h '"hexoderm/device/sample_frame.h"'
plant core/hexoderm/device/skinwire/skinwire.proto
plant core/hexoderm/device/skinwire/codec.h
plant core/hexoderm/device/skinwire/codec.cpp '"hexoderm/device/skinwire/skinwire.pb.h"' '"hexoderm/device/skin_source.h"'
plant core/hexoderm/device/simulation/patch_plan.h
plant core/hexoderm/reconstruction/result/reconstruction.h '"hexoderm/graph/skin_graph.h"'
plant core/hexoderm/reconstruction/figures/overlays.h '"hexoderm/reconstruction/result/reconstruction.h"'
plant core/hexoderm/reconstruction/reconstructor.cpp '"hexoderm/reconstruction/figures/overlays.h"'
plant core/hexoderm/io/open_file.h
plant widgets/style/palette.h
plant widgets/tables/cell_table.h '"widgets/style/palette.h"' '"hexoderm/reconstruction/result/reconstruction.h"'
plant widgets/scene/patch_scene.h
plant app/window/files/recovery.h
plant app/window/session/verification.h '"app/window/files/recovery.h"'
plant app/window/main_window/main_window.h '"widgets/tables/cell_table.h"' '"app/window/session/verification.h"'
plant app/window/main.cpp '"app/window/main_window/main_window.h"'
plant app/emulator/console.h
plant tests/support/matchers.h '"hexoderm/io/open_file.h"'
plant tests/app/window/export_test.cpp '"tests/support/matchers.h"' '"export_test.moc"'

if ! python3 "$check" "$tree"; then
  echo "A proper tree was refused"
  exit 1
fi
table="$(python3 "$check" --table "$tree")"
[[ "$table" =~ widgets\ +3\ +3\ +1\ +0 ]] || { echo "The table counts otherwise: $table"; exit 1; }

failed=0
# expect OUTPUT FILE [INCLUDE]: the check names the file and line of this violation, and nothing else.
expect() {
  local expected="$1" output
  shift
  plant "$@"
  if output="$(python3 "$check" "$tree" 2>&1)" || [[ "$output" != "$expected"* || "$output" == *$'\n'* ]]; then
    echo "Not caught, or not alone: $*; the check said: $output"
    failed=1
  fi
  rm "$tree/$1"
}
while read -r file include; do
  [ -n "$file" ] && expect "$file:1:$include" "$file" "$include"
done <<'VIOLATIONS'
core/hexoderm/util/a.h "hexoderm/geometry/se3.h"
core/hexoderm/graph/a.cpp "hexoderm/device/skinwire/codec.h"
core/hexoderm/reconstruction/result/a.cpp "hexoderm/io/open_file.h"
core/hexoderm/graph/a.h "widgets/style/palette.h"
core/hexoderm/device/sample_frame.cpp "hexoderm/device/skin_source.h"
core/hexoderm/device/skinwire/a.cpp "hexoderm/device/simulation/patch_plan.h"
core/hexoderm/reconstruction/result/b.cpp "hexoderm/reconstruction/figures/overlays.h"
widgets/style/a.cpp "widgets/tables/cell_table.h"
widgets/tables/a.cpp "widgets/scene/patch_scene.h"
widgets/tables/b.cpp "app/window/main_window/main_window.h"
widgets/tables/c.cpp "tests/support/matchers.h"
app/window/files/a.cpp "app/window/session/verification.h"
app/window/session/a.cpp "app/window/main_window/main_window.h"
app/emulator/a.cpp "app/window/files/recovery.h"
core/hexoderm/graph/b.cpp "skin_graph.h"
core/hexoderm/io/a.cpp "../graph/skin_graph.h"
core/hexoderm/io/b.cpp "hexoderm/io/../graph/skin_graph.h"
core/hexoderm/io/c.cpp "core/hexoderm/io/open_file.h"
core/hexoderm/io/d.cpp "hexoderm/io/no_such_file.h"
core/hexoderm/io/e.cpp "hexoderm/io/no_such_file.pb.h"
tests/app/window/a_test.cpp "export_test.moc"
VIOLATIONS
expect "core/hexoderm/helpers/a.h stands in no room of core/hexoderm" core/hexoderm/helpers/a.h
expect "widgets/view.h stands in no room of widgets" widgets/view.h
expect "app/window/extras/a.cpp stands in no room of app/window" app/window/extras/a.cpp
expect "core/hexoderm/device/a.h stands in no room of core/hexoderm/device" core/hexoderm/device/a.h
expect "tools/a.cpp stands in no room of the project" tools/a.cpp
exit $failed
