#!/bin/bash
# Fails unless the top level of the project holds exactly what it should: these names, names with a dot in front, and
# what .gitignore leaves out of the project. Usage: top_level.sh ROOT
set -euo pipefail
expected="CHANGELOG.md CMakeLists.txt CMakePresets.json LICENSE README.md app core packaging resources tests widgets"
ignored="build out CMakeUserPresets.json compile_commands.json"

cd "$1"
failed=0
for name in *; do
  [[ " $expected $ignored " == *" $name "* || "$name" == *.user ]] || { echo "$name does not belong there"; failed=1; }
done
for name in $expected; do
  [ -e "$name" ] || { echo "$name is missing"; failed=1; }
done
exit $failed
