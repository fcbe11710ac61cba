#!/usr/bin/env bash
# baked_pico_folder.sh ROOT ZSTRIP SCRATCH COMPILER [SDK OPTION...]: the folder of `zstrip bake --project pico` is planned by its own
# CMakeLists.txt, as the folder's first lines say: with a stand-in for the Raspberry Pi Pico SDK its program is compiled by
# COMPILER, with the real one in the folder SDK it is built for a Pico.
set -euo pipefail
root=$(cd "$1" && pwd -P)
zstrip=$2 scratch=$3 compiler=$4 sdk=${5-}
rm -rf "$scratch"
mkdir -p "$scratch"
"$zstrip" bake teapot -o "$scratch/teapot/" --project pico --quiet "${@:6}"
cd "$scratch/teapot"
if [ -n "$sdk" ]; then
  echo 'int main() {}' >"$scratch/empty.cpp"
  arm-none-eabi-g++ -mcpu=cortex-m0plus -mthumb --specs=nosys.specs "$scratch/empty.cpp" -o "$scratch/empty.elf" 2>"$scratch/said" || {
    cat "$scratch/said"; echo "arm-none-eabi-g++ with libstdc++-arm-none-eabi-newlib is not installed"; exit 77; }
  # Without picotool, which the SDK would build from sources that it downloads.
  cmake -S . -B build -G Ninja -DPICO_SDK_PATH="$sdk" -DZSTRIP_PATH="$root" -DPICO_NO_PICOTOOL=1
  cmake --build build --target teapot
  arm-none-eabi-size build/teapot.elf
else
  said=$(cmake -S . -B build -G Ninja -DCMAKE_CXX_COMPILER="$compiler" -DPICO_SDK_PATH="$scratch" 2>&1) && {
    echo "a folder without an SDK is taken for one"; exit 1; }
  # CMake breaks the lines of a message.
  tr -s ' \n' ' ' <<<"$said" | grep -q 'is not the folder of PICO_SDK_PATH; name it by -DPICO_SDK_PATH=' || { echo "$said"; exit 1; }
  rm -r build
  cmake -S . -B build -G Ninja -DCMAKE_CXX_COMPILER="$compiler" -DPICO_SDK_PATH="$root/tests/package/pico_sdk" \
    -DZSTRIP_PATH="$root"
  # BakedFolder_OnPico links and runs it.
  cmake --build build --target CMakeFiles/teapot.dir/main.cpp.o
fi
