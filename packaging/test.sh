#!/bin/bash
# Sets up, builds and runs all tests; the last line is "N passed, M failed".
# Usage: packaging/test.sh [--quick | --window-asan | STAGE ...]
#   (nothing)      release: library, command line, window; core: that it builds without Qt and VTK, and that other programs
#                  can use it; asan: core under the address and undefined-behaviour sanitizers; tsan: what runs on several
#                  threads under the thread sanitizer
#   --quick        release alone
#   --window-asan  the window and its tests under the address sanitizer, alone: half an hour and more
#   STAGE ...      these of the stages release, core, asan, tsan and window-asan
# In CI (the variable CI is set) a compiler's warning is an error.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/environment.sh"

stages=(release core asan tsan)
case "${1:-}" in
  "") ;;
  --quick) stages=(release) ;;
  --window-asan) stages=(window-asan) ;;
  *) stages=("$@") ;;
esac
for stage in "${stages[@]}"; do
  case "$stage" in
    release | core | asan | tsan | window-asan) ;;
    *)
      sed -n '2,10s/^# //p' "${BASH_SOURCE[0]}" >&2
      exit 2
      ;;
  esac
done

"$root/packaging/setup.sh" --tests --ros
cd "$root"

# Tests must neither read nor change what the user has set.
home="$root/build/test-home"
rm -rf "$home"
mkdir -p "$home/runtime"
chmod 700 "$home/runtime"
test_environment=(XDG_CONFIG_HOME="$home/config" XDG_DATA_HOME="$home/data" XDG_RUNTIME_DIR="$home/runtime"
  UBSAN_OPTIONS=print_stacktrace=1)

# Whether other programs can use the library is tried without Qt and VTK: in the stage core.
by_others='^structure\.(install|installed_|consumer_|public_types_|abi_)'

passed=0
failed=0
with_failures=()  # results that name tests which did not pass
# Builds and tests one preset, and adds its tests to the counts. A stage that can't be built counts as one failure.
run_stage() {
  local preset="$1" targets=() select=() display=env results="$root/build/$1/test-results.xml" start=$SECONDS ok
  case "$preset" in
    release)
      display=on_virtual_display  # the others have no windows
      [ ${#stages[@]} -eq 1 ] || targets=(--target all hexoderm_benchmarks)
      select=(--exclude-regex "$by_others")
      ;;
    core)
      targets=(--target hexoderm_installed)
      select=(--tests-regex "$by_others|links_no_gui$")
      ;;
    asan)
      # What these count over many seeds runs the same code as the tests beside them.
      local counts='StatedDeviationAgrees|ErrsAsMuchAsExpectedInTheMedian|LieWithinTheirRangesAsOften|KnownSigmasLie'
      counts+='|SeveralSkinsNarrow|UncertaintyAndDetectionAreCounted|AccuracyTableIsWhole'
      # The house's rules are looked at in the stages before.
      select=(--exclude-regex "$counts|^structure\.")
      ;;
    tsan)
      targets=(--target hexoderm_threaded_tests)
      select=(--label-regex '^threads$')
      ;;
    window-asan)
      display="on_virtual_display env ASAN_OPTIONS=detect_leaks=0"  # graphics drivers leak
      targets=(--target hexoderm_window_tests)
      select=(--label-regex '^window$')
      ;;
  esac
  rm -f "$results"
  echo "== $preset"
  if ! cmake --preset "$preset" ${CI:+-DHEXODERM_WERROR=ON} >"$root/build/configure.log" 2>&1; then
    cat "$root/build/configure.log"
    echo "== $preset: could not be configured"
    failed=$((failed + 1))
    return
  fi
  grep -A4 'CMake Warning' "$root/build/configure.log" || true
  if ! cmake --build --preset "$preset" --parallel "$jobs" "${targets[@]}"; then
    echo "== $preset: could not be built"
    failed=$((failed + 1))
    return
  fi
  local built=$((SECONDS - start))
  ok=yes
  # One more than there are cores: tests of windows, of which one runs at a time, wait for the window most of the time.
  $display env "${test_environment[@]}" ctest --preset "$preset" "${select[@]}" --parallel "$((jobs + 1))" \
    --output-junit "$results" || ok=no

  local all=0 run=0
  if [ -f "$results" ]; then
    all=$(grep -c '<testcase ' "$results" || true)
    run=$(grep -c '<testcase .*status="run"' "$results" || true)
  fi
  # A test that did not run, for whatever reason, has not passed.
  passed=$((passed + run))
  failed=$((failed + all - run))
  [ "$all" -eq "$run" ] || with_failures+=("$results")
  if [ $ok = no ] && [ "$all" -eq "$run" ]; then
    echo "== $preset: ctest failed before or after its tests"
    failed=$((failed + 1))
  fi
  echo "== $preset: $run of $all passed, $((SECONDS - start)) s, of which $built s to build"
}

mkdir -p build
for stage in "${stages[@]}"; do
  run_stage "$stage"
done

# Once more at the end: a stage's own words are thousands of lines above.
[ ${#with_failures[@]} -eq 0 ] || "$root/packaging/failed_tests.py" "${with_failures[@]}"

unregistered="$(cat build/release/tests/unregistered_tests.txt 2>/dev/null || echo 0)"
if [ "$unregistered" -gt 0 ]; then
  echo "$unregistered tests are not registered, because the reference data (HEXODERM_REFERENCE_DATA) is absent"
fi
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
