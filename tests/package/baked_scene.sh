#!/usr/bin/env bash
# baked_scene.sh ROOT ZSTRIP: the models of sketches are what their first lines say: baked from the repository's. Sketches
# for libraries of displays are those that `zstrip bake` writes.
set -euo pipefail
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
for name in YourModel Player Joystick; do
  sketch=$1/firmware/examples/$name
  options=$(sed -nE 's|^//   host-sim/run bake MODEL -o scene.hpp ||p' "$sketch/$name.ino")
  model=$(sed -nE 's#.*((host-sim/scenes/models|firmware/examples/[A-Za-z]*)/[a-z]*\.(obj|toml)).*#\1#p' "$sketch/$name.ino")
  # shellcheck disable=SC2086  # options are words
  "$2" bake "$1/$model" -o "$scratch/scene.hpp" $options --quiet
  cmp "$scratch/scene.hpp" "$sketch/scene.hpp"
done
for sketch in TftEspi:tft_espi LovyanGfx:lovyangfx M5Gfx:m5gfx ArduinoGfx:arduino_gfx; do
  name=${sketch%:*}
  "$2" bake "$1/host-sim/scenes/models/ring.obj" -o "$scratch/$name/" --display "${sketch#*:}" --quiet
  cmp "$scratch/$name/$name.ino" "$1/firmware/examples/$name/$name.ino"
done
