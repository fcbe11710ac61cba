#!/usr/bin/env bash
# generated.sh ROOT: model files that a program beside them makes are what it makes: FOLDER/generate.mjs, run by node,
# prints FOLDER/FOLDER.gltf.
set -euo pipefail
cd "$1"
command -v node >/dev/null || { echo "node is not installed"; exit 77; }
made=$(mktemp)
trap 'rm -f "$made"' EXIT
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
[ "$compared" -gt 0 ] || { echo "host-sim/scenes holds no generate.mjs"; failed=1; }
exit "$failed"
