# Sourced by the scripts: the project's folder, the number of jobs, and the display.

root="$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)"
jobs="$(nproc)"
export LC_ALL=C.UTF-8

# With these, one ccache serves every build folder and every clone.
export CCACHE_BASEDIR="$root" CCACHE_NOHASHDIR=1

# VTK's windows need X11, also under Wayland (through Xwayland, which sets DISPLAY). A local DISPLAY without a socket is
# left over from somewhere else.
has_display() {
  [ -n "${DISPLAY:-}" ] || return 1
  [[ "$DISPLAY" =~ ^(unix)?:([0-9]+) ]] || return 0
  local socket="/tmp/.X11-unix/X${BASH_REMATCH[2]}"
  [ -S "$socket" ] || grep -qsF "@$socket" /proc/net/unix
}

# Runs a command on a virtual display of its own, drawn in software, so that it looks the same on every machine.
on_virtual_display() {
  local folder server status=0
  folder="$(mktemp -d)"
  mkfifo "$folder/number"
  Xvfb -displayfd 3 -screen 0 1600x1000x24 -nolisten tcp -noreset 3>"$folder/number" 2>"$folder/log" &
  server=$!
  local number=""
  read -r number <"$folder/number" || { cat "$folder/log" >&2; echo "Xvfb does not start" >&2; return 1; }
  env -u WAYLAND_DISPLAY -u XAUTHORITY -u QT_STYLE_OVERRIDE -u QT_SCALE_FACTOR DISPLAY=":$number" \
    QT_QPA_PLATFORM="${QT_QPA_PLATFORM:-xcb}" LIBGL_ALWAYS_SOFTWARE=1 "$@" || status=$?
  kill "$server"
  wait "$server" 2>/dev/null || true
  rm -r "$folder"
  return $status
}
