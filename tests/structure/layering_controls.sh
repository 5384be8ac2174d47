#!/bin/bash
# Shows that layering.sh accepts a proper tree and catches each kind of violation, alone in that tree.
set -euo pipefail
check="$(dirname "${BASH_SOURCE[0]}")/layering.sh"
tree="$(mktemp -d)"
trap 'rm -rf "$tree"' EXIT

mkdir -p "$tree"/core/{util,geometry,graph,device,capture,session,reconstruction,io} "$tree"/{widgets,app/cli,app/window}
cat >"$tree/core/graph/skin.cpp" <<'CODE'
#include "hexoderm/graph/skin.h"
#include <boost/graph/adjacency_list.hpp>
#include <quadmath.h>
#include "skin_private.h"
#include <vector>
#include "hexoderm/util/ids.h"
CODE
echo '#include <Eigen/Core>' >"$tree/core/graph/skin.h"
echo '#include <QWidget>' >"$tree/widgets/view.cpp"
echo '#include "widgets/view.h"' >"$tree/app/window/main.cpp"
echo '#include "hexoderm/io/open_file.h"' >"$tree/app/cli/main.cpp"

if ! bash "$check" "$tree"; then
  echo "A proper tree was refused"
  exit 1
fi

failed=0
while read -r file include; do
  [ -n "$file" ] || continue
  echo "#include $include" >"$tree/$file"
  if output="$(bash "$check" "$tree")" || [[ "$output" != *"$file:1:$include"* ]]; then
    echo "Not caught: $file includes $include; the check said: $output"
    failed=1
  fi
  rm "$tree/$file"
done <<'VIOLATIONS'
core/util/a.h <QString>
core/io/a.cpp <QtCore/QFile>
core/io/c.cpp "QFile"
core/reconstruction/a.cpp <vtkPolyData.h>
core/graph/a.cpp "widgets/palette.h"
core/graph/b.cpp "../../app/window/main_window.h"
core/util/b.cpp "hexoderm/geometry/se3.h"
core/geometry/a.h "hexoderm/graph/skin_graph.h"
core/session/a.h "hexoderm/reconstruction/reconstruction.h"
core/reconstruction/b.cpp "hexoderm/io/open_file.h"
core/io/d.cpp "../graph/skin_graph.h"
core/graph/c.cpp "hexoderm/device/skinwire/codec.h"
core/io/a.h <pugixml.hpp>
core/io/b.h <assimp/scene.h>
core/util/c.h <fmt/format.h>
core/reconstruction/a.h <ceres/ceres.h>
widgets/a.cpp <ceres/ceres.h>
widgets/a.h <sqlite3.h>
widgets/b.cpp <boost/graph/adjacency_list.hpp>
widgets/c.cpp "app/window/main_window.h"
app/cli/a.cpp <QCoreApplication>
app/cli/b.cpp <vtkNew.h>
app/cli/c.cpp "widgets/palette.h"
app/cli/d.cpp "app/window/session_controller.h"
VIOLATIONS

mkdir "$tree/core/helpers"
if bash "$check" "$tree" >/dev/null; then
  echo "Not caught: a folder in core that is no layer"
  failed=1
fi
exit $failed
