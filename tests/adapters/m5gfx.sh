#!/usr/bin/env bash
# m5gfx.sh ROOT ZSTRIP FOLDER: the sketch M5Gfx and the one of `zstrip bake --display m5gfx` compile with the real M5GFX in
# FOLDER, with its headers for a Linux framebuffer and the Arduino core of the tests.
set -euo pipefail
root=$(cd "$1" && pwd -P)
zstrip=$2 library=$3/src
[ -f "$library/M5GFX.h" ] || { echo "$3 has no src/M5GFX.h"; exit 1; }
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
# The cores of M5Stack's boards do not have the macros of older ones.
printf '#include <Arduino.h>\n#undef %s\n#undef %s\n#undef %s\n#undef %s\n' abs min max round >"$scratch/core.h"
"$zstrip" bake teapot -o "$scratch/Teapot/" --display m5gfx --quiet
include=(-isystem "$library" -isystem "$root/tests/package/arduino/hardware/zstrip/test/cores/test")
for folder in core hal firmware/player firmware/scenes/include firmware/package/src firmware/examples/adapters \
    firmware/examples/YourModel; do
  include+=("-I$root/$folder")
done
for sketch in "$root/firmware/examples/M5Gfx/M5Gfx.ino" "$scratch/Teapot/Teapot.ino"; do
  g++ -std=gnu++20 -Wall -Wextra -Werror -fsyntax-only -x c++ -DLGFX_LINUX_FB "${include[@]}" -include "$scratch/core.h" "$sketch"
  echo "compiled: ${sketch##*/}"
done
