#!/usr/bin/env bash
# fuzz.sh PROGRAM CORPUS FOUND RUNS: replays the corpus, then searches for new failures. What breaks PROGRAM is kept in
# FOUND. The search tries RUNS inputs from the stored corpus, with ZSTRIP_LONG 30 times as many, with a fixed seed and
# nothing that depends on time or addresses: the same build tries the same inputs in the same order.
#   ZSTRIP_FUZZ_SECONDS  how long to search instead. The seed is another each time then, what the program compares guides
#                        the search too, and what was learnt stays in FOUND for the next time.
set -euo pipefail
program=$(readlink -f "$1") corpus=$(readlink -f "$2") found=$3 runs=$4
if [ -n "${ZSTRIP_LONG-}" ]; then runs=$((runs * 30)); fi
target=$(basename "$program")
mkdir -p "$found"
found=$(cd "$found" && pwd -P)

# One input takes milliseconds; 30 seconds are a hang, even on a busy machine.
options=(-timeout=30 -rss_limit_mb=2048 -max_len=1024 -len_control=20 -print_final_stats=1 "-artifact_prefix=$found/$target-")
if [ -n "${ZSTRIP_FUZZ_SECONDS-}" ]; then
  learnt=$found/$target.corpus
  mkdir -p "$learnt"
  search=("-max_total_time=$ZSTRIP_FUZZ_SECONDS" -seed=0)
else
  learnt=$(mktemp -d)
  trap 'rm -rf "$learnt"' EXIT
  search=(-seed=1 -use_cmp=0 -reload=0 "-runs=$runs")
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
    run=("$program" "${options[@]}" "${search[@]}" "$learnt" "$corpus")
  fi
  if ! "${run[@]}" >"$log" 2>&1 </dev/null; then
    grep -E 'BROKEN PROMISE|ERROR: |runtime error|SUMMARY' "$log" || tail -n 20 "$log"
    input=$(sed -nE "s/^artifact_prefix=.*Test unit written to (.*)$/\1/p; s/^Running: (.*)$/\1/p" "$log" | tail -n 1)
    echo "The whole log: $log"
    echo "To replay it:  $program ${input:-INPUT}"
    # The input itself, so that the words of a log are enough to replay it elsewhere.
    if [ -n "$input" ] && [ -f "$input" ]; then echo "INPUT, elsewhere: echo $(base64 -w 0 "$input") | base64 -d >INPUT"; fi
    if [ "$step" = search ]; then
      echo "Found after $(sed -n 's/^stat::number_of_executed_units: *//p' "$log" | tail -n 1) inputs, $(sed -n 's/^INFO: Seed: /seed /p' "$log" | tail -n 1)"
    fi
    exit 1
  fi
done
echo "$inputs inputs replayed; then: $(grep -E '^Done ' "$log")"
