#!/usr/bin/env bash
# pick.sh PROGRAM COUNT TO FROM: adds to the corpus TO the COUNT inputs of folder FROM that reach most of the code, in the
# order in which each adds most to the ones before it. Regressions and other inputs in TO stay as they are.
set -euo pipefail
program=$1 count=$2 to=$3 from=$4
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
mkdir "$scratch/merged"
# libFuzzer's own minimisation; its control file lists the files, then the features, here edges, of each ("FT number edge...").
"$program" -set_cover_merge=1 -use_counters=0 "-merge_control_file=$scratch/control" "$scratch/merged" "$from" >"$scratch/log" 2>&1 || {
  tail -n 20 "$scratch/log"
  exit 1
}
mkdir -p "$to"
awk -v count="$count" '
  NR == 1 { files = $1; next }
  NR == 2 { next }
  NR <= files + 2 { name[NR - 3] = $0; next }
  $1 == "FT" { edges[$2] = $0 }
  END {
    for (n = 1; n <= count; ++n) {
      best = -1; most = 0
      for (i in edges) {
        gain = 0
        fields = split(edges[i], edge, " ")
        for (k = 3; k <= fields; ++k) gain += !(edge[k] in seen)
        if (gain > most || gain == most && gain > 0 && i + 0 < best + 0) { best = i; most = gain }
      }
      if (best < 0) break
      print name[best]
      fields = split(edges[best], edge, " ")
      for (k = 3; k <= fields; ++k) seen[edge[k]] = 1
      delete edges[best]
    }
  }' "$scratch/control" >"$scratch/picked"
number=0
while IFS= read -r file; do
  number=$((number + 1))
  cp "$file" "$to/$(printf 'edges-%02d' "$number")"
done <"$scratch/picked"
echo "$to: $number inputs of $(find "$from" -type f | wc -l)"
