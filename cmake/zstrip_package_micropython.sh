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
mkdir -p "$1"
cd "$1"
library=$(mktemp -d)
trap 'rm -rf "$library"' EXIT
bash "$zstrip_root/cmake/zstrip_package_sources.sh" "$library"

rm -rf zstrip-micropython
cp -R "$zstrip_root/firmware/micropython" zstrip-micropython
mkdir zstrip-micropython/cpp
cp -R "$library"/zstrip/src/{zstrip,zstrip_hal,zstrip_player,zstrip_player.h,zstrip_scenes} zstrip-micropython/cpp
cp "$zstrip_root"/{LICENSE,CHANGELOG.md} zstrip-micropython
zstrip_write_out zstrip-micropython
zstrip_archive zstrip-micropython >"zstrip-micropython-$zstrip_version.tar.gz"
