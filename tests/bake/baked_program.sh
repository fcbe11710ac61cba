#!/usr/bin/env bash
# baked_program.sh ZSTRIP PROGRAM SCENE FRAMES MILLISECONDS OPTION...: PROGRAM is that of `zstrip bake SCENE -o main.cpp
# OPTION...`. It writes the pictures of `zstrip render --frames FRAMES`, which are MILLISECONDS apart.
set -euo pipefail
zstrip=$1 program=$2 scene=$3 frames=$4 milliseconds=$5
shift 5
options=()
while [ $# -gt 0 ]; do
  case $1 in
    --turntable | --split-columns) ;;  # of the plan, and what several frames have anyhow
    --strip-buffers) shift ;;
    *) options+=("$1") ;;
  esac
  shift
done
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
"$zstrip" render "$scene" -o "$scratch/frames/" --frames "$frames" --image raw --quiet "${options[@]}"
for ((frame = 0; frame < frames; ++frame)); do
  "$program" "$scratch/picture.raw" $((frame * milliseconds))
  cmp "$scratch/picture.raw" "$(printf '%s/frames/frame_%04d.raw' "$scratch" "$frame")"
done
if "$program" "$scratch/nowhere/picture.raw"; then
  echo "it ends well without a file"
  exit 1
fi
