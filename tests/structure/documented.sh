#!/bin/bash
# Fails for a public symbol without a comment, and for a comment that Doxygen can't follow. Fields whose name and type say all
# need none; functions, types, enumerations and constants do. Usage: documented.sh DOXYGEN DOXYFILE
set -euo pipefail
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT

# problems_of [SETTING...]: what Doxygen has against the headers, or against those that are set instead. Of a template of the
# standard library that is specialised, it says that it does not know it.
problems_of() {
  {
    cat "$doxyfile"
    printf '%s\n' "OUTPUT_DIRECTORY = $folder" "WARN_LOGFILE = $folder/warnings" "GENERATE_HTML = NO" "GENERATE_XML = YES" "$@"
  } | "$doxygen" -
  grep -vE '\(variable\) of (struct|class|union) .* is not documented|Internal inconsistency: scope for class std::' \
    "$folder/warnings" || true
}
doxygen="$1"
doxyfile="$2"

# That it would be seen.
cat >"$folder/undocumented.h" <<'END'
/// Things.
namespace things {
struct Bare {
  int field = 0;
  int function();
};
/// Has a field that is given no comment.
struct Fine {
  int field = 0;
};
constexpr int kBare = 1;
int bare();
}  // namespace things
END
found="$(problems_of "INPUT = $folder/undocumented.h")"
for symbol in 'Compound things::Bare' 'function()' 'kBare' 'bare()'; do
  grep -qF "$symbol" <<<"$found" || { echo "a symbol without a comment is not seen: $symbol"; exit 1; }
done
! grep -F 'Fine' <<<"$found" || exit 1

found="$(problems_of)"
[ -z "$found" ] || { echo "$found"; exit 1; }
