#!/bin/bash
# Fails if a program, or a library that it loads, is Qt's or VTK's. Usage: links_no_gui.sh PROGRAM
set -euo pipefail
libraries="$(ldd "$1")"
! grep -iE 'lib(qt|vtk)' <<<"$libraries"
