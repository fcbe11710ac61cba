#!/usr/bin/env bash
# baked_sketch.sh ZSTRIP PROGRAM SCENE OPTION...: PROGRAM is the sketch of `zstrip bake SCENE -o FILE.ino OPTION...` on the
# board of sketch/. Its panel shows what `zstrip render --panel` does. The scene stands still.
set -euo pipefail
zstrip=$1 program=$2 scene=$3
shift 3
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
"$zstrip" render "$scene" -o "$scratch/expected.png" --panel st7789 --quiet "$@"
"$program" "$scratch/expected.png"
