#!/usr/bin/env bash
# micropython.sh ROOT SCRATCH ZSTRIP [MICROPYTHON]: MicroPython's QEMU port is built with the module, for a Cortex-M3, outside
# of its folder, and runs micropython.py: frames of baked scenes are those of `zstrip render`. Without the folder the test
# is skipped.
set -euo pipefail
root=$(cd "$1" && pwd -P)
zstrip=$3
[ -n "${4-}" ] || { echo "skipped: no MicroPython is given: -DZSTRIP_MICROPYTHON=FOLDER of CMake"; exit 77; }
for tool in make python3 arm-none-eabi-g++ qemu-system-arm; do
  command -v "$tool" >/dev/null || { echo "skipped: $tool is not installed"; exit 77; }
done
micropython=$(cd "$4" && pwd -P)
mkdir -p "$2"
cd "$2"
failed=0
complain() {
  echo "$*"
  failed=1
}
bash "$root/cmake/zstrip_package_micropython.sh" "$PWD/modules"
make -C "$micropython/ports/qemu" -j2 BOARD=MPS2_AN385 BUILD="$PWD/build" USER_C_MODULES="$PWD/modules" FROZEN_MANIFEST= \
  >build.log 2>&1 || { tail -n 20 build.log; echo "MicroPython is not built with the module"; exit 1; }

# In the memory that nothing else uses, one behind the other.
view=(--size 160x120 --quiet)
address=$((0x21800000)) loaded=() scenes=
for scene in teapot room "$root/host-sim/scenes/figure/figure.gltf"; do
  name=$(basename "${scene%.*}")
  "$zstrip" bake "$scene" -o "$name.zsc" "${view[@]}" --turntable
  loaded+=(-device "loader,file=$name.zsc,addr=$address,force-raw=on")
  scenes+="'$name': ($address, $(stat -c %s "$name.zsc")), "
  address=$((address + 0x100000))
done
# The raw mode of the console: Control-A, a program, Control-D.
{ printf '\001'; echo "SCENES = {$scenes}"; cat "$root/tests/package/micropython.py"; printf '\004'; } >typed
timeout 60 qemu-system-arm -machine mps2-an385 -display none -monitor none -serial stdio -semihosting "${loaded[@]}" \
  -kernel build/firmware.elf < <(sleep 1; cat typed; sleep 60) 2>said.errors | tr -d '\r\004' >said || true

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
  "$zstrip" render room.zsc "${view[@]}" -o room.png --pick 80,60 --json - | python3 -c '
import json, sys
at = json.load(sys.stdin)["frames"][0]["picked"]
print("picked", ({"background": 0, "instance": 1}[at["shown"]], at["index"], at["triangle"]))'
  echo "strip 0 160 True True True"
  echo "changed (0, 0, 160, 120) None"
  echo "turned True"
  echo "turned back True"
  echo "end"
} >expected
sed -n 's/^.*>OK//;/^\(frame\|clips\|picked\|strip\|changed\|turned\|end\|wrong\|no error\|Traceback\| \)/p;/Error/p' said >shown
diff expected shown || complain "what MicroPython shows (>) is not what is expected (<)"
arm-none-eabi-size build/firmware.elf | awk 'NR == 2 { print "the firmware: " $1 + $2 " bytes of flash" }'
exit "$failed"
