#!/bin/bash
# Pictures of the real window in every step and of its dialogs, light and dark, at 1280x800 and 1920x1080, English and
# German. Fails if a text is cut off anywhere, and says which.
# Usage: packaging/screenshots.sh [DIR]     (default: out/screenshots)
# HEXODERM_WINDOW: the program to run (default: that of the preset release, which is built first)
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/environment.sh"

out="$(realpath -m "${1:-$root/out/screenshots}")"
window="${HEXODERM_WINDOW:-}"
if [ -z "$window" ]; then
  cd "$root"
  cmake --preset release >/dev/null
  cmake --build --preset release --parallel "$jobs" --target hexoderm >/dev/null
  window="$root/build/release/app/window/hexoderm"
fi
mkdir -p "$out"

# A virtual display that the larger window fits on.
failed=0
for language in en de; do
  for theme in light dark; do
    for size in 1280x800 1920x1080; do
      echo "== $language, $theme, $size"
      env -u WAYLAND_DISPLAY -u QT_STYLE_OVERRIDE -u QT_SCALE_FACTOR QT_QPA_PLATFORM=xcb LIBGL_ALWAYS_SOFTWARE=1 \
        xvfb-run --auto-servernum --server-args="-screen 0 2000x1200x24 -nolisten tcp" \
        "$window" --language "$language" --theme "$theme" --screenshots "$out" --screenshots-size "$size" || failed=1
    done
  done
done
echo "$(find "$out" -name '*.png' | wc -l) pictures in $out"
exit $failed
