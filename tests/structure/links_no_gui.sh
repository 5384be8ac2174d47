#!/bin/bash
# Fails if a program, or a library that it loads, is Qt's or VTK's. Usage: links_no_gui.sh PROGRAM
set -euo pipefail
libraries="$(ldd "$1")"
found="$(grep -oiE 'lib(qt|vtk)[^ ]*' <<<"$libraries" | sort -u || true)"
[ -n "$found" ] || exit 0
sed "s|^|$(basename "$1") links |" <<<"$found"
exit 1
