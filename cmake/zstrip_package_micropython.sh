#!/usr/bin/env bash
# zstrip_package_micropython.sh FOLDER: writes zstrip as a user C module of MicroPython: FOLDER/zstrip-micropython and
# FOLDER/zstrip-micropython-VERSION.tar.gz. Needs no build tree. The same sources give the same bytes anywhere.
# Exit status 1 if a file is missing; 2 for wrong words.
set -euo pipefail
if [ $# -ne 1 ]; then
  sed -n '2,4s/^# //p' "${BASH_SOURCE[0]}" >&2
  exit 2
fi
source "$(dirname "${BASH_SOURCE[0]}")/zstrip_package_files.sh"
zstrip_player_package micropython "$1"
