#!/usr/bin/env bash
# arduino_pico.sh ROOT ZSTRIP PACKAGE [DISPLAY LIBRARY]: sketches compile for a Raspberry Pi Pico with the real board package
# arduino-pico, the folder PACKAGE that has platform.txt: those of firmware/examples for zstrip's own driver, and the one
# that `zstrip bake` writes for it. With DISPLAY (tft_espi, lovyangfx or arduino_gfx): the one that it writes for that display
# library, whose folder is LIBRARY. PACKAGE has its submodules, as an installed one has.
set -euo pipefail
root=$(cd "$1" && pwd -P)
zstrip=$2 package=$3 display=${4-st7789} library=${5-}
compiler=arm-none-eabi-g++
command -v $compiler >/dev/null || { echo "$compiler is not installed"; exit 77; }
for file in platform.txt cores/rp2040/Arduino.h ArduinoCore-API/api/ArduinoAPI.h pico-sdk/src/boards/include/boards/pico.h \
    pico-sdk/lib/tinyusb/src/tusb.h pico-sdk/lib/lwip/src/include/lwip/init.h; do
  [ -f "$package/$file" ] || { echo "$package has no $file"; exit 1; }
done
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# What platform.txt and boards.txt of the package say for this board. Headers of the package and of libraries are those of
# the system: only what is of this repository is without warnings.
for list in "$package"/lib/{,rp2040/}platform_def.txt "$package"/lib/rp2040/platform_inc.txt "$package/lib/core_inc.txt"; do
  tr -d '\r' <"$list" | sed "s|^-iwithprefixbefore/|-isystem$package/|"
done >"$scratch/options"
# The package includes <../include/time.h>, that of its own compiler's folder.
mkdir -p "$scratch/compiler"/{lib,include}
echo '#include <time.h>' >"$scratch/compiler/include/time.h"
standard=$(sed -nE 's/^compiler\.cpp\.flags=.*-std=(gnu\+\+[0-9a-z]+).*/\1/p' "$package/platform.txt")
case $standard in gnu++20 | gnu++2[3-9]) ;; *) standard=gnu++20 ;; esac  # older ones by platform.local.txt
# TFT_eSPI says by #warning that there is no touch.
options=(-mcpu=cortex-m0plus -mthumb "-std=$standard" -Wall -Wextra -Werror -Wno-volatile -Wno-cpp -fno-exceptions -fno-rtti
  -fsyntax-only -x c++ -include Arduino.h "@$scratch/options" -isystem "$package/include"
  -isystem "$package/cores/rp2040" -isystem "$package/variants/rpipico" -isystem "$scratch/compiler/lib")
for name in SPI Wire LittleFS SdFat; do options+=(-isystem "$package/libraries/$name/src"); done
options+=(-DF_CPU=125000000 -DARDUINO=10819 -DARDUINO_RASPBERRY_PI_PICO '-DBOARD_NAME="RASPBERRY_PI_PICO"'
  -DARDUINO_ARCH_RP2040 '-DARDUINO_VARIANT="rpipico"' -DPICO_FLASH_SIZE_BYTES=2097152 -DUSBD_VID=0x2e8a -DUSBD_PID=0xa
  -DUSBD_MAX_POWER_MA=250)
if [ -n "$library" ]; then
  case $display in
    tft_espi) header=TFT_eSPI.h ;;
    lovyangfx) header=LovyanGFX.hpp ;;
    arduino_gfx) header=Arduino_GFX_Library.h ;;
    *) echo "$display is no library that sketches are written for"; exit 2 ;;
  esac
  if [ -f "$library/src/$header" ]; then library=$library/src; fi
  [ -f "$library/$header" ] || { echo "$library has no $header"; exit 1; }
  options+=(-isystem "$library")
fi
# The package in src/ of zstrip's own has these together.
for folder in core hal firmware/player firmware/scenes/include firmware/package/src; do options+=("-I$root/$folder"); done

# compile SKETCH
compile() {
  "$compiler" "${options[@]}" "$1"
  echo "compiled with $standard: ${1##*/}"
}
"$zstrip" bake teapot -o "$scratch/Teapot/" --display "$display" --quiet
compile "$scratch/Teapot/Teapot.ino"
[ -z "$library" ] || exit 0
for sketch in "$root"/firmware/examples/*/*.ino; do
  if ! grep -q 'adapters::' "$sketch"; then compile "$sketch"; fi
done
