# What update and flash share: builds of this project, and programs in the emulator. Who sources it sets `build`, the
# folder for builds. The scenes that boards have in ZSTRIP_FIRMWARE_BUILDS serve, if it is set.
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd -P)
root=$(cd "$here/../../.." && pwd -P)
document=$root/docs/effects.md
declare -A cpu=([m0]=cortex-m0 [m3]=cortex-m3 [m4f]=cortex-m4) board=([m0]=mps2-an385 [m3]=mps2-an385 [m4f]=mps2-an386)

# build NAME PROGRAM... -- OPTION...
build() {
  local folder=$build/$1 programs=()
  shift
  while [[ $1 != -- ]]; do programs+=("$1"); shift; done
  shift
  if ! { cmake -S "$here" -B "$folder" "$@" &&
         cmake --build "$folder" --parallel 2 --target "${programs[@]}"; } >"$folder.log" 2>&1; then
    cat "$folder.log" >&2
    exit 1
  fi
}

# build_for_board MACHINE PROGRAM... -- OPTION...
build_for_board() {
  build "$@" -DCMAKE_BUILD_TYPE=Release -DCOST_BOARD=mps2 -DZSTRIP_CPU="${cpu[$1]}" \
    -DCMAKE_TOOLCHAIN_FILE="$root/cmake/toolchains/arm-none-eabi.cmake" \
    ${ZSTRIP_FIRMWARE_BUILDS:+"-DZSTRIP_SCENES_LIBRARY=$ZSTRIP_FIRMWARE_BUILDS/${cpu[$1]}/firmware/scenes/libzstrip_scenes.a"}
}

# emulated MACHINE PROGRAM: what it prints.
emulated() {
  timeout 120 qemu-system-arm -M "${board[$1]}" -display none -monitor none -audiodev none,id=none -serial stdio \
    -semihosting-config enable=on,target=native -icount shift=0 -kernel "$build/$1/$2"
}
