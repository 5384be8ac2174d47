#!/bin/bash
# Installs the packages of deb.sh in an empty Debian, uses them there, and removes them: nothing is left. Needs root.
# Usage: packaging/deb_test.sh [--keep]
#   --keep  leaves the Debian in build/clean-root, for a look at it
# Each step says what it took; the last line is "N passed, M failed".
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/environment.sh"

# All mounts are in a namespace of this script's own, and end with it.
if [ "${1:-}" != --in-namespace ]; then
  case "${1:-}" in
    "" | --keep) ;;
    *)
      sed -n '2,5s/^# //p' "${BASH_SOURCE[0]}" >&2
      exit 2
      ;;
  esac
  "$root/packaging/setup.sh" --debian
  exec unshare --mount --propagation private "${BASH_SOURCE[0]}" --in-namespace "$@"
fi
shift

clean="$root/build/clean-root"
log="$root/build/deb-test.log"
packages="$root/out/deb"
ls "$packages"/hexoderm_*.deb >/dev/null || { echo "packaging/deb.sh makes the packages" >&2; exit 1; }
. /etc/os-release
mirror="$(apt-get indextargets --format '$(SITE)' 'Created-By: Packages' "Codename: $VERSION_CODENAME" | head -n 1)"

passed=0
failed=0
: >"$log"
# step WHAT COMMAND...: without the first step all that follow would fail, so one that fails ends the test.
step() {
  local what="$1" start end
  shift
  start="$(date +%s%N)"
  echo "== $what" >>"$log"
  if "$@" >>"$log" 2>&1; then
    end="$(date +%s%N)"
    passed=$((passed + 1))
    printf '%6d.%d s  %s\n' $(((end - start) / 1000000000)) $(((end - start) / 100000000 % 10)) "$what"
  else
    failed=$((failed + 1))
    echo "FAILED: $what; build/deb-test.log says:"
    tail -n 30 "$log"
    echo "$passed passed, $failed failed"
    exit 1
  fi
}
inside() {
  env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive \
    ${http_proxy:+http_proxy="$http_proxy"} chroot "$clean" bash -euo pipefail -c "$1"
}
# Of all that is installed, without what apt keeps of its own.
megabytes() { du -sxm --exclude="$clean/var/cache" --exclude="$clean/var/lib/apt" "$clean" | cut -f1; }
install() { inside "apt-get install --yes --no-install-recommends $*"; }

empty_debian() {
  rm -rf --one-file-system "$clean"
  debootstrap --variant=minbase "$VERSION_CODENAME" "$clean" "$mirror"
  mount -t proc proc "$clean/proc"
  mount --rbind /dev "$clean/dev"
  cp /etc/resolv.conf "$clean/etc/"
  mkdir "$clean/packages"
  cp "$packages"/*.deb "$clean/packages"
}
rm_all() { [ "${1:-}" = --keep ] || { umount -R "$clean/dev" "$clean/proc" && rm -rf --one-file-system "$clean"; }; }

use_command_line() {
  inside 'mkdir -p /root/work; cd /root/work
    hexoderm-cli --version
    hexoderm-cli simulate --patch x17 --surface cylinder:r=0.0501 --poses 3 -o arm.session.json
    hexoderm-cli solve arm.session.json -o arm.calibration.json
    hexoderm-cli export arm.calibration.json --to urdf,csv,gltf -o for_the_robot
    grep -q "<robot" for_the_robot/*.urdf
    hexoderm-cli capture --source "sim:x17?speed=max" --auto --poses 4 -o live.hexo'
}
use_demo_robot() {
  inside 'cd /root/work; hexoderm-cli simulate --robot demo --poses 8 -o robot.session.json
    hexoderm-cli links robot.session.json --robot demo || [ $? -eq 1 ]'
}
use_emulator() {
  inside 'cd /root/work; hexoderm-emulator --tcp 0 --speed 20 </dev/null >emulator.txt &
    emulator=$!
    trap "kill $emulator" EXIT
    until [ -s emulator.txt ]; do sleep 0.1; done
    read -r _ _ address <emulator.txt
    hexoderm-cli capture --source "$address" --auto --poses 3 -o wire.hexo'
}
open_window() {
  inside 'cd /root/work; export QT_QPA_PLATFORM=xcb LIBGL_ALWAYS_SOFTWARE=1
    xvfb-run -a -s "-screen 0 1600x1000x24" hexoderm --demo --poses 3 --screenshot window.png
    [ "$(stat -c %s window.png)" -gt 50000 ]'
}
# A session is known by what is in it, whatever it is called, and another database is none.
know_sessions() {
  inside 'cd /root/work; cp live.hexo nameless
    type_of() { gio info -a standard::content-type "$1" | sed -n "s/.*content-type: //p"; }
    [ "$(type_of live.hexo)" = application/x-hexoderm-session ]
    [ "$(type_of nameless)" = application/x-hexoderm-session ]
    printf "SQLite format 3\0" >other; head -c 4096 /dev/zero >>other
    [ "$(type_of other)" = application/vnd.sqlite3 ]
    [ "$(gio mime application/x-hexoderm-session | head -n 1 | grep -c hexoderm.desktop)" = 1 ]'
}
help_is_installed() {
  inside 'for page in hexoderm hexoderm-cli hexoderm-cli-solve hexoderm-emulator; do
      zcat "/usr/share/man/man1/$page.1.gz" | grep -q "^\.SH OPTIONS"
    done
    . /usr/share/bash-completion/completions/hexoderm-cli
    COMP_WORDS=(hexoderm-cli sol); COMP_CWORD=1; _hexoderm_cli; [ "${COMPREPLY[*]}" = solve ]'
}
# Compiled with other instructions than the library, too; these are run where the processor has them.
use_library() {
  local flags="$1" run=build/consumer
  [ -z "$flags" ] || grep -qw "${flags#-m}" /proc/cpuinfo || run="echo not run: the processor lacks ${flags#-m}:"
  rm -rf "$clean/root/consumer"
  cp -r "$root/tests/consumer" "$clean/root/consumer"
  inside "cd /root/consumer
    cmake -G Ninja -D CMAKE_BUILD_TYPE=Release -D CMAKE_CXX_FLAGS='$flags' -B build
    cmake --build build
    $run"
}
use_python() { inside 'python3 -c "import hexoderm; print(hexoderm.__file__)"'; }
remove_all() {
  inside 'dpkg-query -W -f "\${Package}\n" "*hexoderm*" | xargs apt-get purge --yes
    rm -rf /root /packages
    ! find / -xdev -iname "*hexoderm*" -not -path "/proc/*" -not -path "/dev/*" | grep .
    ! grep -rIl hexoderm /usr/share/mime /usr/share/applications /etc/ld.so.cache /var/lib/dpkg/status /etc | grep .'
}

step "an empty Debian ($VERSION_CODENAME)" empty_debian
step "lists of its packages" inside "apt-get update"
before="$(megabytes)"
step "window, command line and emulator installed, with all that they need" install "/packages/hexoderm_*.deb /packages/hexoderm-data_*.deb"
echo "          $(($(megabytes) - before)) MB more on the disk than the $before MB of an empty Debian"
step "a skin simulated, solved, exported and captured on the command line" use_command_line
step "the demo robot found" use_demo_robot
step "the emulated device captured over TCP" use_emulator
step "man pages and completion" help_is_installed
step "what a desktop has installed, and a virtual display" install xvfb xauth desktop-file-utils libglib2.0-bin shared-mime-info
step "the window shows the demo" open_window
step "sessions known by their contents" know_sessions
step "library, development files and a compiler installed" install "/packages/lib*.deb g++ cmake ninja-build pkg-config"
step "another program compiled with the library, and run" use_library ""
step "the same with -mavx2" use_library -mavx2
if ls "$packages"/python3-hexoderm_*.deb >/dev/null 2>&1; then
  step "the Python module installed" install "/packages/python3-*.deb"
  step "the Python module used" use_python
fi
step "all removed, and nothing left" remove_all
rm_all "$@"
echo "$passed passed, $failed failed"
