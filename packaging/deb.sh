#!/bin/bash
# Makes Debian packages of the programs, the library, the Python module and hexoderm-ros in out/deb, and has
# lintian look at them.
# Usage: packaging/deb.sh
# DEBFULLNAME and DEBEMAIL name who answers for the packages.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/environment.sh"
if [ $# -gt 0 ]; then
  sed -n '2,5s/^# //p' "${BASH_SOURCE[0]}" >&2
  exit 2
fi

"$root/packaging/setup.sh" --debian
cd "$root"
# What has a date in the packages has that of the commit.
SOURCE_DATE_EPOCH="${SOURCE_DATE_EPOCH:-$(git log -1 --format=%ct 2>/dev/null || stat -c %Y CHANGELOG.md)}"
export SOURCE_DATE_EPOCH

maintainer=()
[ -z "${DEBEMAIL:-}" ] || maintainer=(-D "HEXODERM_MAINTAINER=${DEBFULLNAME:-The Hexoderm authors} <$DEBEMAIL>")
# hexoderm-ros needs ROS where it is used, not here.
cmake --preset release -D "CMAKE_INSTALL_LIBDIR=lib/$(dpkg-architecture -qDEB_HOST_MULTIARCH)" \
  -D HEXODERM_PYTHON=ON -D HEXODERM_ROS=ON "${maintainer[@]}" >/dev/null
cmake --build --preset release --parallel "$jobs" --target hexoderm_installed hexoderm_api

rm -rf out/deb
mkdir -p out/deb
cpack -G DEB --config build/release/CPackConfig.cmake -B out/deb
rm -rf out/deb/_CPack_Packages
lintian --fail-on error --allow-root out/deb/*.deb
echo "The packages are in out/deb:"
ls -sh1 out/deb
