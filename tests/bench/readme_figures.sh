#!/usr/bin/env bash
# readme_figures.sh ROOT: the README's millions of instructions are those of docs/measured/instructions.csv.
set -euo pipefail
cd "$1"
failed=0

million() {
  awk -F, -v row="$1" '$1 == row { printf "%.2f", $NF / 1e6; found = 1 } END { exit !found }' docs/measured/instructions.csv
}

# check ROWS NAME: the README's line of a target.
check() {
  local k5 ct
  k5=$(million "$1_k5")
  ct=$(million "$1_ct")
  if ! grep -qF "| $2 | **$k5** (" README.md || ! grep -F "| $2 | **" README.md | grep -qF "| **$ct** ("; then
    echo "README.md: instructions of $2 are $k5 and $ct million in docs/measured/instructions.csv"
    failed=1
  fi
}

check m0 Cortex-M0
check m3 Cortex-M3
check m4f Cortex-M4F
check host x86-64
exit $failed
