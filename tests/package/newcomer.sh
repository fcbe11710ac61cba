#!/usr/bin/env bash
# newcomer.sh FOLDER: what FOLDER has of a release (cmake/zstrip_release.sh) is installed and used from there alone: nothing
# of the repository is read. Everything that draws draws the picture of the command that the release has. Without the
# packages for Debian there is no such command: then only sums and contents are looked at. Exit status 1 if something does
# not work, if the release has a command and nothing drew, or if it has files and nothing was looked at.
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
looked_at=0 drawn=0
tried() {
  echo "works: $*"
  looked_at=$((looked_at + 1))
}
# file VARIABLE PATTERN: sets the variable to the release's only file of this pattern; false if there is none. Several end
# the script: that is why this is called without a subshell.
file() {
  local found
  found=$(find "$release" -maxdepth 1 -name "$2" | sort)
  [ -n "$found" ] || return 1
  [ "$(wc -l <<<"$found")" -eq 1 ] || { echo "$release has several files $2"; exit 1; }
  printf -v "$1" %s "$found"
}
# holds FOLDER WHAT FILE...: the unpacked files are there and not empty.
holds() {
  local file folder=$1 what=$2 complete=yes
  shift 2
  for file in "$@"; do
    [ -s "$folder/$file" ] || { complain "$what has no $file"; complete=; }
  done
  if [ -n "$complete" ]; then tried "$what has its files"; fi
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
  if cmp -s "$1" expected.raw; then
    tried "$2"
    drawn=$((drawn + 1))
  else
    complain "$2 draws another picture, or none"
  fi
}

(cd "$release" && sha256sum --check --quiet SHA256SUMS) || complain "SHA256SUMS are not those of the files"

has_command= zstrip=
debian() {
  local command library flags
  file command 'zstrip_*_*.deb' || return 0
  has_command=yes
  file library 'libzstrip-dev_*.deb' || { complain "the release has the command, but no libzstrip-dev"; return; }
  missing dpkg-deb pkg-config g++ && return
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
  local archive zip sources
  file archive 'zstrip-[0-9]*[0-9].tar.gz' || return 0
  mkdir tar zip
  tar -C tar -xzf "$archive"
  holds tar/zstrip "the package for microcontrollers" library.properties library.json idf_component.yml src/zstrip.h LICENSE
  missing g++ cmake && return
  if file zip 'zstrip-[0-9]*.zip'; then
    (cd zip && cmake -E tar xf "$zip")
    diff -r tar zip || complain "the .zip differs from the .tar.gz"
  else
    complain "the package for microcontrollers is there as .tar.gz alone"
  fi
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
  file archive 'zstrip-npm-*.tgz' || return 0
  mkdir -p page/node_modules/zstrip
  tar -C page/node_modules/zstrip --strip-components 1 -xzf "$archive"
  holds page/node_modules/zstrip "the package of npm" package.json
  missing node && return
  [ -n "$zstrip" ] || return 0
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
  file archive 'zstrip-rust-*.tar.gz' || return 0
  mkdir -p "$crate" rust/out
  tar -C "$crate" --strip-components 1 -xzf "$archive"
  holds "$crate" "the crate for Rust" Cargo.toml build.rs src/lib.rs examples/picture.rs
  missing rustc g++ ar && return
  [ -n "$zstrip" ] || return 0
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
  local archive
  file archive 'zstrip-micropython-*.tar.gz' || return 0
  mkdir micropython
  tar -C micropython --strip-components 1 -xzf "$archive"
  holds micropython "the module for MicroPython" Makefile flags.mk micropython.mk micropython.cmake zstrip_module.c \
    pipeline.cpp cpp/zstrip_player.h LICENSE
  echo "not tried, because no release of MicroPython is in it: the module for MicroPython"
}

pico() {
  local board program
  for board in pico pico2; do
    file program "zstrip_${board}_player.uf2" || continue
    if [ "$(head -c 4 "$program" | tr -d '\n')" = UF2 ]; then tried "zstrip_${board}_player.uf2 is a UF2 file"; else complain "zstrip_${board}_player.uf2 is no UF2 file"; fi
    [ -n "$zstrip" ] || continue
    if "$zstrip" bake knot -o "$board.uf2" --board "$board" --with "$program" --quiet; then
      tried "zstrip bake with zstrip_${board}_player.uf2"
    else
      complain "zstrip bake does not take zstrip_${board}_player.uf2"
    fi
  done
}

sources() {
  local archive
  file archive 'zstrip-*-source.tar.gz' || return 0
  mkdir unpacked
  tar -C unpacked --strip-components 1 -xzf "$archive"
  holds unpacked "the archive of sources" CMakeLists.txt README.md LICENSE core/zstrip/zstrip.hpp
  missing g++ cmake ninja && return
  [ -n "$zstrip" ] || return 0
  mv unpacked scene/zstrip
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
  local archive name
  for name in playground site; do
    file archive "zstrip-$name-*.tar.gz" || continue
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
if [ -n "$has_command" ] && [ "$drawn" -eq 0 ]; then complain "the release has a command, and nothing drew with it"; fi
if [ "$looked_at" -eq 0 ]; then complain "nothing of $release was looked at"; fi
exit "$failed"
