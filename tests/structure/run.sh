#!/usr/bin/env bash
# run.sh ROOT: host-sim/run names the packages that a machine lacks, builds the programs for boards that a command needs,
# and says what it waits for. Programs are found through a folder of links, in which the tools that a machine lacks
# really are not there.
set -euo pipefail
root=$1
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
failed=0

mkdir -p "$tree"/{cmake,host-sim,bin}
cp "$root"/cmake/zstrip_{build.sh,packages.txt} "$tree/cmake"
cp "$root/host-sim/run" "$tree/host-sim"
find -L /usr/bin /bin -maxdepth 1 -type f -exec ln -sf -t "$tree/bin" {} + 2>/dev/null || true  # loops of links
# Each case puts in those of these that its machine has.
rm -f "$tree"/bin/{dpkg*,apt*,sudo,cmake*,ctest*,ninja*,qemu-*}

# puts PROGRAM BODY: a program of this machine, for the next case.
puts() {
  printf '#!/bin/sh\n%s\n' "$2" >"$tree/bin/$1"
  chmod +x "$tree/bin/$1"
}

# As a newcomer runs it, on a machine without Debian's packages.
status=0
output=$(PATH=$tree/bin bash "$tree/host-sim/run" scenes 2>&1) || status=$?
if [ "$status" -ne 3 ]; then echo "host-sim/run without packages ended with $status, not 3: $output"; failed=1; fi
for name in $(awk '$1 == "host" { print $2 }' "$root/cmake/zstrip_packages.txt"); do
  sed 's/^ *//' <<<"$output" | grep -xF -- "$name" >/dev/null || { echo "does not name $name: $output"; failed=1; }
done

# Programs for boards that the command lists are built, and no others.
cached='ZSTRIP_FIRMWARE:BOOL=OFF\n'
machine() {
  rm -rf "$tree/build" "$tree/asked"
  mkdir -p "$tree/build/host/host-sim"
  printf "$cached" >"$tree/build/host/CMakeCache.txt"
  touch "$tree/build/host/build.ninja" "$tree/asked"
  for program in zstrip zstrip-measure; do
    puts $program 'case "$*" in *--list-programs) printf "'"$1"'" ;; *) echo "ran zstrip $*" ;; esac'
    mv "$tree/bin/$program" "$tree/build/host/host-sim"
  done
  puts cmake 'echo "$*" >>"'"$tree"'/asked"'
  for program in ninja qemu-system-arm; do puts "$program" 'exit 0'; done
}
run() { PATH=$tree/bin bash "$tree/host-sim/run" "$@" 2>&1; }
# builds LISTED ARGUMENTS: what host-sim/run asks CMake for, where the command lists these programs.
builds() {
  local listed=$1
  shift
  machine "$listed"
  output=$(run "$@") || { echo "host-sim/run $* failed: $output"; failed=1; }
  grep -qxF "ran zstrip $*" <<<"$output" || { echo "host-sim/run $* does not run the command: $output"; failed=1; }
  sed -i "s|$tree/build/host|BUILD|" "$tree/asked"
}
asks() { grep -qF -- "$1" "$tree/asked" || { echo "is not asked for: $1"; cat "$tree/asked"; failed=1; }; }
asks_not() { if grep -qE -- "$1" "$tree/asked"; then echo "is asked for: $1"; cat "$tree/asked"; failed=1; fi; }

builds 'zstrip_bench_m3\n' bench --target m3
asks "--preset host -DZSTRIP_FIRMWARE=ON"
asks "--target firmware_cortex-m3-configure"
asks "--build BUILD/firmware/cortex-m3 --target zstrip_bench_m3"
asks_not 'cortex-m[04]|--target firmware$|SCENE_EFFECTS'
builds 'zstrip_bench_depth_m4f\nzstrip_bench_rv32\n' bench --target m4f,rv32
asks "--build BUILD/firmware/cortex-m4 --target zstrip_bench_depth_m4f"
asks "--build BUILD/firmware/rv32imac --target zstrip_bench_rv32"
for arguments in "scenes" "render m3 --target m3" "bench --target m3 --firmware there" "bench --target m3 --firmware=there"; do
  # shellcheck disable=SC2086
  builds 'zstrip_bench_m3\n' $arguments
  asks_not 'firmware|FIRMWARE=ON'
done
builds '' bench --target host
asks_not 'firmware|FIRMWARE=ON'
builds 'zstrip_scene_m3_8\n' accuracy cube
asks_not 'firmware|FIRMWARE=ON'

# In a tree where tests run nothing is configured again.
cached='ZSTRIP_FIRMWARE:BOOL=ON\n'
builds 'zstrip_scene_m3_8\nzstrip_scene_m3_9\n' accuracy cube --target m3
asks "-DZSTRIP_SCENE_EFFECTS=8;9 BUILD/firmware/cortex-m3"
asks "--build BUILD/firmware/cortex-m3 --target zstrip_scene_m3_8 zstrip_scene_m3_9"
asks_not 'cortex-m0|--preset host -D'

# A command that lacks a rare pipeline is run again when that is built.
machine ''
puts zstrip '[ -e "'"$tree"'/asked.any" ] || { [ -n "$ZSTRIP_BUILDS" ] && exit 75; exit 3; }; echo "ran zstrip $*"'
mv "$tree/bin/zstrip" "$tree/build/host/host-sim"
puts cmake 'case "$*" in *zstrip-any*) touch "'"$tree"'/asked.any" ;; esac'
output=$(run render teapot --visibility painter) || { echo "host-sim/run does not build zstrip-any: $output"; failed=1; }
grep -qxF "ran zstrip render teapot --visibility painter" <<<"$output" ||
  { echo "does not run the command again: $output"; failed=1; }

# While another build runs: help is there at once, all else says what it waits for.
machine ''
exec 8>>"$tree/build/.lock"
flock 8
echo "process 7 is building" >"$tree/build/.lock"
for arguments in "--help" "bench --help" "render -h" "--version"; do
  # shellcheck disable=SC2086
  output=$(timeout 5 env PATH="$tree/bin" bash "$tree/host-sim/run" $arguments 2>&1) || true
  [ "$output" = "ran zstrip $arguments" ] || { echo "host-sim/run $arguments waits for a build: $output"; failed=1; }
done
asks_not .
run scenes >"$tree/said" &
for ((tenths = 0; tenths < 600; ++tenths)); do
  if grep -q waiting "$tree/said"; then break; fi
  sleep 0.1
done
flock --unlock 8
wait $! || true
output=$(cat "$tree/said")
[ "$output" = $'zstrip: another zstrip build runs (process 7 is building); waiting\nran zstrip scenes' ] ||
  { echo "does not say what it waits for: $output"; failed=1; }
exec 8>&-
rm "$tree/build/host/host-sim/zstrip"
output=$(run --help) || true
grep -qF "zstrip: the command is not built yet: building it first" <<<"$output" || { echo "help is built without a word: $output"; failed=1; }
asks "--target zstrip"

exit "$failed"
