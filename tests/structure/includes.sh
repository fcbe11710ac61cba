#!/usr/bin/env bash
# includes.sh ROOT: core and hal know nothing of each other or of programs, and no file of core includes one of a later
# place. Only hal/linux includes headers of an operating system.
set -euo pipefail
shopt -s extglob
source "$(dirname "${BASH_SOURCE[0]}")/search.sh"
cd "$1"

# All of core/zstrip, bottom to top: a file includes those of its own line and of the lines before it. The longest
# pattern that fits says where a file stands. A public header stands with the folder that it opens.
order=(
  'base/* status.hpp'
  'scene/* @(animation|blob|camera|clips|effects|levels|morph|overlay|scene|skin|view).hpp'
  'store/*'
  'budget.hpp'
  'effects/*/effect.hpp effects/@(effect|exclusions|list|memory).hpp
    visibility/@(depth_bounds|exclusions|memory|method_state|methods|options|traits).hpp'
  'plan/* plan.hpp'
  'geometry/* visibility/triangle_order.hpp'
  'pixels/* kernels/fragment_run.hpp'
  'kernels/portable/*'
  'kernels/thumb/*'
  'kernels/thumb1/*'
  'kernels/thumb2/*'
  'kernels/mve/*'
  'kernels/vector/*'
  'kernels/*'
  'effects/@(fog/fog|local_light/local_light|outlines/outline).?pp'
  'raster/*'
  'resolve/*'
  'state/* effects/stage.hpp'
  'effects/*/*'
  'stages/*'
  'effects/*/*_stage.?pp'
  'frame/* effects/stages.hpp @(area|fingerprints|fixed_renderer|frame|layer|pick|renderer).hpp'
  'visibility/* visibility.hpp'
  'zstrip.hpp'
)
failed=0

# includes_of FOLDER: sets `found` to every quoted or angled include of its C++ files, as "file:line:path".
includes_of() {
  lines -rnE --include='*.hpp' --include='*.cpp' --include='*.inc' '^[[:space:]]*#[[:space:]]*include' "$1"
  [ -n "$found" ] || { echo "no file of $1 includes anything"; exit 1; }
  found=$(sed -E 's/^([^:]+:[0-9]+):[^<"]*[<"]([^>"]+)[>"].*/\1:\2/' <<<"$found")
}

complain() {
  echo "$1"
  failed=1
}

declare -A places
# place_of FILE: sets `place` to the line of a file below core/zstrip.
place_of() {
  place=${places[$1]:-}
  if [ -n "$place" ]; then return; fi
  local i pattern longest=""
  for i in "${!order[@]}"; do
    set -f # shellcheck disable=SC2086 # the patterns of a line
    for pattern in ${order[i]}; do
      # shellcheck disable=SC2053 # a pattern
      if [[ $1 == $pattern && ${#pattern} -gt ${#longest} ]]; then longest=$pattern place=$i; fi
    done
    set +f
  done
  places[$1]=$place
}

found=$(find core/zstrip -type f)
[ -n "$found" ] || { echo "core/zstrip holds no file"; exit 1; }
while read -r file; do
  place_of "${file#core/zstrip/}"
  if [ -z "$place" ]; then complain "$file has no place in the order of core: tests/structure/includes.sh"; fi
done <<<"$found"

includes_of core
while IFS=: read -r file line path; do
  # The compiler's own headers for its vectors, each in one place.
  case "$file $path" in
    "core/zstrip/kernels/vector/sse2.hpp emmintrin.h" | "core/zstrip/kernels/vector/neon.hpp arm_neon.h" | \
      "core/zstrip/kernels/mve/vectors.hpp arm_mve.h") continue ;;
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
  case "$file $path" in
    core/zstrip/kernels/*) ;;
    *" zstrip/kernels/"*/*) complain "$file:$line: $path is included, which only kernels do" ;;
  esac
  place_of "${path#zstrip/}"
  included=$place
  place_of "${file#core/zstrip/}"
  if [ -n "$included" ] && [ -n "$place" ] && [ "$included" -gt "$place" ]; then
    complain "$file:$line: $path stands later: ${order[included]}"
  fi
done <<<"$found"

includes_of hal
while IFS=: read -r file line path; do
  case "$file $path" in
    hal/linux/*" zstrip_hal_linux/"*) if [ ! -e "hal/linux/$path" ]; then complain "$file:$line: $path does not exist"; fi ;;
    *" zstrip_hal/"*) if [ ! -e "hal/$path" ]; then complain "$file:$line: $path does not exist"; fi ;;
    *" zstrip"*/*) complain "$file:$line: hal includes $path: only zstrip_hal/... is allowed" ;;
    hal/linux/*) ;;
    *" "*/* | *.hpp | *.h) complain "$file:$line: hal includes $path: only zstrip_hal/... and the C++ library are allowed" ;;
  esac
done <<<"$found"

# Documents, examples and the header that has everything show the public headers, which lie in core/zstrip itself.
lines -HnE '^[[:space:]]*#include [<"]zstrip/.*/' README.md docs/*.md */README.md core/zstrip/zstrip.hpp
if [ -n "$found" ]; then complain "$found
these are no public headers of core"; fi

exit "$failed"
