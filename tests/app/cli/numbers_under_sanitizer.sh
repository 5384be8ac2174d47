#!/bin/bash
# Under a sanitizer the command line computes once what the numerical tests compute in Release: both solvers, every fault that
# can be simulated, checks, robots and exports. What comes out is judged there; here nothing may be reported.
# Usage: numbers_under_sanitizer.sh HEXODERM_CLI ROOT
set -euo pipefail
cli="$1"
root="$2"
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
cd "$folder"

# Runs a command; 1 is a verdict, not a failure. A sanitizer's report ends a program with 1 too, if it isn't told otherwise.
export ASAN_OPTIONS="${ASAN_OPTIONS:-}:exitcode=99" UBSAN_OPTIONS="${UBSAN_OPTIONS:-}:exitcode=99"
run() { "$cli" "$@" --quiet >said.txt 2>&1 || [ $? -eq 1 ] || { echo "hexoderm-cli $*"; cat said.txt; exit 1; }; }

for session in "$root"/tests/data/vectors/*.session.json; do
  for solver in tree global; do
    run solve "$session" --solver $solver -o solved.calibration.json
    run evaluate solved.calibration.json --against "$session"
  done
  run check solved.calibration.json "$session"
  run sensors "$session"
done
run export solved.calibration.json --to csv,dot,ply,stl,vtp,urdf,tf-yaml,tum,icub,skinware,obj,gltf,sdf,mjcf -o exported

# The faults that the help names: "KIND:CELL with KIND ... or KIND:CELL:PORT with KIND ... or KIND alone, ...: ...; may be".
help="$("$cli" simulate --help)"
faults=0
solve_faults() {
  local suffix="$1" kinds="$2" kind
  for kind in ${kinds//,/ }; do
    [ "$kind" != or ] || continue
    run simulate --poses 4 --fault "$kind$suffix" -o fault.session.json
    run solve fault.session.json
    faults=$((faults + 1))
  done
}
solve_faults :7 "$(sed -n 's/.*KIND:CELL with KIND \(.*\), or KIND:CELL:PORT.*/\1/p' <<<"$help")"
solve_faults :7:1 "$(sed -n 's/.*KIND:CELL:PORT with KIND \(.*\), or KIND alone.*/\1/p' <<<"$help")"
solve_faults "" "$(sed -n 's/.*KIND alone, of the whole skin: \(.*\); may be.*/\1/p' <<<"$help")"
[ "$faults" -ge 20 ] || { echo "only $faults faults were found in the help of simulate"; exit 1; }

run simulate --patch sheet:20x20 --surface cylinder:r=0.2 --poses 5 -o sheet.session.json
run solve sheet.session.json -o sheet.calibration.json
run evaluate sheet.calibration.json --fit cylinder
run simulate --poses 60 -o many.session.json
run solve many.session.json
run simulate --robot demo --poses 8 -o robot.session.json
run solve robot.session.json -o robot.calibration.json
run parts robot.session.json
run links robot.session.json --robot demo
run place robot.session.json --robot demo --link forearm --rotation links
