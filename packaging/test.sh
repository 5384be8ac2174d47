#!/bin/bash
# Sets up, builds everything in Release and runs its tests; the last line is "N passed, M failed".
# Usage: packaging/test.sh [--all | STAGE ...]
#   --all      also: core, that it builds without Qt and VTK, and that other programs can use it; asan, what reads files,
#              devices and arguments under the address and undefined-behaviour sanitizers; tsan, what runs on several
#              threads under the thread sanitizer
#   STAGE ...  these of the stages release, core, asan, tsan, and window-asan: the window and its tests under the address
#              sanitizer
# In CI (the variable CI is set) a compiler's warning is an error.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/environment.sh"

case "${1:-}" in
  "") stages=(release) ;;
  --all) stages=(release core asan tsan) ;;
  *) stages=("$@") ;;
esac
packages=(--tests --ros)
for stage in "${stages[@]}"; do
  case "$stage" in
    release | core | window-asan) ;;
    asan | tsan) packages+=(--sanitizers) ;;
    *)
      sed -n '2,9s/^# //p' "${BASH_SOURCE[0]}" >&2
      exit 2
      ;;
  esac
done

"$root/packaging/setup.sh" "${packages[@]}"
cd "$root"

# Tests must neither read nor change what the user has set.
home="$root/build/test-home"
rm -rf "$home"
mkdir -p "$home/runtime"
chmod 700 "$home/runtime"
test_environment=(XDG_CONFIG_HOME="$home/config" XDG_DATA_HOME="$home/data" XDG_RUNTIME_DIR="$home/runtime"
  UBSAN_OPTIONS=print_stacktrace=1)

# Whether other programs can use the library is tried without Qt and VTK: in the stage core.
by_others='^structure\.(install|installed_|consumer_|public_types_)'

finished=()  # folders of stages whose tests ran
broken=0
# Builds and tests one preset. A stage that can't be built counts as one failure.
run_stage() {
  local preset="$1" targets=() select=() build="$root/build/$1" start=$SECONDS
  case "$preset" in
    release) [ ${#stages[@]} -eq 1 ] || { targets=(--target all hexoderm_benchmarks); select=(--exclude-regex "$by_others"); } ;;
    core)
      targets=(--target hexoderm_installed)
      select=(--tests-regex "$by_others|links_no_gui$")
      ;;
    asan)
      targets=(--target hexoderm_memory_tests)
      select=(--label-regex '^memory$')
      ;;
    tsan)
      targets=(--target hexoderm_threaded_tests)
      select=(--label-regex '^threads$')
      ;;
    window-asan)
      targets=(--target hexoderm_window_tests)
      select=(--label-regex '^window$')
      ;;
  esac
  rm -rf "$build/test-results" "$build/test-results.xml"
  echo "== $preset"
  if ! cmake --preset "$preset" ${CI:+-DHEXODERM_WERROR=ON} >"$root/build/configure.log" 2>&1; then
    cat "$root/build/configure.log"
    echo "== $preset: could not be configured"
    broken=$((broken + 1))
    return
  fi
  grep -A4 'CMake Warning' "$root/build/configure.log" || true
  if ! cmake --build --preset "$preset" --parallel "$jobs" "${targets[@]}"; then
    echo "== $preset: could not be built"
    broken=$((broken + 1))
    return
  fi
  local built=$((SECONDS - start)) ok=yes
  # One more than there are cores: tests of windows and devices wait for these most of the time.
  env "${test_environment[@]}" ctest --preset "$preset" "${select[@]}" --parallel "$((jobs + 1))" \
    --output-junit "$build/test-results.xml" || ok=no
  if [ ! -f "$build/test-results.xml" ]; then
    echo "== $preset: its tests could not be started"
    broken=$((broken + 1))
    return
  fi
  finished+=("$build")
  echo "== $preset: $([ $ok = yes ] && echo passed || echo FAILED), $((SECONDS - start)) s, of which $built s to build"
}

mkdir -p build
for stage in "${stages[@]}"; do
  run_stage "$stage"
done

# Failures once more at the end: a stage's own output is thousands of lines above.
counts="0 0"
if [ ${#finished[@]} -gt 0 ]; then
  "$root/packaging/test_results.py" "${finished[@]}" >build/test-results.txt
  sed '$d' build/test-results.txt
  counts="$(tail -n 1 build/test-results.txt)"
fi
read -r passed failed <<<"$counts"
failed=$((failed + broken))

unregistered="$(cat build/release/tests/unregistered_tests.txt 2>/dev/null || echo 0)"
if [ "$unregistered" -gt 0 ]; then
  echo "$unregistered tests are not registered, because recordings of others (HEXODERM_REFERENCE_DATA) are absent"
fi
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
