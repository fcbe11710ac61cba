#!/usr/bin/env bash
# program_by_cmake.sh ROOT ZSTRIP SCRATCH COMPILER: a project as the first comment of the program has it builds, and it
# draws what `zstrip render` does.
set -euo pipefail
rm -rf "$3"
mkdir -p "$3/project"
cd "$3/project"
options=(--size 64x48 --ram 12K)
"$2" bake teapot -o scene.hpp --turntable --quiet "${options[@]}"
"$2" bake teapot -o my_scene.cpp --turntable --quiet "${options[@]}"
ln -s "$1" zstrip
sed -n '/^\/\/     cmake_minimum/,/^[^/]/s|^//     ||p' my_scene.cpp >CMakeLists.txt
cmake -S . -B build -G Ninja -DCMAKE_CXX_COMPILER="$4" -DZSTRIP_COMPILE_TOGETHER=whole-core
cmake --build build --target scene
"$2" render teapot -o frames/ --frames 2 --image raw --quiet "${options[@]}"
build/scene picture.raw 4096
cmp picture.raw frames/frame_0001.raw
