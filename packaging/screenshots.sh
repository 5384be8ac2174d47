#!/bin/bash
# Pictures of the real window in every step and of its dialogs, light and dark, English and German, at sizes from
# 1024x768 to 2560x1440, with text of 150 % and on a screen of scale 200 %. Fails if a text is cut off or lies over
# another anywhere, if anything scrolls sideways or if the window is larger than it should be, and says where.
# Usage: packaging/screenshots.sh [--language L]... [--theme T]... [--look L]... [DIR]     (default: out/screenshots)
#            L: en, de; T: light, dark; a look is a size (1280x800), one with larger text (1280x800-text150) or on a
#            denser screen (1280x800-scale200). What is not named is all there is.
#        packaging/screenshots.sh --guide   makes the pictures of the user guide and of the README anew, in resources
# HEXODERM_SCREENSHOTS: the program that takes them (default: that of the preset release, which is built first)
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/environment.sh"

languages=()
themes=()
looks=()
guide=no
dir=""
while [ $# -gt 0 ]; do
  case "$1" in
    --language) languages+=("$2"); shift 2 ;;
    --theme) themes+=("$2"); shift 2 ;;
    --look) looks+=("$2"); shift 2 ;;
    --guide) guide=yes; shift ;;
    -*) echo "unknown option $1; see the head of ${BASH_SOURCE[0]}" >&2; exit 2 ;;
    *) dir="$1"; shift ;;
  esac
done
[ ${#languages[@]} -gt 0 ] || languages=(en de)
[ ${#themes[@]} -gt 0 ] || themes=(light dark)
[ ${#looks[@]} -gt 0 ] || looks=(1024x768 1366x768 1280x800 1920x1080 2560x1440 1280x800-text150 1280x800-scale200)

program="${HEXODERM_SCREENSHOTS:-}"
if [ -z "$program" ]; then
  cd "$root"
  cmake --preset release >/dev/null
  cmake --build --preset release --parallel "$jobs" --target hexoderm-screenshots >/dev/null
  program="$root/build/release/tests/screenshots/hexoderm-screenshots"
fi

# On a virtual display that the largest window fits on, without the user's settings and unsaved sessions.
home="$(mktemp -d)"
trap 'rm -rf "$home"' EXIT
mkdir -m 700 "$home/runtime"
tour() {
  local folder="$1" language="$2" theme="$3" look="$4"
  shift 4
  local size="${look%%-*}" text=100 scale=1
  case "$look" in
    *-text*) text="${look##*-text}" ;;
    *-scale*) scale="$(awk "BEGIN { print ${look##*-scale} / 100 }")" ;;
  esac
  env -u WAYLAND_DISPLAY -u QT_STYLE_OVERRIDE QT_SCALE_FACTOR="$scale" QT_QPA_PLATFORM=xcb LIBGL_ALWAYS_SOFTWARE=1 \
    XDG_CONFIG_HOME="$home/config" XDG_DATA_HOME="$home/data" XDG_CACHE_HOME="$home/cache" \
    XDG_RUNTIME_DIR="$home/runtime" \
    xvfb-run --auto-servernum --server-args="-screen 0 2880x1760x24 -dpi 96 -nolisten tcp" \
    "$program" --language "$language" --theme "$theme" --size "$size" --text "$text" "$@" "$folder"
}

if [ "$guide" = yes ]; then
  images="$root/resources/guide/images"
  for language in en de; do
    made="$home/$language"
    tour "$made" "$language" light 1280x800 --width 760 || echo "see above; the pictures are made all the same"
    cp "$made"/*-second-pose.png "$images/$language-capture.png"
    cp "$made"/*-done-step4.png "$images/$language-review.png"
    last="$(find "$made" -name '*-done-step*.png' | sort -V | tail -1)"
    cp "$last" "$images/$language-done.png"
  done
  for theme in light dark; do
    made="$home/$theme"
    tour "$made" en "$theme" 1440x900 || echo "see above; the pictures are made all the same"
    cp "$made"/*-second-pose.png "$root/resources/screenshots/window-$theme.png"
  done
  ls -l "$images" "$root/resources/screenshots"
  exit 0
fi

out="$(realpath -m "${dir:-$root/out/screenshots}")"
mkdir -p "$out"
failed=0
for language in "${languages[@]}"; do
  for theme in "${themes[@]}"; do
    for look in "${looks[@]}"; do
      echo "== $language, $theme, $look"
      tour "$out" "$language" "$theme" "$look" || failed=1
    done
  done
done
echo "$(find "$out" -name '*.png' | wc -l) pictures in $out"
exit $failed
