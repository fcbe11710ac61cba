#!/usr/bin/env bash
# add_effect.sh ROOT COMPILER: follows "Add an effect" of docs/contributing.md for a made-up effect in a copy of core.
# Where it changes another file than those that the page names, or a step no longer finds its place, it fails; so does
# it where the program with the effect is not built, or draws something else.
set -euo pipefail
root=$1 compiler=$2
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/add_effect
copy=$(mktemp -d)
trap 'rm -rf "$copy"' EXIT
cp -r "$root/core" "$copy"
cd "$copy/core/zstrip"
page=$(sed -n '/^## Add an effect/,/^## When/p' "$root/docs/contributing.md")

# step FILE SED: changes a file that the page names.
step() {
  local file=$1
  if ! grep -qF "\`$file\`" <<<"$page"; then echo "docs/contributing.md does not name $file"; exit 1; fi
  cp "$file" "$copy/before"
  sed -i -E "$2" "$file"
  if cmp -s "$file" "$copy/before"; then echo "$file: nothing found to change by $2"; exit 1; fi
}

step scene.hpp '/^struct Scene \{/,/^\};/ s/^\};/  const Colour* negative = nullptr;\n};/'
step scene/parts.hpp 's/^( *)visit\("overlay", .*/&\n\1visit("negative", scene.negative);/'
step scene/blob_sections.hpp 's/^( *)section\(tag\("NORM"\)/\1section(tag("NEGA"), blob.scene.negative);\n&/'
step effects.hpp '/^inline constexpr Effects edges\{/a inline constexpr Effects negative{std::uint64_t{1} << 39};'
step effects.hpp 's/\| csg \| edges \|/| csg | edges | negative |/'
step effects.hpp 's/^( *)if \(!scene\.csg\.empty\(\)\)/\1if (scene.negative != nullptr) found = found | effect::negative;\n&/'
cp -r "$here/negative" effects/
step effects/list.hpp 's|^#include "zstrip/effects/outlines/effect.hpp"|#include "zstrip/effects/negative/effect.hpp"\n&|'
step effects/list.hpp 's/\bmethods::Described>/negative::Effect, methods::Described>/'
step effects/memory.hpp 's|^#include "zstrip/effects/outlines/effect.hpp"|#include "zstrip/effects/negative/effect.hpp"\n&|'
step effects/memory.hpp 's/\bedges::Effect>/edges::Effect, negative::Effect>/'
step effects/stages.hpp 's|^#include "zstrip/effects/outlines/|#include "zstrip/effects/negative/negative_stage.hpp"\n&|'
step effects/stages.hpp 's/\bdithering::Stage>/negative::Stage, dithering::Stage>/'
step visibility/exclusions.hpp 's/^( *)\{effect::quadrics, method::painter,/\1{effect::negative, method::painter, "nobody has developed it"},\n&/'

# All sources in one. Pipelines of programs that learn the effects at run time are not looked at.
export copy compiler
compile() {
  find "$1" -name '*.cpp' ! -name 'any_p*.cpp' ! -name '*rows_of_*.cpp' | sort | sed 's/.*/#include "&"/' |
    "$compiler" -std=c++20 -O0 -Wall -Wextra -Werror -Wno-missing-field-initializers -I"$copy/core" \
      -o "$copy/$(tr / _ <<<"$1").o" -c -x c++ -
}
export -f compile
printf '%s\n' "$copy/core" "$here" | xargs -P 2 -I{} bash -c 'set -o pipefail; compile {}'
"$compiler" -o "$copy/program" "$copy"/*.o
status=0
"$copy/program" || status=$?
if [ $status -ne 0 ]; then
  echo "the made-up effect does not do what it says: tests/structure/add_effect/program.cpp, status $status"
  exit 1
fi
