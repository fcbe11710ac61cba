#!/usr/bin/env bash
# checks_fail.sh ROOT: the other checks of this folder are tried on small trees that break each rule; a check that lets
# one pass, or complains of a good tree, fails here.
set -euo pipefail
root=$1
checks=$root/tests/structure
# Of sources all are looked at.
export ZSTRIP_LONG=1
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
failed=0

good_tree() {
  rm -rf "${tree:?}"/*
  cp "$root/.clang-format" "$root/.clang-tidy" "$tree"
  mkdir -p "$tree"/{core/zstrip/{base,scene,frame},hal/zstrip_hal,firmware/player/zstrip_player}
  printf '#pragma once\n#include <cstdint>\n' >"$tree/core/zstrip/base/fixed.hpp"
  printf '#include "zstrip/base/fixed.hpp"\nint twice(int value) { return 2 * value; }\n' >"$tree/core/zstrip/scene/twice.cpp"
  printf '#pragma once\n' >"$tree/core/zstrip/frame/order.hpp"
  printf '#pragma once\n' >"$tree/hal/zstrip_hal/bus.hpp"
}

is_version_14() { [[ $("$1" --version 2>/dev/null) == *'version 14.'* ]]; }

# passes CHECK ARGS...; fails_with TEXT CHECK ARGS...
passes() {
  local check=$1
  shift
  if ! output=$(bash "$checks/$check" "$tree" "$@" 2>&1); then echo "$check complains of a good tree: $output"; failed=1; fi
}
fails_with() {
  local text=$1 check=$2 status=0
  shift 2
  output=$(bash "$checks/$check" "$tree" "$@" 2>&1) || status=$?
  if [ "$status" -eq 0 ] || ! grep -qF -- "$text" <<<"$output"; then
    echo "$check should fail with \"$text\"; it ended with $status and: $output"
    failed=1
  fi
  good_tree
}

good_tree
passes includes.sh
passes layout.sh
passes freestanding.sh g++
if is_version_14 clang-format; then passes format.sh; fi

echo '#include "zstrip_hal/bus.hpp"' >>"$tree/core/zstrip/scene/twice.cpp"
fails_with "core includes zstrip_hal/bus.hpp" includes.sh
echo '#include "zstrip/base/fixed.hpp"' >>"$tree/hal/zstrip_hal/bus.hpp"
fails_with "hal includes zstrip/base/fixed.hpp" includes.sh
echo '#include <sys/mman.h>' >>"$tree/hal/zstrip_hal/bus.hpp"
fails_with "hal includes sys/mman.h" includes.sh
mkdir -p "$tree/hal/linux/zstrip_hal_linux"
printf '#pragma once\n#include <sys/mman.h>\n#include "zstrip_hal/bus.hpp"\n' >"$tree/hal/linux/zstrip_hal_linux/spidev.hpp"
passes includes.sh
echo '#include "zstrip_hal_linux/spidev.hpp"' >>"$tree/hal/zstrip_hal/bus.hpp"
fails_with "hal includes zstrip_hal_linux/spidev.hpp" includes.sh
mkdir -p "$tree/hal/linux/zstrip_hal_linux"
echo '#include "zstrip/base/fixed.hpp"' >"$tree/hal/linux/zstrip_hal_linux/spidev.hpp"
fails_with "hal includes zstrip/base/fixed.hpp" includes.sh
echo '#include "zstrip/frame/order.hpp"' >>"$tree/core/zstrip/scene/twice.cpp"
fails_with "scene includes zstrip/frame/order.hpp of the later stage frame" includes.sh
mkdir -p "$tree/core/zstrip/effects/fog"
echo '#include "zstrip/scene/twice.hpp"' >"$tree/core/zstrip/effects/fog/fog.hpp"
printf '#pragma once\n' >"$tree/core/zstrip/scene/twice.hpp"
echo '#include "zstrip/effects/fog/fog.hpp"' >>"$tree/core/zstrip/scene/twice.cpp"
passes includes.sh
echo '#include "zstrip/frame/order.hpp"' >>"$tree/core/zstrip/effects/fog/fog.hpp"
fails_with "scene includes zstrip/effects/fog/fog.hpp of the later stage frame" includes.sh
mkdir -p "$tree/core/zstrip/kernels/vector"
printf '#pragma once\n' >"$tree/core/zstrip/kernels/vector/span.hpp"
printf '#pragma once\n#include "zstrip/kernels/vector/span.hpp"\n' >"$tree/core/zstrip/kernels/span.hpp"
echo '#include "zstrip/kernels/span.hpp"' >>"$tree/core/zstrip/scene/twice.cpp"
passes includes.sh
echo '#include "zstrip/frame/order.hpp"' >>"$tree/core/zstrip/kernels/span.hpp"
fails_with "scene includes zstrip/kernels/span.hpp of the later stage frame" includes.sh
mkdir -p "$tree/core/zstrip/kernels/vector"
printf '#pragma once\n' >"$tree/core/zstrip/kernels/vector/span.hpp"
echo '#include "zstrip/kernels/vector/span.hpp"' >>"$tree/core/zstrip/scene/twice.cpp"
fails_with "which only kernels do" includes.sh
echo '#include "zstrip/base/gone.hpp"' >>"$tree/core/zstrip/scene/twice.cpp"
fails_with "zstrip/base/gone.hpp does not exist" includes.sh
echo '#include "fixed.hpp"' >>"$tree/core/zstrip/base/fixed.hpp"
fails_with "core includes fixed.hpp" includes.sh

printf '#pragma once\n#include "zstrip/base/fixed.hpp"\n' >"$tree/core/zstrip/zstrip.hpp"
fails_with "is no public header of core" includes.sh

# A wing that the lists have, one that they lack, and an order of stages that names an effect.
wing() {
  mkdir -p "$tree/core/zstrip/effects/fog"
  touch "$tree/core/zstrip/effects/fog/effect.hpp" "$tree/core/zstrip/effects/fog/fog_stage.hpp"
  printf '#include "zstrip/effects/fog/effect.hpp"\nusing All = List<fog::Effect>;\n' >"$tree/core/zstrip/effects/list.hpp"
  echo 'using Stages = StageList<fog::Stage>;' >"$tree/core/zstrip/effects/stages.hpp"
}
passes wings.sh g++
wing
passes wings.sh g++
mkdir "$tree/core/zstrip/effects/rain"
fails_with "rain/ has no effect.hpp" wings.sh g++
wing
mkdir "$tree/core/zstrip/effects/rain"
touch "$tree/core/zstrip/effects/rain/effect.hpp"
fails_with "list.hpp lacks rain" wings.sh g++
wing
sed -i 's/fog::Stage//' "$tree/core/zstrip/effects/stages.hpp"
fails_with "stages.hpp lacks the stage of fog" wings.sh g++
echo 'if constexpr (effects.has(effect::fog)) return;' >"$tree/core/zstrip/frame/frame_order.hpp"
fails_with "names an effect" wings.sh g++

mkdir "$tree/misc"
fails_with "unexpected at the top level: misc" layout.sh
echo "# see /""home/somebody/notes" >"$tree/README.md"
fails_with "paths of one machine" layout.sh

passes words.sh
echo "/// Nobody reads it." >>"$tree/hal/zstrip_hal/bus.hpp"
fails_with "not a term of the field" words.sh
echo 'inline constexpr int kMostBytes = 1;' >>"$tree/core/zstrip/base/fixed.hpp"
fails_with "limits begin with kMax or kMin" words.sh
printf '%119d\n```\n%120d\n```\n| %120d |\n' 0 0 0 >"$tree/README.md"
passes words.sh
printf '%120d\n' 0 >"$tree/README.md"
fails_with "prose that reaches column 120" words.sh

echo 'int* take() { return new int; }' >>"$tree/core/zstrip/scene/twice.cpp"
fails_with "_Znwm" freestanding.sh g++
echo 'volatile int seed;
int drawn = twice(seed);' >>"$tree/core/zstrip/scene/twice.cpp"
fails_with "runs before main" freestanding.sh g++
if command -v arm-none-eabi-g++ >/dev/null; then
  echo 'float half(float value) { return value / 2; }' >>"$tree/core/zstrip/scene/twice.cpp"
  fails_with "__aeabi_f" freestanding.sh arm-none-eabi-g++ -mcpu=cortex-m3 -mthumb
fi

if is_version_14 clang-format; then
  echo 'int   spaced( );' >>"$tree/core/zstrip/scene/twice.cpp"
  fails_with "./core/zstrip/scene/twice.cpp" format.sh
fi

# Two sources that compile joined, and only so.
joined() {
  mkdir -p "$tree"/{host-sim,build}
  printf '#include <string>\nstd::string name() { return "a"; }\n' >"$tree/host-sim/a.cpp"
  printf '#include <string>\nstd::string other() { return "b"; }\n' >"$tree/host-sim/b.cpp"
  mkdir -p "$tree/build/Unity"
  printf '#include "%s"\n' "$tree"/host-sim/{a,b}.cpp >"$tree/build/Unity/unity.cxx"
  printf '[{\n  "directory": "%s",\n  "command": "c++ -std=c++20 -o x.dir/unity.o -c %s",\n  "file": "%s"\n}]\n' \
    "$tree" "$tree/build/Unity/unity.cxx" "$tree/build/Unity/unity.cxx" >"$tree/build/compile_commands.json"
}
joined
passes each_file.sh "$tree/build"
sed -i 1d "$tree/host-sim/b.cpp"
fails_with "host-sim/b.cpp does not compile by itself" each_file.sh "$tree/build"

if is_version_14 clang-tidy; then
  # The tree's own description of how it is compiled.
  database() {
    printf '[{\n  "directory": "%s",\n  "command": "c++ -std=c++20 -Icore -c %s",\n  "file": "%s"\n}]\n' \
      "$tree" "$tree/core/zstrip/scene/twice.cpp" "$tree/core/zstrip/scene/twice.cpp" >"$tree/compile_commands.json"
  }
  database
  passes tidy.sh "$tree"
  database
  echo 'int BadName() { return 0; }' >>"$tree/core/zstrip/scene/twice.cpp"
  fails_with "BadName" tidy.sh "$tree"
  fails_with "no compile_commands.json" tidy.sh "$tree"
fi

exit "$failed"
