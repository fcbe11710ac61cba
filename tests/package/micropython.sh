#!/usr/bin/env bash
# micropython.sh ROOT SCRATCH ZSTRIP BOARD [MICROPYTHON]: MicroPython's QEMU port is built with the module for a board, outside
# of its folder, and the native module for the board's processor. micropython.py runs with each of them: frames of baked
# scenes are those of `zstrip render`. Without the folder the test is skipped.
set -euo pipefail
root=$(cd "$1" && pwd -P)
zstrip=$3
board=$4
[ -n "${5-}" ] || { echo "skipped: no MicroPython is given: -DZSTRIP_MICROPYTHON=FOLDER of CMake"; exit 77; }
compiler=arm-none-eabi- qemu=(qemu-system-arm -semihosting) step=$((0x100000))
options=(MICROPY_HEAP_SIZE=409600)  # the native module, a player and a picture
# Where scenes and the native module are, one behind the other: memory that nothing else uses.
case $board in
  MPS2_AN385) machine=mps2-an385 architecture=armv7m address=$((0x21800000)) ;;
  MPS2_AN500) machine=mps2-an500 architecture=armv7emsp address=$((0x60100000)) ;;
  MICROBIT) # the largest heap that fits, and the loader of native code, which the port leaves out here
    machine=microbit architecture=armv6m address=$((0x90000)) step=$((0x10000))
    qemu+=(-global nrf51-soc.flash-size=1048576 -global nrf51-soc.sram-size=262144)
    options=(MICROPY_HEAP_SIZE=245760 CFLAGS_EXTRA=-DMICROPY_PERSISTENT_CODE_LOAD_NATIVE=1)
    ;;
  VIRT_RV32)
    machine=virt architecture=rv32imc address=$((0x81000000))
    compiler=riscv64-unknown-elf- qemu=(qemu-system-riscv32 -semihosting -bios none)
    # For the processor that the port names, with Zicsr, GCC 12 says the library of 64 bits.
    options+=(LIBS="$(riscv64-unknown-elf-gcc -march=rv32imac -mabi=ilp32 -print-libgcc-file-name 2>/dev/null || true)")
    ;;
  *) echo "there is no board $board"; exit 2 ;;
esac
for tool in make python3 arm-none-eabi-g++ "${compiler}g++" "${qemu[0]}"; do
  command -v "$tool" >/dev/null || { echo "skipped: $tool is not installed"; exit 77; }
done
echo '#include <string.h>' | "${compiler}gcc" $("${compiler}gcc" -print-file-name=picolibc.specs | sed -n 's,^/,--specs=/,p') \
  -E - >/dev/null 2>&1 || { echo "skipped: ${compiler}gcc has no C library"; exit 77; }
# The first one with the library that MicroPython's linker needs.
python=
for candidate in python3 /usr/bin/python3; do
  "$candidate" -c 'import elftools' 2>/dev/null && { python=$candidate; break; }
done
micropython=$(cd "$5" && pwd -P)
mkdir -p "$2"
cd "$2"
failed=0
complain() {
  echo "$*"
  failed=1
}
bash "$root/cmake/zstrip_package_micropython.sh" "$PWD/modules"
make -C "$micropython/ports/qemu" -j2 BOARD="$board" BUILD="$PWD/build" USER_C_MODULES="$PWD/modules" FROZEN_MANIFEST= \
  "${options[@]}" >build.log 2>&1 || { tail -n 20 build.log; echo "MicroPython is not built with the module"; exit 1; }

# put FILE: loads it when the machine starts; sets `place` to its address and size.
loaded=()
put() {
  loaded+=(-device "loader,file=$1,addr=$address,force-raw=on")
  place="($address, $(stat -c %s "$1"))"
  address=$((address + step))
}
view=(--size 160x120 --quiet)
scenes=
for scene in teapot room "$root/host-sim/scenes/figure/figure.gltf" "$root/tests/player/events.toml"; do
  name=$(basename "${scene%.*}")
  "$zstrip" bake "$scene" -o "$name.zsc" "${view[@]}" --turntable
  put "$name.zsc"
  scenes+="'$name': $place, "
done

# expect NAME FRAMES WORDS...
expect() {
  local name=$1 frames=$2
  shift 2
  rm -rf frames
  "$zstrip" render "$name.zsc" "${view[@]}" --frames "$frames" --image raw --format rgb565 -o frames "$@"
  local frame=0 file
  for file in frames/*.raw; do
    echo "frame $name $frame $(sha256sum <"$file" | cut -d ' ' -f 1)"
    frame=$((frame + 1))
  done
}
{
  expect teapot 4
  expect room 4
  expect figure 3 --animation wave
  echo "clips [('walk', 1200), ('wave', 1500)]"
  echo "events [(1200, 3), (1200, 65535), (2300, 3)]"
  "$zstrip" render room.zsc "${view[@]}" -o room.png --pick 80,60 --json - | python3 -c '
import json, sys
at = json.load(sys.stdin)["frames"][0]["picked"]
print("picked", ({"background": 0, "instance": 1}[at["shown"]], at["index"], at["triangle"]))'
  echo "strip 0 160 True True True"
  echo "changed (0, 0, 160, 120) None"
  echo "turned True"
  echo "turned back True"
  echo "kept True"
  echo "end"
} >expected

# run NAME NATIVE: what micropython.py prints, in NAME.said.
run() {
  # The raw mode of the console: Control-A, a program, Control-D.
  { printf '\001'; echo "SCENES = {$scenes}"; echo "NATIVE = $2"; cat "$root/tests/package/micropython.py"; printf '\004'; } >typed
  timeout 60 "${qemu[@]}" -machine "$machine" -display none -monitor none -serial stdio "${loaded[@]}" \
    -kernel build/firmware.elf < <(sleep 1; cat typed; sleep 60) 2>"$1.errors" | tr -d '\r\004' >"$1.said" || true
  sed -n 's/^.*>OK//;/^\(frame\|clips\|events\|picked\|strip\|changed\|turned\|kept\|end\|wrong\|no error\|Traceback\| \)/p;/Error/p' \
    "$1.said" >"$1.shown"
  diff expected "$1.shown" || complain "what MicroPython shows with the $1 module (>) is not what is expected (<)"
}
run user None
"${compiler}size" build/firmware.elf | awk 'NR == 2 { print "the firmware with the user C module: " $1 + $2 " bytes of flash" }'

if [ -z "$python" ]; then
  echo "not tried, because python3 has no elftools (Debian: python3-pyelftools): the native module"
else
  make -C modules/zstrip-micropython -j2 ARCH="$architecture" MPY_DIR="$micropython" BUILD="$PWD/native" PYTHON="$python" \
    >native.log 2>&1 || { tail -n 20 native.log; echo "the native module is not built"; exit 1; }
  put modules/zstrip-micropython/zstrip.mpy
  run native "$place"
  echo "the native module for $architecture: $(stat -c %s modules/zstrip-micropython/zstrip.mpy) bytes;" \
    "$(sed -n 's/^.*\(RAM of the module .*\)/\1/p' native.said) bytes"
fi
exit "$failed"
