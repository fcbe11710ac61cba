#!/usr/bin/env bash
# zstrip_package_rust.sh FOLDER [URL]: writes zstrip as a crate for Rust, which compiles the player's C++ sources itself:
# FOLDER/zstrip-rust and FOLDER/zstrip-rust-VERSION.tar.gz. Needs no build tree. URL: where zstrip is to be found, for the
# file that says it. The same sources give the same bytes anywhere.
# Exit status 1 if a file is missing; 2 for wrong words.
set -euo pipefail
if [ $# -lt 1 ] || [ $# -gt 2 ]; then
  sed -n '2,5s/^# //p' "${BASH_SOURCE[0]}" >&2
  exit 2
fi
source "$(dirname "${BASH_SOURCE[0]}")/zstrip_package_files.sh"
zstrip_player_package rust "$@"
