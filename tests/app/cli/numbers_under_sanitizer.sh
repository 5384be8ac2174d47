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

# Runs a command; 1 is a verdict, not a failure.
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

kinds="$("$cli" simulate --help | grep -o 'KIND:CELL with KIND.*')"
for kind in $(sed 's/, or KIND:CELL:PORT.*//; s/.*KIND:CELL with KIND//; s/,\| or / /g' <<<"$kinds"); do
  run simulate --poses 4 --fault "$kind:7" -o fault.session.json
  run solve fault.session.json
done
for kind in $(sed 's/.*or KIND alone, of the whole skin://; s/; may be.*//; s/,\| or / /g' <<<"$kinds"); do
  run simulate --poses 4 --fault "$kind" -o fault.session.json
  run solve fault.session.json
done
for kind in joint cable wrong-port; do
  run simulate --poses 4 --fault "$kind:7:1" -o fault.session.json
  run solve fault.session.json
done

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
