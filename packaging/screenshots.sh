#!/bin/bash
# Pictures of the real window in every step and of its dialogs, light and dark, at 1280x800 and 1920x1080, English and
# German. Fails if a text is cut off anywhere, and says which.
# Usage: packaging/screenshots.sh [DIR]     (default: out/screenshots)
#        packaging/screenshots.sh --guide   makes the pictures of the user guide and of the README anew, in resources
# HEXODERM_SCREENSHOTS: the program that takes them (default: that of the preset release, which is built first)
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/environment.sh"

program="${HEXODERM_SCREENSHOTS:-}"
if [ -z "$program" ]; then
  cd "$root"
  cmake --preset release >/dev/null
  cmake --build --preset release --parallel "$jobs" --target hexoderm-screenshots >/dev/null
  program="$root/build/release/tests/screenshots/hexoderm-screenshots"
fi

# On a virtual display that the larger window fits on, without the user's settings and unsaved sessions.
home="$(mktemp -d)"
trap 'rm -rf "$home"' EXIT
mkdir -m 700 "$home/runtime"
tour() {
  local folder="$1" language="$2" theme="$3" size="$4"
  shift 4
  env -u WAYLAND_DISPLAY -u QT_STYLE_OVERRIDE -u QT_SCALE_FACTOR QT_QPA_PLATFORM=xcb LIBGL_ALWAYS_SOFTWARE=1 \
    XDG_CONFIG_HOME="$home/config" XDG_DATA_HOME="$home/data" XDG_CACHE_HOME="$home/cache" \
    XDG_RUNTIME_DIR="$home/runtime" \
    xvfb-run --auto-servernum --server-args="-screen 0 2000x1200x24 -dpi 96 -nolisten tcp" \
    "$program" --language "$language" --theme "$theme" --size "$size" "$@" "$folder"
}

if [ "${1:-}" = --guide ]; then
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

out="$(realpath -m "${1:-$root/out/screenshots}")"
mkdir -p "$out"
failed=0
for language in en de; do
  for theme in light dark; do
    for size in 1280x800 1920x1080; do
      echo "== $language, $theme, $size"
      tour "$out" "$language" "$theme" "$size" || failed=1
    done
  done
done
echo "$(find "$out" -name '*.png' | wc -l) pictures in $out"
exit $failed
