#!/bin/bash
# Installs the packages of deb.sh in an empty Debian, uses them there, and removes them: nothing is left. Needs root.
# Usage: packaging/deb_test.sh [--keep] [12|13]
#   12, 13  the packages that `packaging/in_debian.sh RELEASE packaging/deb.sh` made, in that release; without a number
#           those that deb.sh made, in the release that runs
#   --keep  leaves the Debian in build/clean-root, for a look at it
# The commands of the README's section on packages are run as they stand there, in the folder with the packages. Each
# step says what it took; the last line is "N passed, M failed".
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/environment.sh"
source "$root/packaging/clean_debian.sh"

arguments=("$@")
keep=no
[ "${1:-}" != --keep ] || { keep=yes; shift; }
release="${1:-}"
packages="$root/out/${release:+debian-$release/}deb"
[ -n "$release" ] || release="$(. /etc/os-release && echo "${VERSION_ID:-}")"
if [ $# -gt 1 ] || [ -z "${debian_names[$release]:-}" ]; then
  sed -n '2,8s/^# //p' "${BASH_SOURCE[0]}" >&2
  exit 2
fi
ls "$packages"/hexoderm_*.deb >/dev/null || { echo "packaging/deb.sh makes the packages" >&2; exit 1; }

if [ "${HEXODERM_IN_NAMESPACE:-}" != yes ]; then
  "$root/packaging/setup.sh" --debian
  HEXODERM_IN_NAMESPACE=yes exec unshare --mount --propagation private "${BASH_SOURCE[0]}" "${arguments[@]}"
fi

clean="$root/build/clean-root"
log="$root/build/deb-test.log"
mkdir -p "$root/build"

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
inside() { inside_debian "$clean" "$@"; }
# Of all that is installed, without what apt keeps of its own.
megabytes() { du -sxm --exclude="$clean/var/cache" --exclude="$clean/var/lib/apt" "$clean" | cut -f1; }
install() { inside "apt-get install --no-install-recommends $*"; }
# The lines below a comment of the README: those that install ("install"), or the others ("use").
typed() {
  local commands choose=(grep)
  [ "$2" = install ] || choose+=(-v)
  commands="$(awk -v what="# $1" '/^(# |```|$)/ { on = index($0, what) == 1; next } on' "$root/README.md" |
    "${choose[@]}" '^apt-get install')" || { echo "README.md has no commands to $2 \"$1\""; return 1; }
  echo "$commands"
  inside "cd /packages; $commands"
}

empty_debian() {
  make_clean_debian "$release" "$clean"
  mkdir "$clean/packages"
  cp "$packages"/*.deb "$clean/packages"
}

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
use_programs() { typed "The programs" use && grep -q '<robot' "$clean/packages/live.urdf"; }
# A picture, and not an empty one.
is_picture() {
  [[ "$(file -b "$1")" =~ ^"PNG image data, "([0-9]+)" x "([0-9]+) ]] || { file "$1"; return 1; }
  [ "${BASH_REMATCH[1]}" -ge 600 ] && [ "${BASH_REMATCH[2]}" -ge 400 ] && [ "$(stat -c %s "$1")" -gt 50000 ]
}
use_window() { typed "The window without a display" use && is_picture "$clean/packages/demo.png"; }
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
    COMP_WORDS=(hexoderm-cli sol); COMP_CWORD=1; _hexoderm; [ "${COMPREPLY[*]}" = solve ]'
}
ros_help_is_installed() {
  inside 'zcat /usr/share/man/man1/hexoderm-ros-skin.1.gz | grep -q "^\.SH OPTIONS"
    . /usr/share/bash-completion/completions/hexoderm-ros
    COMP_WORDS=(hexoderm-ros tr); COMP_CWORD=1; _hexoderm; [ "${COMPREPLY[*]}" = transforms ]
    grep -q cell_data /usr/share/doc/hexoderm-ros/README.md
    grep -q imu /usr/share/doc/hexoderm-ros/examples/skin.json'
}
# Compiled with other instructions than the library, too; these are run where the processor has them.
use_library() {
  local flags="$1" run=build/consumer
  [ -z "$flags" ] || grep -qw "${flags#-m}" /proc/cpuinfo || run="echo not run: the processor lacks ${flags#-m}:"
  rm -rf "$clean/root/consumer"
  cp -r "$root/tests/consumer" "$clean/root/consumer"
  inside "cd /root/consumer
    cmake -D CMAKE_BUILD_TYPE=Release -D CMAKE_CXX_FLAGS='$flags' -B build
    cmake --build build
    $run"
}
use_example() { rm -f "$clean/packages/live.urdf" && typed "$1" use && grep -q '<robot' "$clean/packages/live.urdf"; }
use_python() { typed "A notebook's script" use && is_picture "$clean/packages/skin.png"; }
use_firmware() {
  local code=0 board="$clean/tmp/firmware/pid"
  typed "A skin's firmware" use || code=$?
  [ ! -e "$board" ] || kill "$(cat "$board")" || true  # where a command before the last one failed
  [ "$code" -eq 0 ] && inside "hexoderm-cli inspect /packages/cells.calibration.json --json" | grep -q '"cells": 7'
}
# What is calibrated comes out of ROS, each frame of it.
use_ros() {
  local frames
  typed "Frames in ROS 1" use
  frames="$(grep -c child_frame_id "$clean/packages/live.tf.yaml")"
  [ "$frames" -gt 1 ] && [ "$(grep -c child_frame_id "$clean/packages/frames.txt")" = "$frames" ]
}
remove_all() {
  inside 'dpkg-query -W -f "\${Package}\n" "*hexoderm*" | xargs apt-get purge --yes
    rm -rf /root /packages /tmp/firmware
    ! find / -xdev -iname "*hexoderm*" -not -path "/proc/*" -not -path "/dev/*" | grep .
    ! grep -rIl hexoderm /usr/share/mime /usr/share/applications /etc/ld.so.cache /var/lib/dpkg/status /etc | grep .'
}

step "an empty Debian $release" empty_debian
step "lists of its packages" inside "apt-get update"
before="$(megabytes)"
step "the programs installed, with all that they need" typed "The programs" install
echo "          $(($(megabytes) - before)) MB more on the disk than the $before MB of an empty Debian"
step "the demo skin captured, solved and exported" use_programs
step "a skin simulated, solved, exported and captured on the command line" use_command_line
step "the demo robot found" use_demo_robot
step "the emulated device captured over TCP" use_emulator
step "man pages and completion" help_is_installed
step "a virtual display installed" typed "The window without a display" install
step "the window shows the demo" use_window
step "what a desktop has installed" install desktop-file-utils libglib2.0-bin shared-mime-info
step "sessions known by their contents" know_sessions
step "the Python module installed, and Matplotlib" typed "A notebook's script" install
step "a notebook's script run, to its picture" use_python
step "a compiler for microcontrollers and an emulated board installed" typed "A skin's firmware" install
step "the example firmware compiled, and captured from the board" use_firmware
step "hexoderm-ros installed, and a master of ROS" typed "Frames in ROS 1" install
step "its man pages, completion and example" ros_help_is_installed
step "a calibration published as frames of TF" use_ros
step "library, development files and a compiler installed" typed "A C++ program" install
step "the example compiled with the library, and run" use_example "A C++ program"
if grep -qw avx2 /proc/cpuinfo; then
  step "the same with -mavx2" use_example "The same with -mavx2"
else
  echo "          not run with -mavx2: the processor lacks it"
fi
step "another program with all headers compiled, and run" use_library ""
step "the same with -mavx2" use_library -mavx2
step "all removed, and nothing left" remove_all
[ $keep = yes ] || remove_clean_debian "$clean"
echo "$passed passed, $failed failed"
