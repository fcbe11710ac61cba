#!/usr/bin/env bash
# readme_figures.sh ROOT: the millions of instructions in the README, and what is now in the table of targets of
# docs/performance.md, are those of docs/measured/instructions.csv. Below the README's pictures, bytes are those of
# docs/gallery.md, and frames a second, there and in docs/gallery.md, follow from docs/measured/gallery.csv and the
# cycles of boards.
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

# board NAME: its megahertz, and the least and the most cycles of an instruction that is counted for a Cortex-M3.
board() {
  awk -v name="\"$1\"," '
    /^constexpr CyclesPerEstimate/ {
      while (match($0, /k[A-Za-z0-9]+\{[^}]*\}/)) {
        split(substr($0, RSTART, RLENGTH), part, /[{}]/)
        range[part[1]] = part[2]
        $0 = substr($0, RSTART + RLENGTH)
      }
    }
    /\.name = / { here = index($0, name) }
    here && /core_mhz/ { gsub(/[^0-9]/, ""); clock = $0 }
    here && /cycles_per_estimate/ {
      gsub(/.*= \{?|[},]+$/, "")
      if ($0 in range) $0 = range[$0]
      split($0, cycles, /, */)
      print clock, cycles[1], cycles[2]
      exit
    }' host-sim/bench/board_model.cpp
}
read -r _ pico _ <<<"$(board pico)"
read -r _ pico2 _ <<<"$(board pico2)"

# caption SCENE: the line below a picture.
caption() {
  awk -F ' *[|] *' -v scene="$1" -v pico="$pico" -v pico2="$pico2" '
    FILENAME ~ /[.]csv$/ { split($0, f, ","); if (f[1] f[2] f[3] f[4] == scene "m3speed22") counted = f[6]; next }
    $2 == "`" scene "`" && $5 ~ /^[0-9,]+$/ { flash = $3; ram = $5; gsub(/,/, "", flash); gsub(/,/, "", ram) }
    END {
      printf "%.1f KB of RAM, %.1f KB of flash<br>Pico %.1f fps, Pico 2 %.1f fps", ram / 1024, flash / 1024,
        125e6 / pico / counted, 150e6 / pico2 / counted
    }
  ' docs/measured/gallery.csv docs/gallery.md
}
for scene in lighthouse astronaut train robot watch chess home fox; do
  is=$(caption $scene)
  grep -qF "**$scene**<br>$is |" README.md || { echo "README.md: below the picture of $scene stands not: $is"; failed=1; }
done

# rates SCENE: its line of "Frames a second" in docs/gallery.md.
rates() {
  local name clock least most line="| \`$1\` |"
  for name in pico pico2 blackpill stm32f4 esp32c6; do
    read -r clock least most <<<"$(board $name)"
    line+=$(awk -F, -v scene="$1" -v hertz="${clock}e6" -v least="$least" -v most="$most" '
      $1 $2 $3 $4 == scene "m3speed48" {
        if (least == most) printf " %.1f |", hertz / least / $6
        else printf " %.1f to %.1f |", hertz / most / $6, hertz / least / $6
      }' docs/measured/gallery.csv)
  done
  echo "$line"
}
for scene in lighthouse astronaut train robot watch chess home fox; do
  is=$(rates $scene)
  grep -qxF "$is" docs/gallery.md || { echo "docs/gallery.md: there is no line $is"; failed=1; }
done
exit $failed
