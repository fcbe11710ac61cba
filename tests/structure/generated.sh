#!/usr/bin/env bash
# generated.sh ROOT: model files that a program beside them makes are what it makes: FOLDER/generate.mjs, run by node,
# prints FOLDER/FOLDER.gltf; gallery/SCENE.mjs writes all that is in gallery/SCENE.
set -euo pipefail
cd "$1"
command -v node >/dev/null || { echo "node is not installed"; exit 77; }
made=$(mktemp)
gallery=$(mktemp -d)
trap 'rm -rf "$made" "$gallery"' EXIT
failed=0
compared=0
while IFS= read -r program; do
  folder=$(dirname "$program")
  model=$folder/$(basename "$folder").gltf
  compared=$((compared + 1))
  node "$program" >"$made"
  if ! cmp "$made" "$model"; then
    echo "$model is not what $program makes: node $program > $model"
    failed=1
  fi
done < <(find host-sim/scenes -name generate.mjs | sort)
cp host-sim/scenes/gallery/*.{mjs,toml} "$gallery"
for scene in host-sim/scenes/gallery/*.toml; do
  name=$(basename "$scene" .toml)
  mkdir "$gallery/$name"
  (cd "$gallery" && node "$name.mjs" >/dev/null)
  if ! diff -r "$gallery/$name" "${scene%.toml}"; then
    echo "${scene%.toml} is not what $name.mjs makes: cd host-sim/scenes/gallery && node $name.mjs"
    failed=1
  fi
done
[ "$compared" -gt 0 ] || { echo "host-sim/scenes holds no generate.mjs"; failed=1; }
exit "$failed"
