#!/usr/bin/env bash
# npm.sh ROOT SCRATCH ZSTRIP: the package for pages is built, taken in by Node.js and by a page in Chromium, if there is one,
# and draws what the command draws.
set -euo pipefail
root=$(cd "$1" && pwd -P)
zstrip=$3
for tool in clang++ wasm-ld node ninja arm-none-eabi-g++; do
  command -v "$tool" >/dev/null || { echo "$tool is not installed"; exit 77; }
done
mkdir -p "$2"
scratch=$(cd "$2" && pwd -P)
rm -rf "$scratch"/{node_modules,scenes}
bash "$root/cmake/zstrip_package_npm.sh" "$scratch"
mkdir -p "$scratch/node_modules/zstrip" "$scratch/scenes"
tar -C "$scratch/node_modules/zstrip" --strip-components 1 -xzf "$scratch"/zstrip-npm-*.tgz
cp "$root/tests/package/npm.mjs" "$scratch"

cd "$scratch"
for scene in knot room "$root"/host-sim/scenes/{fog.toml,overlay.toml,shading.toml,csg.toml,figure/figure.gltf} "$root"/tests/bake/models/morph_face.gltf; do
  name=$(basename "${scene%.*}")
  "$zstrip" bake "$scene" -o "scenes/$name.zsc" --size 160x120 --turntable --quiet
  "$zstrip" render "scenes/$name.zsc" --size 160x120 --frames 3 --image raw -o "scenes/$name" --quiet
  node npm.mjs "scenes/$name.zsc" "scenes/$name"/*.raw || { echo "$name differs"; exit 1; }
done
"$zstrip" bake "$root/host-sim/scenes/perspective.toml" -o scenes/refused.zsc --quiet
node npm.mjs scenes/refused.zsc || { echo "a scene that cannot be drawn is not refused"; exit 1; }
if command -v chromium >/dev/null; then
  node "$root/tests/package/page_test.mjs" chromium "$scratch" "$(find "$scratch/scenes/room" -name '*.raw' | sort | head -n 1)" ||
    { echo "a page shows another picture"; exit 1; }
fi
echo "zstrip.wasm: $(stat -c %s package/zstrip.wasm) bytes"
