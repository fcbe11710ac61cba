#!/usr/bin/env bash
# headers.sh ROOT COMPILER: each public header of core, hal and player compiles by itself, freestanding; with ZSTRIP_LONG
# each header.
set -euo pipefail
root=$1
compiler=$2
depth=(-maxdepth 1)
if [ -n "${ZSTRIP_LONG-}" ]; then depth=(); fi
check() {
  local header=$1
  shift
  "$@" -std=c++20 -O0 -ffreestanding -fno-exceptions -fno-rtti -Wall -Wextra -Werror -fsyntax-only \
    -I"$root/core" -I"$root/hal" -I"$root/firmware/player" -I"$root/firmware/scenes/include" -x c++ - <<<"#include \"$header\""
}
export root
export -f check
find "$root"/{core/zstrip,hal/zstrip_hal,firmware/player/zstrip_player} "${depth[@]}" -name '*.hpp' | sort |
  xargs -P 2 -I{} bash -c 'check "$@"' _ {} "$compiler"
