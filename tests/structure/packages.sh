#!/usr/bin/env bash
# packages.sh ROOT: what the scripts do about missing packages, on machines with and without Debian's tools. Programs are
# found through a folder of links, in which the tools that a machine lacks really are not there.
# shellcheck disable=SC2046  # lists of names are to be split
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

packages_of() { awk -v purposes=" $* " '!/^#/ && NF == 2 && index(purposes, " " $1 " ") { print $2 }' "$root/cmake/zstrip_packages.txt"; }

# ends_with STATUS WHAT PURPOSES...: zstrip_install_packages on this machine; the stamp is there only after success.
ends_with() {
  local expected=$1 what=$2 status=0 stamp
  shift 2
  output=$(PATH=$tree/bin bash -c 'set -euo pipefail
    source "$1/cmake/zstrip_build.sh"
    shift
    zstrip_with_lock zstrip_install_packages "$@"' _ "$tree" "$@" 2>&1) || status=$?
  stamp=$(find "$tree/build" -name '.packages-*')
  if [ "$status" -ne "$expected" ]; then echo "$what: ended with $status, not $expected: $output"; failed=1; fi
  if [ "$expected" -eq 0 ] && [ -z "$stamp" ]; then echo "$what: would look again next time"; failed=1; fi
  if [ "$expected" -ne 0 ] && [ -n "$stamp" ]; then echo "$what: would take the packages for installed"; failed=1; fi
  rm -rf "$tree/build" "$tree"/bin/{cmake,ninja,qemu-system-arm,dpkg-query,apt-get,apt-cache}
}

# says NAMES...: each on a line of its own in the output of the last case.
says() {
  local name
  for name in "$@"; do
    sed 's/^ *//' <<<"$output" | grep -xF -- "$name" >/dev/null || { echo "does not name $name: $output"; failed=1; }
  done
}

ends_with 3 "no Debian, no cmake" host
says $(packages_of host)

puts cmake 'exit 0'
puts ninja 'exit 0'
ends_with 0 "no Debian, everything is there" host

puts cmake 'echo "where is assimp"; exit 1'
puts ninja 'exit 0'
ends_with 3 "no Debian, configuring fails" host tests
says $(packages_of host tests) "where is assimp"

puts cmake 'exit 0'
puts ninja 'exit 0'
ends_with 3 "no Debian, no emulator" host firmware
says $(packages_of host firmware)

# What configuring is asked to look for.
puts cmake 'case "$*" in *-DZSTRIP_TESTS=ON*-DZSTRIP_FIRMWARE=ON*) exit 0 ;; esac; exit 1'
puts ninja 'exit 0'
puts qemu-system-arm 'exit 0'
ends_with 0 "no Debian, everything for the tests" host firmware tests

puts dpkg-query 'exit 2'
ends_with 3 "dpkg-query fails" host
says $(packages_of host)

puts dpkg-query "printf 'installed %s, \n' $(packages_of host | paste -sd ' ')"
ends_with 0 "Debian, all installed" host

puts dpkg-query "printf 'installed %s, \n' $(packages_of host | grep -vx cmake | paste -sd ' ')"
ends_with 3 "Debian without apt-get, cmake is missing" host
says cmake
if grep -qx ' *ninja-build' <<<"$output"; then echo "names a package that is installed: $output"; failed=1; fi

puts apt-cache 'exit 0'
puts apt-get 'exit 100'
puts dpkg-query 'exit 0'
if [ "$(id -u)" -eq 0 ]; then
  ends_with 3 "apt-get fails" host
fi
rm -f "$tree"/bin/{apt-cache,apt-get,dpkg-query}

# The whole script, as a newcomer runs it.
status=0
output=$(PATH=$tree/bin bash "$tree/host-sim/run" scenes 2>&1) || status=$?
if [ "$status" -ne 3 ]; then echo "host-sim/run without packages ended with $status, not 3: $output"; failed=1; fi
says $(packages_of host)

# A measurement on a board, and only that, has the programs for boards built: configured, built, and the command run.
cached='ZSTRIP_FIRMWARE:BOOL=OFF\n'
board_build() {
  rm -rf "$tree/build"
  mkdir -p "$tree/build/host/host-sim"
  printf "$cached" >"$tree/build/host/CMakeCache.txt"
  touch "$tree/build/host/build.ninja"
  puts zstrip 'case "$*" in *--list-programs) printf "zstrip_scene_%s_8\n" m0 m3 m3 ;; *) echo "ran zstrip $*" ;; esac'
  mv "$tree/bin/zstrip" "$tree/build/host/host-sim"
  puts cmake 'echo "$*" >>"'"$tree"'/asked"'
  for program in ninja qemu-system-arm; do puts "$program" 'exit 0'; done
  rm -f "$tree/asked"
  output=$(PATH=$tree/bin bash "$tree/host-sim/run" "$@" 2>&1) || { echo "host-sim/run $* failed: $output"; failed=1; }
  grep -qxF "ran zstrip $*" <<<"$output" || { echo "host-sim/run $* does not run the command: $output"; failed=1; }
  grep -q -- "--target firmware$" "$tree/asked" && grep -q -- "--preset host -DZSTRIP_FIRMWARE=ON" "$tree/asked"
}
for arguments in "bench --target m3" "bench --target=host,m4f --workload K5" "bench --frames 1 --target host m0"; do
  # shellcheck disable=SC2086
  board_build $arguments || { echo "host-sim/run $arguments does not build the programs for boards"; failed=1; }
done
for arguments in "bench" "bench --target host" "scenes" "render m3 --target m3" "bench --target m3 --firmware there"; do
  # shellcheck disable=SC2086
  if board_build $arguments; then echo "host-sim/run $arguments builds the programs for boards"; failed=1; fi
done


# Counting instructions of a scene's pipelines takes their programs and no others, on the cores that are named.
for arguments in "accuracy cube --target m3" "tune cube --target=m3" "accuracy --target host,m3 cube"; do
  # shellcheck disable=SC2086
  if board_build $arguments; then echo "host-sim/run $arguments builds all programs for boards"; failed=1; fi
  for expected in "--preset host -DZSTRIP_FIRMWARE=ON" "--target firmware_cortex-m3-configure" \
    "-DZSTRIP_SCENE_EFFECTS=8;8 $tree/build/host/firmware/cortex-m3" \
    "--build $tree/build/host/firmware/cortex-m3 --target zstrip_scene_m3_8 zstrip_scene_m3_8"; do
    grep -qF -- "$expected" "$tree/asked" || { echo "host-sim/run $arguments does not ask for $expected"; failed=1; }
  done
  if grep -q "cortex-m0" "$tree/asked"; then echo "host-sim/run $arguments asks for another core"; failed=1; fi
done
board_build accuracy cube && { echo "host-sim/run accuracy on the host builds programs for boards"; failed=1; }
if grep -q "SCENE_EFFECTS" "$tree/asked"; then echo "host-sim/run accuracy on the host asks for programs"; failed=1; fi

# In a tree where tests run: for counting no change of what others use.
cached='ZSTRIP_FIRMWARE:BOOL=ON\n'
if board_build accuracy cube --target m3; then echo "host-sim/run accuracy builds all programs for boards"; failed=1; fi
if grep -q -- "--preset host -D" "$tree/asked"; then
  echo "host-sim/run accuracy configures the tree in which tests run"
  failed=1
fi

exit "$failed"
