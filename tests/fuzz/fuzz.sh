#!/usr/bin/env bash
# fuzz.sh PROGRAM CORPUS FOUND: replays the corpus, then searches for new failures. What breaks PROGRAM is kept in FOUND.
#   ZSTRIP_FUZZ_SECONDS  how long to search. Without it 60 seconds from the stored corpus and with a fixed seed, so that
#                        two runs try nearly the same and a new failure is due to a change. With it the seed is another
#                        each time, and what was learnt stays in FOUND for the next time.
set -euo pipefail
program=$(readlink -f "$1") corpus=$(readlink -f "$2") found=$3
target=$(basename "$program")
mkdir -p "$found"
found=$(cd "$found" && pwd -P)

# One input takes milliseconds; 30 seconds are a hang, even on a busy machine.
options=(-timeout=30 -rss_limit_mb=2048 -max_len=1024 -len_control=20 "-artifact_prefix=$found/$target-")
if [ -n "${ZSTRIP_FUZZ_SECONDS-}" ]; then
  learnt=$found/$target.corpus
  mkdir -p "$learnt"
  options+=("-max_total_time=$ZSTRIP_FUZZ_SECONDS" -seed=0)
else
  learnt=$(mktemp -d)
  trap 'rm -rf "$learnt"' EXIT
  options+=(-max_total_time=60 -seed=1)
fi

# Thousands of lines of progress are of interest only if something breaks.
log=$found/$target.log
inputs=$(find "$corpus" -type f | wc -l)
[ "$inputs" -gt 0 ] || { echo "$corpus is empty"; exit 1; }
for step in replay search; do
  if [ "$step" = replay ]; then
    mapfile -t files < <(find "$corpus" -type f | sort)
    run=("$program" "${options[@]}" "${files[@]}")
  else
    run=("$program" "${options[@]}" "$learnt" "$corpus")
  fi
  if ! "${run[@]}" >"$log" 2>&1 </dev/null; then
    grep -E 'BROKEN PROMISE|ERROR: |runtime error|SUMMARY' "$log" || tail -n 20 "$log"
    input=$(sed -nE "s/^artifact_prefix=.*Test unit written to (.*)$/\1/p; s/^Running: (.*)$/\1/p" "$log" | tail -n 1)
    echo "The whole log: $log"
    echo "To replay it:  $program ${input:-INPUT}"
    exit 1
  fi
done
echo "$inputs inputs replayed; then: $(grep -E '^Done ' "$log")"
