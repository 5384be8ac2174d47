#!/bin/bash
# Installs the Debian packages that are missing; does nothing, quickly, if none is.
# Usage: packaging/setup.sh [--core] [--tests] [--ros] [--sanitizers] [--developer] [--debian]
#   --core       only what library and command line need: neither Qt nor VTK
#   --tests      also the other programs that the tests run
#   --ros        also ROS 1, for hexoderm-ros
#   --sanitizers also clang, for the presets asan and tsan
#   --developer  --tests and --sanitizers, and clang-tidy, clang-format and Google Benchmark
#   --debian     also what makes Debian packages and tries them
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/packages.sh"

gui=yes
tests=no
ros=no
sanitizers=no
developer=no
debian=no
for argument in "$@"; do
  case "$argument" in
    --core) gui=no ;;
    --tests) tests=yes ;;
    --ros) ros=yes ;;
    --sanitizers) sanitizers=yes ;;
    --developer)
      developer=yes
      sanitizers=yes
      tests=yes
      ;;
    --debian) debian=yes ;;
    *)
      sed -n '2,9s/^# //p' "${BASH_SOURCE[0]}" >&2
      exit 2
      ;;
  esac
done
wanted=("${core_packages[@]}")
[ "$gui" = no ] || wanted+=("${gui_packages[@]}")
[ "$tests" = no ] || wanted+=("${test_packages[@]}")
[ "$ros" = no ] || wanted+=("${ros_packages[@]}")
[ "$sanitizers" = no ] || wanted+=("${sanitizer_packages[@]}")
[ "$developer" = no ] || wanted+=("${developer_packages[@]}")
[ "$debian" = no ] || wanted+=("${debian_packages[@]}")

if ! command -v dpkg-query >/dev/null; then
  echo "setup: this is not Debian, so nothing is installed. Hexoderm needs what these packages hold: ${wanted[*]}" >&2
  exit 0
fi

# A package that was never installed is unknown to dpkg-query, which then exits with 1: that is no error here.
installed=" $({ dpkg-query -W -f '${db:Status-Status} ${Package}\n' "${wanted[@]}" 2>/dev/null || true; } |
  sed -n 's/^installed //p' | tr '\n' ' ')"
missing=()
for package in "${wanted[@]}"; do
  [[ "$installed" == *" $package "* ]] || missing+=("$package")
done
[ ${#missing[@]} -gt 0 ] || exit 0

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  if ! command -v sudo >/dev/null; then
    echo "setup: these packages are missing, and installing them needs root or sudo. As root, run:" >&2
    echo "  apt-get install --no-install-recommends ${missing[*]}" >&2
    exit 1
  fi
  as_root=(sudo)
fi
echo "setup: installing ${missing[*]}"
as_root+=(env DEBIAN_FRONTEND=noninteractive)
"${as_root[@]}" apt-get update
"${as_root[@]}" apt-get install --yes --no-install-recommends "${missing[@]}"
