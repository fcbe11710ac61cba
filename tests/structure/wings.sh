#!/usr/bin/env bash
# wings.sh ROOT COMPILER: an effect is a wing. The file that orders the stages names none; visibility methods have one
# folder that names them; each folder of effects has a descriptor and is in the lists; no source of a wing or of a stage
# compiles more than 60 of our headers.
set -euo pipefail
shopt -s nullglob
source "$(dirname "${BASH_SOURCE[0]}")/search.sh"
cd "$1"
compiler=$2
core=core/zstrip
most=60
failed=0
complain() {
  echo "$1"
  failed=1
}

lines -nE '\b(effect|method)::' $core/frame/frame_order.hpp
if [ -n "$found" ]; then complain "$found
$core/frame/frame_order.hpp names an effect: it belongs into a hook of a stage"; fi

# Visibility methods are studies: the stages know what a method changes, by its traits, and not which it is.
# only_visibility_names PATTERN [FILE...]: and these files of core/zstrip.
only_visibility_names() {
  local pattern=$1 file
  shift
  lines -rnE "$pattern" $core --include='*.hpp' --include='*.cpp' --include='*.inc' --exclude-dir=visibility \
    --exclude=visibility.hpp
  for file in "$@"; do
    [ -e "$core/$file" ] || complain "$core/$file is an exception of tests/structure/wings.sh, and not there"
    lines -vE "^$core/$file:" <<<"$found"
  done
  if [ -n "$found" ]; then complain "$found
only $core/visibility names visibility methods: ask $core/visibility/traits.hpp"; fi
}
only_visibility_names '\bmethod::|[Pp]ainter|[Nn]ewell|[Hh]ierarchical|[Ff]ront_?[Tt]o_?[Bb]ack|[Mm]idpoint'
# A blob holds a baked tree, whichever method draws with it.
only_visibility_names '\b[Bb]sp|Bsp|BSP' blob.hpp scene/{bsp_tree,blob_sections}.hpp scene/scene_blob.cpp
# The loop that writes a pixel counts it.
only_visibility_names '[Oo]verdraw' pixels/depth_rule.hpp

folders=($core/effects/*/)
if [ ${#folders[@]} -eq 0 ]; then complain "$core/effects holds no effect"; fi
for folder in "${folders[@]}"; do
  wing=$(basename "$folder")
  if [ ! -e "$folder/effect.hpp" ]; then
    complain "$folder has no effect.hpp"
  elif ! grep -qF "effects/$wing/effect.hpp" $core/effects/list.hpp || ! grep -qE "\b$wing::Effect\b" $core/effects/list.hpp; then
    complain "$core/effects/list.hpp lacks $wing"
  fi
  for stage in "$folder"*_stage.hpp; do
    if ! grep -qE "\b$wing::Stage\b" $core/effects/stages.hpp; then
      complain "$core/effects/stages.hpp lacks the stage of $wing"
    fi
  done
  lines -lw kNeedMemory "$folder"effect.hpp
  if [ -n "$found" ] && ! grep -qE "^ .*\b$wing::Effect\b" $core/effects/memory.hpp; then
    complain "$core/effects/memory.hpp lacks $wing, which needs memory"
  fi
done

sources=($core/effects/*/*.cpp $core/{state,stages}/*.cpp)
if [ ${#sources[@]} -eq 0 ]; then complain "$core has no source of a wing or of a stage"; fi
for source in "${sources[@]}"; do
  headers=$("$compiler" -std=c++20 -Icore -MM "$source")
  count=$(tr ' ' '\n' <<<"$headers" | awk '/\.hpp$/ { ++count } END { print count + 0 }')
  if [ "$count" -gt "$most" ]; then complain "$source compiles $count headers, more than $most"; fi
done
exit "$failed"
