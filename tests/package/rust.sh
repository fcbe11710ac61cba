#!/usr/bin/env bash
# rust.sh ROOT SCRATCH ZSTRIP: the crate for Rust, built by rustc and its build.rs as cargo would, but without cargo. Its
# example draws the frames of `zstrip render`, byte for byte; its functions do what they promise; its features are the
# effects that there are. For a Cortex-M0+ its C++ needs no function that Rust does not bring.
set -euo pipefail
root=$(cd "$1" && pwd -P)
zstrip=$3
for tool in rustc g++ ar; do
  command -v "$tool" >/dev/null || { echo "skipped: $tool is not installed"; exit 77; }
done
rm -rf "$2"
mkdir -p "$2"
cd "$2"
failed=0
complain() {
  echo "$*"
  failed=1
}

# The same sources give the same bytes.
(umask 077 && TZ=Asia/Tokyo bash "$root/cmake/zstrip_package_rust.sh" "$PWD/again")
bash "$root/cmake/zstrip_package_rust.sh" "$PWD"
cmp zstrip-rust-*.tar.gz again/zstrip-rust-*.tar.gz || complain "another archive a second time"
crate=$PWD/zstrip-rust
version=$(sed -n 's/^version = "\(.*\)"/\1/p' "$crate/Cargo.toml")
[ -s "zstrip-rust-$version.tar.gz" ] || complain "there is no archive of version $version"
if grep -rn '@[A-Z]*@' "$crate"/{Cargo.toml,build.rs,src}; then complain "a file is not written out"; fi

features=$(sed -n 's/^\([a-z_0-9]*\) = \[\]$/\1/p' "$crate/Cargo.toml")
effects=$(grep -rhoE '\{effect::[a-z_0-9]+, "[a-z_0-9]+"' "$root/core/zstrip/effects" | sed 's/.*"\(.*\)"/\1/' | sort -u)
diff <(echo "$features") <(echo "$effects") || complain "the crate's features (<) are not the effects (>)"

# build_script TARGET OUT: runs build.rs with the default features, and prints what it tells cargo.
rustc --edition 2021 -D warnings "$crate/build.rs" -o build_script
defaults=$(sed -n 's/^default = \[\(.*\)\]/\1/p' "$crate/Cargo.toml" | tr -d '",' | tr a-z A-Z)
build_script() {
  local feature variables=()
  for feature in $defaults; do variables+=("CARGO_FEATURE_$feature=1"); done
  mkdir "$2"
  env "${variables[@]}" CARGO_FEATURE_DEFAULT=1 TARGET="$1" CARGO_MANIFEST_DIR="$crate" OUT_DIR="$PWD/$2" NUM_JOBS=2 ./build_script
}
# The compiler behind another program, as behind ccache.
host=$(rustc --version --verbose | sed -n 's/^host: //p')
CXX='env g++' CXXFLAGS=-O1 build_script "$host" host >said
read -r -a flags <<<"$(sed -n -e 's/^cargo:rustc-link-search=/-L /p' -e 's/^cargo:rustc-link-lib=/-l /p' said | tr '\n' ' ')"
[ ${#flags[@]} -eq 4 ] || complain "build.rs names no library: $(cat said)"
rustc --edition 2021 -O -D warnings --crate-type rlib --crate-name zstrip "${flags[@]}" "$crate/src/lib.rs"
for program in "$crate/examples/picture.rs" "$root/tests/package/rust/calls.rs"; do
  rustc --edition 2021 -O -D warnings --extern zstrip=libzstrip.rlib "$program"
done

# same NAME FRAMES WORDS...: frames of `zstrip render NAME.zsc WORDS` are those of the example.
same() {
  local name=$1 frames=$2
  shift 2
  rm -rf expected
  "$zstrip" render "$name.zsc" "${view[@]}" --frames "$frames" --image raw --format rgb565 -o expected "$@"
  ./picture "$name.zsc" 160 120 "$frames" ${2+"$2"} >drawn.raw || complain "$name is not drawn"
  cat expected/*.raw | cmp - drawn.raw || complain "$name differs"
}
view=(--size 160x120 --quiet)
for scene in teapot room "$root/host-sim/scenes/figure/figure.gltf"; do
  "$zstrip" bake "$scene" -o "$(basename "${scene%.*}").zsc" "${view[@]}" --turntable
done
same teapot 8
same room 8
same figure 3 --animation wave

picked=$(./calls figure.zsc room.zsc 80 60) || complain "a function does not do what it promises"
"$zstrip" render room.zsc "${view[@]}" -o room.png --pick 80,60 --json picked.json
expected=$(python3 -c '
import json
at = json.load(open("picked.json"))["frames"][0]["picked"]
print(at["shown"].capitalize(), at["index"], at["triangle"], str("texture" in at).lower())')
[ "$picked" = "$expected" ] || complain "picked is $picked, not $expected"

# A mutant: without its last byte a scene is refused, and the example says why.
head -c -1 room.zsc >cut.zsc
if ./picture cut.zsc 160 120 1 2>said >/dev/null || ! grep -q 'no whole scene' said; then complain "a cut scene: $(cat said)"; fi

if command -v arm-none-eabi-g++ >/dev/null; then
  build_script thumbv6m-none-eabi thumb >said
  # Rust's compiler_builtins has these, and the crate its own.
  own=$(sed -n 's/^extern "C" fn \(__[a-z0-9]*\)(.*/\1/p' "$crate/src/lib.rs")
  missing=$(comm -23 \
    <(arm-none-eabi-nm -u thumb/libzstrip_player.a | sed -n 's/^ *U //p' | sort -u) \
    <(arm-none-eabi-nm --defined-only thumb/libzstrip_player.a | sed -n 's/^[0-9a-f]* [A-Za-z] //p' | sort -u) |
    grep -vE '^(mem(cpy|move|set|cmp)|__aeabi_(mem(cpy|move|set|clr)[48]?|u?(i|l)div(mod)?|uidiv|lmul|llsl|llsr|lasr)|__(clz|ctz)[sd]i2)$' | grep -vxF "$own" || true)
  if [ -n "$missing" ]; then complain "functions that Rust does not bring: $missing"; fi
  arm-none-eabi-size -t thumb/libzstrip_player.a | awk 'END { print "all functions for a Cortex-M0+: " $1 " bytes" }'
else
  echo "for a Cortex-M0+ nothing is compiled: arm-none-eabi-g++ is not installed"
fi
rustc --version
exit "$failed"
