#!/usr/bin/env bash
# baked_scene.sh ROOT ZSTRIP: the model of the sketch YourModel is what its first lines say: baked from the repository's.
set -euo pipefail
sketch=$1/firmware/examples/YourModel
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
options=$(sed -nE 's|^//   host-sim/run bake MODEL -o scene.hpp ||p' "$sketch/YourModel.ino")
model=$(sed -nE 's|.*(host-sim/scenes/models/[a-z]*\.obj).*|\1|p' "$sketch/YourModel.ino")
# shellcheck disable=SC2086  # options are words
"$2" bake "$1/$model" -o "$scratch/scene.hpp" $options --quiet
cmp "$scratch/scene.hpp" "$sketch/scene.hpp"
