#!/usr/bin/env bash
# includes.sh ROOT: core and hal know nothing of each other or of programs, and no stage of core includes a later one.
# Only hal/linux includes headers of an operating system.
set -euo pipefail
cd "$1"

# In the order in which data flows; a stage may include itself and what stands before it. Effects, kernels, visibility
# methods and the public headers are beside this order: a file of theirs counts as of the latest stage that it reaches, so
# that none is a way around the rule.
beside='effects|kernels|visibility|.*\.hpp'
stages=(base scene store plan geometry pixels raster resolve stages frame)
failed=0

# Every quoted or angled include of the C++ files in a folder, as "file:line:path".
includes_of() {
  grep -rnE --include='*.hpp' --include='*.cpp' '^[[:space:]]*#[[:space:]]*include' "$1" |
    sed -E 's/^([^:]+:[0-9]+):[^<"]*[<"]([^>"]+)[>"].*/\1:\2/'
}

complain() {
  echo "$1"
  failed=1
}

declare -A place included floors
for i in "${!stages[@]}"; do place[${stages[i]}]=$i; done
core_includes=$(includes_of core)
while IFS=: read -r file line path; do
  if [[ $path == zstrip/* ]]; then included[$file]+="core/$path "; fi
done <<<"$core_includes"

# floor_of FILE: sets `floor` to the place of the latest stage that a file is of, or reaches.
floor_of() {
  local file=$1 next highest=0 room
  if [ -n "${floors[$file]:-}" ]; then
    floor=${floors[$file]}
    return
  fi
  room=$(cut -d/ -f3 <<<"$file")
  if [[ $room =~ ^($beside)$ ]]; then
    floors[$file]=0
    for next in ${included[$file]:-}; do
      floor_of "$next"
      if [ "$floor" -gt "$highest" ]; then highest=$floor; fi
    done
  else
    highest=${place[$room]:--1}
  fi
  floors[$file]=$highest
  floor=$highest
}

while IFS=: read -r file line path; do
  from=$(cut -d/ -f3 <<<"$file")
  # The compiler's own headers for its vectors, each in one place.
  case "$file $path" in
    "core/zstrip/kernels/vector/sse2.hpp emmintrin.h" | "core/zstrip/kernels/vector/neon.hpp arm_neon.h") continue ;;
  esac
  case "$path" in
    zstrip/*) ;;
    */* | *.hpp | *.h) complain "$file:$line: core includes $path: only zstrip/... and the C++ library are allowed"; continue ;;
    *) continue ;;
  esac
  if [ ! -e "core/$path" ]; then
    complain "$file:$line: $path does not exist"
    continue
  fi
  # The implementations of kernels are theirs: the header above their folders chooses one.
  case "$from $path" in
    "kernels "*) ;;
    *" zstrip/kernels/"*/*) complain "$file:$line: $from includes $path, which only kernels do" ;;
  esac
  floor_of "core/$path"
  if [ "$floor" -lt 0 ]; then
    complain "$file:$line: the stage of $path is not one of: ${stages[*]}"
    continue
  fi
  # Only applications include the one header that gives everything.
  if [ "$path" = zstrip/zstrip.hpp ]; then complain "$file:$line: $path is for applications"; fi
  if [[ $from =~ ^($beside)$ ]]; then continue; fi
  if [ -z "${place[$from]:-}" ]; then
    complain "$file: the stage $from is not one of: ${stages[*]}"
  elif [ "$floor" -gt "${place[$from]}" ]; then
    complain "$file:$line: $from includes $path of the later stage ${stages[floor]}"
  fi
done <<<"$core_includes"

while IFS=: read -r file line path; do
  case "$file $path" in
    hal/linux/*" zstrip_hal_linux/"*) if [ ! -e "hal/linux/$path" ]; then complain "$file:$line: $path does not exist"; fi ;;
    *" zstrip_hal/"*) if [ ! -e "hal/$path" ]; then complain "$file:$line: $path does not exist"; fi ;;
    *" zstrip"*/*) complain "$file:$line: hal includes $path: only zstrip_hal/... is allowed" ;;
    hal/linux/*) ;;
    *" "*/* | *.hpp | *.h) complain "$file:$line: hal includes $path: only zstrip_hal/... and the C++ library are allowed" ;;
  esac
done < <(includes_of hal)

# Documents, examples and the header that has everything show the public headers, which lie in core/zstrip itself.
while IFS=: read -r file line text; do
  complain "$file:$line: $text is no public header of core"
done < <(grep -HnE '^[[:space:]]*#include [<"]zstrip/.*/' README.md docs/*.md */README.md core/zstrip/zstrip.hpp 2>/dev/null || true)

exit "$failed"
