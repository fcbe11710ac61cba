#!/usr/bin/env bash
# zstrip_package_npm.sh FOLDER [URL]: writes zstrip for pages and Node.js, a player of baked scenes in WebAssembly:
# FOLDER/package and FOLDER/zstrip-npm-VERSION.tgz. Builds in FOLDER/build. Needs clang, lld, cmake, ninja and the C++ headers
# of the Arm compiler. URL: where zstrip is to be found, for the file that says it.
# Exit status 1 if it cannot be built; 2 for wrong words.
set -euo pipefail
if [ $# -lt 1 ] || [ $# -gt 2 ]; then
  sed -n '2,5s/^# //p' "${BASH_SOURCE[0]}" >&2
  exit 2
fi
source "$(dirname "${BASH_SOURCE[0]}")/zstrip_package_files.sh"
source=$zstrip_root/firmware/wasm
mkdir -p "$1"
cd "$1"

cmake -S "$source" -B build -G Ninja -DCMAKE_TOOLCHAIN_FILE="$zstrip_root/cmake/toolchains/wasm32.cmake" >build.log
cmake --build build --parallel 2 >>build.log || { cat build.log >&2; exit 1; }

rm -rf package
mkdir package
cp "$source"/{package.json,README.md,zstrip.mjs} build/zstrip.wasm "$zstrip_root/LICENSE" package
zstrip_write_out package "${2-}"
zstrip_archive package >"zstrip-npm-$zstrip_version.tgz"
