#!/usr/bin/env bash
# readme_figures.sh ROOT: the millions of instructions in the README, and what is now in the table of targets of
# docs/performance.md, are those of docs/measured/instructions.csv.
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

# now NAME ROW: a line of that table, whose figures have as many digits as they like; cells: "before, now (aimed at)".
now() {
  awk -F ' *[|] *' -v name="$1" -v row="$2" '
    BEGIN { targets = split("m3 m4f m0 host", target, " ") }
    FILENAME ~ /[.]csv$/ { split($0, field, ","); counted[field[1]] = field[9]; next }
    /^#/ { in_table = $0 == "### Targets" }
    in_table && $2 == name {
      found = 1
      for (i = 1; i <= targets; ++i) {
        cell = $(i + 2)
        gsub(/[*]|.*, | *[(].*/, "", cell)
        if (cell == "") continue
        digits = length(cell) - index(cell, ".")
        is = sprintf("%." digits "f", counted[target[i] "_" row] / 1e6)
        if (is == cell) continue
        print "docs/performance.md, targets: " name " takes " is " million on " target[i] " as counted, not " cell
        failed = 1
      }
    }
    END { if (!found) print "docs/performance.md has no line of " name; exit failed || !found }
  ' docs/measured/instructions.csv docs/performance.md || failed=1
}

now 'K5 at 320x240' k5
now 'CT at 320x240' ct
now 'teapot at 320x240' teapot
now 'room at 320x240' room
now 'K5T, the knot textured and lit' k5t
now 'character at 240x320, in strips of 28 rows' character
now 'K5 at 640x480' k5_vga
now 'R10k at 640x480' r10k

check m0 Cortex-M0
check m3 Cortex-M3
check m4f Cortex-M4F
check host x86-64
exit $failed
