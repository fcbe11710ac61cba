#!/usr/bin/env bash
# generated.sh ROOT: model files that a program beside them makes are what it makes: FOLDER/generate.mjs, run by node,
# prints FOLDER/FOLDER.gltf; SCENE.mjs, beside SCENE.toml, writes all that is in the folder SCENE.
set -euo pipefail
cd "$1"
command -v node >/dev/null || { echo "node is not installed"; exit 77; }
made=$(mktemp)
scenes=$(mktemp -d)
trap 'rm -rf "$made" "$scenes"' EXIT
failed=0
models=0 compared_scenes=0
while IFS= read -r program; do
  folder=$(dirname "$program")
  model=$folder/$(basename "$folder").gltf
  models=$((models + 1))
  node "$program" >"$made"
  if ! cmp "$made" "$model"; then
    echo "$model is not what $program makes: node $program > $model"
    failed=1
  fi
done < <(find host-sim/scenes -name generate.mjs | sort)
(cd host-sim/scenes && find . -name '*.mjs' -o -name '*.toml') | tar -C host-sim/scenes -cT - | tar -C "$scenes" -x
while IFS= read -r program; do
  scene=${program%.mjs} name=$(basename "$program" .mjs)
  [ -e "$scene.toml" ] || continue
  compared_scenes=$((compared_scenes + 1))
  made_scene=$scenes/${scene#host-sim/scenes/}
  mkdir "$made_scene"
  (cd "$(dirname "$made_scene")" && node "$name.mjs" >/dev/null)
  if ! diff -r "$made_scene" "$scene"; then
    echo "$scene is not what $name.mjs makes: cd $(dirname "$scene") && node $name.mjs"
    failed=1
  fi
done < <(find host-sim/scenes -name '*.mjs' | sort)
[ "$models" -gt 0 ] || { echo "host-sim/scenes holds no generate.mjs"; failed=1; }
[ "$compared_scenes" -gt 0 ] || { echo "host-sim/scenes holds no program beside a scene of its name"; failed=1; }
exit "$failed"
