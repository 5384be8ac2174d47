#!/bin/bash
# Builds the fuzz targets with clang's libFuzzer and sanitizers and runs each, one after the other, beginning with its
# corpus. Prints what crashed, with the input's path, and fails; or says how long each was clean.
# New inputs are kept in build/fuzz/found/TARGET, where the next run goes on; crashes in build/fuzz/crashes.
# Usage: tests/fuzz/fuzz.sh [--minutes N] [TARGET...]      default: 10 minutes each of all of them
set -euo pipefail
cd "$(dirname "$0")/../.."
all=(skinwire skinwire_device session_json calibration_json hexo tum_xml urdf mesh joint_angles_csv)
minutes=10
targets=()
while [ $# -gt 0 ]; do
  case "$1" in
    --minutes) minutes="${2:?--minutes needs a number}"; shift 2 ;;
    *)
      [[ " ${all[*]} " != *" $1 "* ]] || { targets+=("$1"); shift; continue; }
      echo "usage: $0 [--minutes N] [TARGET...]; targets: ${all[*]}" >&2
      exit 2
      ;;
  esac
done
[[ "$minutes" =~ ^[0-9]+$ && "$minutes" -gt 0 ]] || { echo "--minutes: expected a whole number above 0" >&2; exit 2; }
[ ${#targets[@]} -gt 0 ] || targets=("${all[@]}")
command -v clang++ >/dev/null || { echo "clang++ is missing: packaging/setup.sh --developer" >&2; exit 1; }

cmake --preset fuzz >/dev/null
cmake --build --preset fuzz --target hexoderm_fuzzers

failed=0
for target in "${targets[@]}"; do
  found="build/fuzz/found/$target"
  mkdir -p "$found" build/fuzz/crashes
  dictionary="tests/fuzz/${target/calibration/session}.dict"
  log="build/fuzz/$target.log"
  options=(-max_total_time=$((minutes * 60)) -max_len=16384 -timeout=25 -rss_limit_mb=2048 -malloc_limit_mb=256
           -print_final_stats=1 "-artifact_prefix=build/fuzz/crashes/$target-")
  [ ! -f "$dictionary" ] || options+=("-dict=$dictionary")
  echo "$target: $minutes min ..."
  if ASAN_OPTIONS=detect_leaks=1 "build/fuzz/tests/fuzz/fuzz_$target" "${options[@]}" "$found" "tests/fuzz/corpus/$target" \
      >"$log" 2>&1; then
    runs="$(sed -n 's/^stat::number_of_executed_units: *//p' "$log")"
    echo "$target: clean, $minutes min, $runs runs"
  else
    failed=1
    echo "$target: FAILED; the end of $log:"
    tail -n 40 "$log"
  fi
done
exit $failed
