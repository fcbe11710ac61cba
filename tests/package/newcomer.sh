#!/usr/bin/env bash
# newcomer.sh FOLDER: what FOLDER has of a release (cmake/zstrip_release.sh) is installed and used from there alone: nothing
# of the repository is read. Everything that draws draws the picture of the command that the release has. Without the
# packages for Debian there is no such command: then only sums and contents are looked at.
set -euo pipefail
release=$(cd "$1" && pwd -P)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"
failed=0
complain() {
  echo "$*"
  failed=1
}
tried() { echo "works: $*"; }
# file PATTERN: the release's only file of this pattern; false if there is none.
file() {
  local found
  found=$(find "$release" -maxdepth 1 -name "$1" | sort)
  [ -n "$found" ] || return 1
  [ "$(wc -l <<<"$found")" -eq 1 ] || { echo "$release has several files $1" >&2; exit 1; }
  echo "$found"
}
# missing TOOL...: says what is not installed; false if everything is.
missing() {
  local tool
  for tool in "$@"; do
    command -v "$tool" >/dev/null || { echo "not tried, because $tool is not installed: ${FUNCNAME[1]}"; return 0; }
  done
  return 1
}
# same PICTURE WHO: it is the command's picture.
same() {
  if cmp -s "$1" expected.raw; then tried "$2"; else complain "$2 draws another picture, or none"; fi
}

(cd "$release" && sha256sum --check --quiet SHA256SUMS) || complain "SHA256SUMS are not those of the files"

zstrip=
debian() {
  local command library flags
  missing dpkg-deb pkg-config g++ && return
  command=$(file 'zstrip_*_*.deb') && library=$(file 'libzstrip-dev_*.deb') || return 0
  dpkg-deb -x "$command" system
  dpkg-deb -x "$library" system
  zstrip=$scratch/system/usr/bin/zstrip
  mkdir scene
  for name in scene.hpp main.cpp scene.zsc; do "$zstrip" bake knot -o "scene/$name" --size 160x120 --quiet; done
  "$zstrip" render knot -o expected.raw --format rgb565 --size 160x120 --quiet
  PKG_CONFIG_LIBDIR=$(find "$scratch/system" -type d -name pkgconfig)
  export PKG_CONFIG_LIBDIR
  read -r -a flags <<<"$(pkg-config --cflags --libs zstrip-player)"
  if g++ -std=c++20 -O1 scene/main.cpp "${flags[@]}" -o by_debian; then ./by_debian by_debian.raw || true; fi
  same by_debian.raw "a program with libzstrip-dev"
}

packages() {
  local archive sources
  archive=$(file "zstrip-[0-9]*[0-9].tar.gz") || return 0
  missing g++ cmake && return
  mkdir tar zip
  tar -C tar -xzf "$archive"
  (cd zip && cmake -E tar xf "$(file 'zstrip-[0-9]*.zip')")
  diff -r tar zip || complain "the .zip differs from the .tar.gz"
  [ -n "$zstrip" ] || return 0
  # One by one they take a minute: arduino-builder compiles them so.
  read -r -d '' -a sources < <(find tar/zstrip/src -name '*.cpp' | sort) || true
  printf '#include "%s"\n' "${sources[@]}" >package.cpp
  if g++ -std=c++20 -ffunction-sections -fdata-sections -Wl,--gc-sections -Itar/zstrip/src scene/main.cpp \
      package.cpp -o by_package; then
    ./by_package by_package.raw || true
  fi
  same by_package.raw "a program with the package for microcontrollers"
  "$zstrip" bake knot -o Knot/ --quiet
  [ -s Knot/Knot.ino ] && [ -s Knot/scene.hpp ] || complain "the command writes no sketch"
}

npm() {
  local archive
  archive=$(file 'zstrip-npm-*.tgz') || return 0
  missing node && return
  [ -n "$zstrip" ] || return 0
  mkdir -p page/node_modules/zstrip
  tar -C page/node_modules/zstrip --strip-components 1 -xzf "$archive"
  cat >page/draw.mjs <<'JS'
import { readFileSync, writeFileSync } from 'node:fs';
import { load } from 'zstrip';
const scene = await (await load()).open(readFileSync('../scene/scene.zsc'), { width: 160, height: 120 });
const drawn = scene.draw(0);
const pixels = new Uint16Array(160 * 120);
pixels.forEach((_, i) => {
  const [red, green, blue] = drawn.subarray(4 * i, 4 * i + 3);
  pixels[i] = ((red >> 3) << 11) | ((green >> 2) << 5) | (blue >> 3);
});
writeFileSync('../by_npm.raw', pixels);
JS
  (cd page && node draw.mjs) || true
  same by_npm.raw "a program of Node.js with the package of npm"
}

# The crate is built as cargo would, without cargo.
rust() {
  local archive feature crate=$scratch/rust/crate variables=() flags=()
  archive=$(file 'zstrip-rust-*.tar.gz') || return 0
  missing rustc g++ ar && return
  [ -n "$zstrip" ] || return 0
  mkdir -p "$crate" rust/out
  tar -C "$crate" --strip-components 1 -xzf "$archive"
  for feature in $(sed -n 's/^default = \[\(.*\)\]/\1/p' "$crate/Cargo.toml" | tr -d '",' | tr '[:lower:]' '[:upper:]'); do
    variables+=("CARGO_FEATURE_$feature=1")
  done
  if (
    cd rust
    rustc --edition 2021 "$crate/build.rs" -o build_script
    env "${variables[@]}" TARGET="$(rustc --version --verbose | sed -n 's/^host: //p')" CXX=g++ CXXFLAGS=-O1 \
      CARGO_MANIFEST_DIR="$crate" OUT_DIR="$PWD/out" NUM_JOBS=2 ./build_script >said
    read -r -a flags <<<"$(sed -n -e 's/^cargo:rustc-link-search=/-L /p' -e 's/^cargo:rustc-link-lib=/-l /p' said | tr '\n' ' ')"
    rustc --edition 2021 -O --crate-type rlib --crate-name zstrip "${flags[@]}" "$crate/src/lib.rs"
    rustc --edition 2021 -O --extern zstrip=libzstrip.rlib "$crate/examples/picture.rs"
  ); then
    rust/picture scene/scene.zsc 160 120 1 >by_rust.raw || true
  fi
  same by_rust.raw "a program with the crate for Rust"
}

micropython() {
  local archive name
  archive=$(file 'zstrip-micropython-*.tar.gz') || return 0
  mkdir micropython
  tar -C micropython --strip-components 1 -xzf "$archive"
  for name in Makefile flags.mk micropython.mk micropython.cmake zstrip_module.c pipeline.cpp cpp/zstrip_player.h LICENSE; do
    [ -s "micropython/$name" ] || complain "the module for MicroPython has no $name"
  done
  echo "not tried, because no release of MicroPython is in it: the module for MicroPython"
}

pico() {
  local board
  for board in pico pico2; do
    file "zstrip_${board}_player.uf2" >/dev/null || continue
    [ -n "$zstrip" ] || return 0
    if "$zstrip" bake knot -o "$board.uf2" --board "$board" --with "$release/zstrip_${board}_player.uf2" --quiet; then
      tried "zstrip bake with zstrip_${board}_player.uf2"
    else
      complain "zstrip bake does not take zstrip_${board}_player.uf2"
    fi
  done
}

sources() {
  local archive
  archive=$(file 'zstrip-*-source.tar.gz') || return 0
  missing g++ cmake ninja && return
  [ -n "$zstrip" ] || return 0
  tar -xzf "$archive"
  mv zstrip-[0-9]* scene/zstrip
  cat >scene/CMakeLists.txt <<'CMAKE'
cmake_minimum_required(VERSION 3.22)
project(scene LANGUAGES CXX)
add_subdirectory(zstrip)
add_executable(scene main.cpp)
target_link_libraries(scene PRIVATE zstrip::player)
CMAKE
  if cmake -S scene -B by_source -G Ninja -DCMAKE_BUILD_TYPE=Release >said && cmake --build by_source >said; then
    by_source/scene by_source.raw || true
  else
    tail -n 20 said
  fi
  same by_source.raw "a program with the sources"
}

pages() {
  local archive
  for archive in playground site; do
    archive=$(file "zstrip-$archive-*.tar.gz") || continue
    mkdir pages
    tar -C pages --strip-components 1 -xzf "$archive"
    if [ -s pages/index.html ]; then tried "${archive##*/} has its first page"; else complain "$archive has no first page"; fi
    rm -r pages
  done
}

debian
packages
npm
rust
micropython
pico
sources
pages
exit "$failed"
