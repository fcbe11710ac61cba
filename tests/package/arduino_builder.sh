#!/usr/bin/env bash
# arduino_builder.sh ROOT SCRATCH [ZSTRIP]: arduino-builder takes the package in and builds sketches of it, and that of
# `zstrip bake`, for a board package of the tests' own, for Cortex-M0+: the first one and the baked one; with ZSTRIP_LONG all
# that need no library of displays. Without it they are built without optimisation, and the core's sources as one. With
# C++17 one error says what to do.
set -euo pipefail
root=$(cd "$1" && pwd -P)
here=$root/tests/package
for tool in arduino-builder arm-none-eabi-g++; do
  command -v "$tool" >/dev/null || { echo "$tool is not installed"; exit 77; }
done
rm -rf "$2"
mkdir -p "$2/libraries"
scratch=$(cd "$2" && pwd -P)
bash "$root/cmake/zstrip_package_sources.sh" "$scratch"
mv "$scratch/zstrip" "$scratch/libraries"
if [ -n "${3-}" ]; then
  baked=$scratch/libraries/zstrip/examples/Baked
  mkdir "$baked"
  for name in scene.hpp Baked.ino; do
    "$3" bake teapot -o "$baked/$name" --size 240x240 --format rgb565_swapped --ram 14K --split-columns --turntable --quiet
  done
fi

# build SKETCH OPTION...
build() {
  local sketch=$1
  shift
  rm -rf "$scratch/build"
  mkdir "$scratch/build"
  arduino-builder -compile -hardware /usr/share/arduino-builder -hardware "$here/arduino/hardware" \
    -tools /usr/share/arduino-builder -libraries "$scratch/libraries" -fqbn zstrip:test:m0plus \
    -build-path "$scratch/build" "-prefs=build.keep=$here/keep_object.sh" "-prefs=build.kept=$scratch/kept" \
    -prefs=build.optimisation=$optimisation -warnings all "$@" "$scratch/libraries/zstrip/examples/$sketch/$sketch.ino" >"$scratch/said" 2>&1
}

optimisation=-O0
mkdir "$scratch/kept"
if [ -n "${ZSTRIP_LONG-}" ]; then
  optimisation=-Os
else
  touch "$scratch/kept/none.cpp"
  find "$scratch/libraries/zstrip/src/zstrip" -name '*.cpp' -printf '#include "%p"\n' | sort >"$scratch/kept/core.cpp"
fi
failed=0
first=HelloPyramid
read -r -d '' -a others < <(cd "$scratch/libraries/zstrip/examples" && grep -L 'adapters::' */*.ino | sed "s|/.*||; /^$first$/d") || true
[ ${#others[@]} -ge 4 ] || { echo "the package has no sketches"; failed=1; }
if [ -z "${ZSTRIP_LONG-}" ]; then others=(${3:+Baked}); fi
for sketch in $first "${others[@]}"; do
  if ! build "$sketch"; then
    echo "$sketch is not built:"
    failed=1
  elif grep -q 'warning:' "$scratch/said"; then
    echo "$sketch is built with warnings:"
    failed=1
  else
    arm-none-eabi-size "$scratch/build/$sketch.ino.elf" | awk -v name="$sketch" 'NR == 2 { print name ": " $1 + $2 " bytes of flash, " $2 + $3 " of RAM" }'
    continue
  fi
  cat "$scratch/said"
done

if build $first -prefs=build.standard=gnu++17; then
  echo "it is built as C++17"
  failed=1
elif [ "$(grep -c 'error: #error' "$scratch/said")" -ne 1 ] || [ "$(grep -c 'error:' "$scratch/said")" -ne 2 ] ||
     ! grep -q 'error: #error zstrip needs C++20.* Arduino: .* PlatformIO: .* ESP-IDF: .* Zephyr: .* STM32CubeIDE: .* CMake: ' "$scratch/said"; then
  echo "an older language does not end with one error that says what to do:"
  cat "$scratch/said"
  failed=1
fi
exit "$failed"
