#!/bin/bash
# Shows that libraries.sh accepts a proper tree and catches each kind of violation, alone in that tree.
set -euo pipefail
check="$(dirname "${BASH_SOURCE[0]}")/libraries.sh"
tree="$(mktemp -d)"
trap 'rm -rf "$tree"' EXIT

mkdir -p "$tree"/core/hexoderm/{graph,io,reconstruction/result} "$tree"/{widgets/style,app/cli,app/emulator,app/python,app/window}
cat >"$tree/core/hexoderm/graph/skin.cpp" <<'CODE'
#include "hexoderm/graph/skin.h"
#include <boost/graph/adjacency_list.hpp>
#include <quadmath.h>
#include <vector>
CODE
echo '#include <Eigen/Core>' >"$tree/core/hexoderm/graph/skin.h"
echo '#include <QWidget>' >"$tree/widgets/style/view.cpp"
echo '#include <QApplication>' >"$tree/app/window/main.cpp"
echo '#include "hexoderm/io/open_file.h"' >"$tree/app/cli/main.cpp"
echo '#include <pybind11/pybind11.h>' >"$tree/app/python/module.cpp"

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
core/hexoderm/graph/a.h <QString>
core/hexoderm/io/a.cpp <QtCore/QFile>
core/hexoderm/io/c.cpp "QFile"
core/hexoderm/reconstruction/result/a.cpp <vtkPolyData.h>
core/hexoderm/io/a.h <pugixml.hpp>
core/hexoderm/io/b.h <assimp/scene.h>
core/hexoderm/io/c.h <urdf_model/model.h>
core/hexoderm/io/d.h <kdl/tree.hpp>
core/hexoderm/io/e.h <fmt/format.h>
core/hexoderm/reconstruction/a.h <ceres/ceres.h>
widgets/style/a.cpp <ceres/ceres.h>
widgets/style/a.h <sqlite3.h>
widgets/b.cpp <boost/graph/adjacency_list.hpp>
app/cli/a.cpp <QCoreApplication>
app/cli/b.cpp <vtkNew.h>
app/emulator/a.cpp <QSocketNotifier>
app/python/a.cpp <QObject>
app/cli/c.cpp <pybind11/stl.h>
core/hexoderm/io/f.cpp <Python.h>
VIOLATIONS

rm -r "$tree/app/cli"
if bash "$check" "$tree" >/dev/null 2>&1; then
  echo "Not caught: a folder that is no longer where the check looks"
  failed=1
fi
exit $failed
