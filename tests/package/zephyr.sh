#!/usr/bin/env bash
# zephyr.sh ROOT FOLDER WORKSPACE: the package's program for Zephyr is built for qemu_cortex_m3 with the real Zephyr and runs
# in QEMU, where Zephyr's dummy display takes its strips. WORKSPACE has zephyr/ and modules/hal/cmsis (cmsis_6), as west
# makes it; west itself is not needed. The compiler is that of ZEPHYR_TOOLCHAIN_VARIANT, else Debian's for Arm with newlib.
set -euo pipefail
root=$(cd "$1" && pwd -P)
workspace=$(cd "$3" && pwd -P)
export ZEPHYR_BASE=$workspace/zephyr
[ -s "$ZEPHYR_BASE/VERSION" ] || { echo "$ZEPHYR_BASE is not a Zephyr"; exit 1; }
for tool in cmake ninja dtc qemu-system-arm python3; do
  command -v "$tool" >/dev/null || { echo "$tool is not installed"; exit 77; }
done
for python in "$(command -v python3)" /usr/bin/python3; do
  if "$python" -c 'import elftools, packaging, pykwalify, yaml' 2>/dev/null; then break; fi
done
"$python" -c 'import elftools, packaging, pykwalify, yaml' 2>/dev/null ||
  { echo "Zephyr's scripts need python3-packaging, python3-pyelftools, python3-pykwalify and python3-yaml"; exit 77; }

rm -rf "$2"
mkdir -p "$2"
cd "$2"
bash "$root/cmake/zstrip_package_sources.sh" .
options=("-DPython3_EXECUTABLE=$python" -DUSE_CCACHE=0)
if [ -z "${ZEPHYR_TOOLCHAIN_VARIANT-}" ]; then
  echo 'int main() {}' >main.cpp
  arm-none-eabi-g++ -mcpu=cortex-m3 -mthumb --specs=nosys.specs main.cpp -o main.elf 2>said ||
    { cat said; echo "arm-none-eabi-g++ with libstdc++-arm-none-eabi-newlib is not installed"; exit 77; }
  export ZEPHYR_TOOLCHAIN_VARIANT=cross-compile CROSS_COMPILE=/usr/bin/arm-none-eabi-
  # Debian's newlib has no locks for threads, which Zephyr asks for; one thread prints here, and not by newlib.
  options+=(-DEXTRA_CFLAGS=-D_RETARGETABLE_LOCKING=1)
fi
modules=$PWD/zstrip
for module in "$workspace"/modules/hal/cmsis{,_6}; do
  if [ -d "$module" ]; then modules+=";$module"; fi
done
sample=$PWD/zstrip/zephyr/samples/player
minor=$(sed -nE 's/^VERSION_M(AJOR|INOR) *= *//p' "$ZEPHYR_BASE/VERSION" | paste -sd.)
if [[ $minor == 3.[0-2] ]]; then
  # C++ and its library have other names there, and the dummy display is not chosen by the devicetree alone.
  cat >"$sample/Kconfig" <<'KCONFIG'
config CPP
	bool "C++"
	select CPLUSPLUS
config REQUIRES_FULL_LIBCPP
	bool
choice LIBC_IMPLEMENTATION
	default NEWLIB_LIBC
endchoice
config LIB_CPLUSPLUS
	default y
source "Kconfig.zephyr"
KCONFIG
  echo CONFIG_DUMMY_DISPLAY=y >"$sample/boards/qemu_cortex_m3.conf"
fi
env -u CMAKE_C_COMPILER_LAUNCHER -u CMAKE_CXX_COMPILER_LAUNCHER \
  cmake -S "$sample" -B build -G Ninja -DBOARD=qemu_cortex_m3 "-DZEPHYR_MODULES=$modules" "${options[@]}" >said 2>&1 ||
  { tail -n 40 said; exit 1; }
cmake --build build --parallel 2 >said 2>&1 || { tail -n 40 said; exit 1; }
arm-none-eabi-size build/zephyr/zephyr.elf

# It draws until it is stopped.
frames=64
qemu-system-arm -cpu cortex-m3 -machine lm3s6965evb -nographic -vga none -net none -serial file:printed -monitor none \
  -kernel build/zephyr/zephyr.elf </dev/null >said 2>&1 &
emulator=$!
trap 'kill $emulator 2>/dev/null || true' EXIT
for ((tenths = 0; tenths < 600; ++tenths)); do
  if grep -q "^$frames frames drawn" printed 2>/dev/null; then
    echo "Zephyr $minor: $frames frames drawn"
    exit 0
  fi
  sleep 0.1
done
cat said printed
exit 1
