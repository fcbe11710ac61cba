#!/usr/bin/env bash
# wings.sh ROOT COMPILER: an effect is a wing. The file that orders the stages names none; visibility methods have one
# folder that names them; each folder of effects has a descriptor and is in the lists; no source of a wing or of a stage
# compiles more than 60 of our headers.
set -euo pipefail
cd "$1"
compiler=$2
core=core/zstrip
most=60
failed=0
complain() {
  echo "$1"
  failed=1
}

if grep -nE '\b(effect|method)::' $core/frame/frame_order.hpp 2>/dev/null; then
  complain "$core/frame/frame_order.hpp names an effect: it belongs into a hook of a stage"
fi

# Visibility methods are studies: the stages know what a method changes, by its traits, and not which it is.
if grep -rnE '\bmethod::|[Pp]ainter|[Nn]ewell|[Hh]ierarchical|[Ff]ront_?[Tt]o_?[Bb]ack|[Mm]idpoint' $core \
  --include='*.hpp' --include='*.cpp' --exclude-dir=visibility --exclude=visibility.hpp; then
  complain "only $core/visibility names visibility methods: ask $core/visibility/traits.hpp"
fi

for folder in $core/effects/*/; do
  [ -e "$folder" ] || continue
  wing=$(basename "$folder")
  if [ ! -e "$folder/effect.hpp" ]; then
    complain "$folder has no effect.hpp"
  elif ! grep -qF "effects/$wing/effect.hpp" $core/effects/list.hpp || ! grep -qE "\b$wing::Effect\b" $core/effects/list.hpp; then
    complain "$core/effects/list.hpp lacks $wing"
  fi
  for stage in "$folder"*_stage.hpp; do
    if [ -e "$stage" ] && ! grep -qE "\b$wing::Stage\b" $core/effects/stages.hpp; then
      complain "$core/effects/stages.hpp lacks the stage of $wing"
    fi
  done
done

for source in $core/effects/*/*.cpp $core/{state,stages}/*.cpp; do
  [ -e "$source" ] || continue
  headers=$("$compiler" -std=c++20 -Icore -MM "$source")
  count=$(tr ' ' '\n' <<<"$headers" | awk '/\.hpp$/ { ++count } END { print count + 0 }')
  if [ "$count" -gt "$most" ]; then complain "$source compiles $count headers, more than $most"; fi
done
exit "$failed"
