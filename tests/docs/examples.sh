#!/usr/bin/env bash
# examples.sh ROOT: what docs/scenes.md shows as its first scene is the file whose picture SceneChecksum compares.
set -euo pipefail
file=host-sim/scenes/first.toml
diff <(awk '/^```toml$/ { inside = 1; next } /^```$/ { if (inside) exit } inside' "$1/docs/scenes.md") "$1/$file" ||
  { echo "docs/scenes.md (left) shows another scene than $file (right)"; exit 1; }
