#!/bin/bash
# Runs a command on a clean clone of this repository in an empty Debian that is made for it. Needs root.
# Usage: packaging/in_debian.sh [--keep] 12|13 COMMAND [ARGUMENT...]
#   for example: packaging/in_debian.sh 13 packaging/test.sh
#   --keep  leaves the Debian in build/debian-RELEASE, for a look at it
# Changes that are not committed are not in the clone. The folder out/ that the command leaves there is copied to
# out/debian-RELEASE. The exit status is that of the command.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/environment.sh"
source "$root/packaging/clean_debian.sh"

arguments=("$@")
keep=no
[ "${1:-}" != --keep ] || { keep=yes; shift; }
release="${1:-}"
if [ $# -lt 2 ] || [ -z "${debian_names[$release]:-}" ]; then
  sed -n '2,7s/^# //p' "${BASH_SOURCE[0]}" >&2
  exit 2
fi
shift

if [ "${HEXODERM_IN_NAMESPACE:-}" != yes ]; then
  "$root/packaging/setup.sh" --debian
  HEXODERM_IN_NAMESPACE=yes exec unshare --mount --propagation private "${BASH_SOURCE[0]}" "${arguments[@]}"
fi

clean="$root/build/debian-$release"
start=$SECONDS
echo "== an empty Debian $release (${debian_names[$release]}) in build/debian-$release"
log="$clean.log"
mkdir -p "$root/build"
{ make_clean_debian "$release" "$clean" && git clone --quiet --no-hardlinks "$root" "$clean/root/hexoderm"; } >"$log" 2>&1 ||
  { cat "$log"; exit 1; }
echo "== made in $((SECONDS - start)) s; now $*"
start=$SECONDS
status=0
inside_debian "$clean" 'cd /root/hexoderm; "$@"' "$@" </dev/null || status=$?
echo "== $* ended with $status after $((SECONDS - start)) s"
if [ -d "$clean/root/hexoderm/out" ]; then
  rm -rf "$root/out/debian-$release"
  mkdir -p "$root/out"
  cp -r "$clean/root/hexoderm/out" "$root/out/debian-$release"
fi
[ $keep = yes ] || remove_clean_debian "$clean"
exit $status
