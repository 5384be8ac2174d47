#!/bin/bash
# Fails if an installed header names a library that users of Hexoderm need not know, or a header that is not installed.
# Usage: installed_headers.sh INCLUDE_FOLDER
set -euo pipefail
cd "$1"
failed=0

foreign='^[[:space:]]*#[[:space:]]*include[[:space:]]*[<"](boost|nlohmann|assimp|fmt|openssl|ceres|google|pugi|sqlite|CLI|urdf|kdl|console_bridge|Q|vtk)'
if grep -rnE "$foreign" hexoderm; then
  echo "These includes are in installed headers; core/CMakeLists.txt lists which those are"
  failed=1
fi
if grep -rnE '\b(boost|fmt|nlohmann|pugi|Assimp|ceres|urdf|KDL)::' hexoderm; then
  echo "These types are in installed headers"
  failed=1
fi
while IFS=: read -r header include; do
  included="$(sed -E 's/.*"(.*)".*/\1/' <<<"$include")"
  [ -f "$included" ] || { echo "$header includes \"$included\", which is not installed"; failed=1; }
done < <(grep -roE '#include "[^"]*"' hexoderm)
while read -r header; do
  [ "$header" = hexoderm/hexoderm.h ] || grep -qxF "#include \"$header\"" hexoderm/hexoderm.h ||
    { echo "hexoderm/hexoderm.h does not include $header"; failed=1; }
done < <(find hexoderm -name '*.h')
[ "$(find hexoderm -name '*.h' | wc -l)" -gt 0 ] || { echo "no headers are installed"; failed=1; }
exit $failed
