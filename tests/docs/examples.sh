#!/usr/bin/env bash
# examples.sh ROOT COMPILER: what docs/scenes.md shows as its first scene is the file whose picture SceneChecksum
# compares, and every example in C++ of the pages compiles.
set -euo pipefail
root=$(cd "$1" && pwd -P)
here=$root/tests/docs
file=host-sim/scenes/first.toml
diff <(awk '/^```toml$/ { inside = 1; next } /^```$/ { if (inside) exit } inside' "$root/docs/scenes.md") "$root/$file" ||
  { echo "docs/scenes.md (left) shows another scene than $file (right)"; exit 1; }

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
"$here/gather_examples.py" "$root" "$here/page_examples.cpp" >"$scratch/examples.cpp"
arduino=$root/tests/package/arduino/hardware/zstrip/test
includes=()
for folder in core hal hal/linux host-sim firmware/player firmware/scenes/include firmware/package/src firmware/examples/adapters \
  firmware/examples/Joystick; do
  includes+=(-I "$root/$folder")
done
for folder in "$root/tests/adapters/declarations" "$arduino/cores/test" "$arduino/libraries/SPI"; do
  includes+=(-isystem "$folder")
done
"$2" -std=c++20 -fsyntax-only -Werror "${includes[@]}" "$scratch/examples.cpp"
