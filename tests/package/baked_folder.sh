#!/usr/bin/env bash
# baked_folder.sh ZSTRIP PROGRAM SCENE OPTION...: PROGRAM is that of the folder of `zstrip bake SCENE -o FOLDER/ OPTION...`,
# on a stand-in for its library. Its screen shows what `zstrip render` does. The scene stands still.
set -euo pipefail
zstrip=$1 program=$2 scene=$3
shift 3
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
"$zstrip" render "$scene" -o "$scratch/expected.raw" --format rgb565_swapped --quiet "$@"
"$program" "$scratch/expected.raw"
