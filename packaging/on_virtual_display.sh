#!/bin/bash
# Runs a command on a virtual display of its own, where windows of other programs take no focus from it.
# Usage: packaging/on_virtual_display.sh COMMAND [ARGUMENT...]
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/environment.sh"
on_virtual_display "$@"
