#!/usr/bin/env bash
# esp_idf.sh ROOT ZSTRIP FOLDER [PANEL_DRIVER]: the adapters for esp_lcd, the programs of `zstrip bake --project esp_idf` for its
# three kinds of panels, and those of the package compile with the headers of the real ESP-IDF in FOLDER, each for a chip
# that runs it: as gnu++20, and as gnu++23, the newest that Debian's GCC knows (release 6 has gnu++26).
# PANEL_DRIVER: the folder of the component esp_lcd_ek79007; without it a stand-in declares its functions.
set -euo pipefail
root=$(cd "$1" && pwd -P)
zstrip=$2 components=$3/components driver=${4:+$4/include}
for tool in riscv64-unknown-elf-g++ xtensa-lx106-elf-g++ arm-none-eabi-g++; do
  command -v $tool >/dev/null || { echo "$tool is not installed"; exit 77; }
done
[ -f "$components/esp_lcd/include/esp_lcd_panel_io.h" ] || { echo "$3 is not the folder of ESP-IDF"; exit 1; }
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# configure CHIP ARCHITECTURE: writes what these headers need of what menuconfig writes, and sets `include`, the folders of headers for
# CHIP. The C++ headers are those of the Arm compiler, as in cmake/toolchains/libstdcxx_headers.cmake.
configure() {
  local folder chip=$1 architecture=$2 kernel=$components/freertos/FreeRTOS-Kernel
  mkdir -p "$scratch/$chip"
  cat >"$scratch/$chip/sdkconfig.h" <<CONFIG
#define CONFIG_IDF_TARGET "$chip"
#define CONFIG_IDF_TARGET_${chip^^} 1
#define CONFIG_IDF_TARGET_ARCH_${architecture^^} 1
#define CONFIG_ESP_SYSTEM_SINGLE_CORE_MODE 1
#define CONFIG_FREERTOS_HZ 100
#define CONFIG_FREERTOS_UNICORE 1
#define CONFIG_FREERTOS_NUMBER_OF_CORES 1
#define CONFIG_FREERTOS_MAX_TASK_NAME_LEN 16
#define CONFIG_FREERTOS_TASK_NOTIFICATION_ARRAY_ENTRIES 1
CONFIG
  include=(-isystem "$scratch/$chip")
  while IFS= read -r folder; do include+=(-isystem "$folder"); done < <(
    arm-none-eabi-g++ -E -v -x c++ /dev/null 2>&1 >/dev/null |
      sed -n '/search starts here/,/End of search/s/^ //p' | grep -E '/include(/c\+\+/.*)?$' |
      grep -vE '/lib/gcc/[^/]*/[^/]*/include$|/backward$'
    for folder in "$components"/*/{include,platform_include} "$components"/*/$chip/{include,register} \
        "$components"/*/$chip/register/hw_ver1 "$components"/esp_lcd/{rgb,dsi}/include \
        "$components"/esp_hw_support/{include/soc,etm/include,ldo/include} "$components"/freertos/{config,esp_additions}/include{,/freertos} \
        "$components"/freertos/config/$architecture/include "$kernel"/include \
        "$kernel"/portable/$architecture/include{,/freertos}; do
      if [ -d "$folder" ]; then echo "$folder"; fi
    done)
}
# compiles WHAT SOURCE COMPILER...: as both standards.
compiles() {
  local standard
  for standard in gnu++20 gnu++23; do
    "${@:3}" -std=$standard -Wall -Wextra -Werror -Wno-missing-field-initializers -fno-exceptions -fno-rtti -fsyntax-only \
      -DESP_PLATFORM "${include[@]}" -I"$root/core" -I"$root/hal" -I"$root/firmware/player" -I"$root/firmware/scenes/include" \
      -I"$root/firmware/examples/adapters" -I"$root/firmware/examples/Player" "$2"
    echo "$1 compiled as $standard"
  done
}
package=$root/firmware/package/esp_idf

for panel in st7789 rgb_panel mipi_dsi_panel; do
  "$zstrip" bake teapot -o "$scratch/$panel/" --project esp_idf --display $panel --quiet
done
configure esp32c3 riscv
compiles "the program of bake" "$scratch/st7789/main/main.cpp" riscv64-unknown-elf-g++ -march=rv32imac -mabi=ilp32
compiles "the program of the package" "$package/spi_panel/main/main.cpp" riscv64-unknown-elf-g++ -march=rv32imac -mabi=ilp32

# That of an ESP32-S3 differs from Debian's Xtensa in registers, which syntax does not show.
configure esp32s3 xtensa
for folder in "$package" "$scratch"; do
  compiles "the program for an RGB panel in $folder" "$folder/rgb_panel/main/main.cpp" xtensa-lx106-elf-g++
done

if [ ! -f "$components/esp_lcd/dsi/include/esp_lcd_mipi_dsi.h" ]; then
  echo "this ESP-IDF has no MIPI-DSI: the program for its panels is not compiled"
  exit
fi
configure esp32p4 riscv
if [ -z "$driver" ]; then
  driver=$scratch/driver
  mkdir "$driver"
  cp "$root/tests/adapters/declarations/esp_lcd_ek79007.h" "$driver"
fi
include+=(-isystem "$driver")
for folder in "$package" "$scratch"; do
  compiles "the program for a MIPI-DSI panel in $folder" "$folder/mipi_dsi_panel/main/main.cpp" \
    riscv64-unknown-elf-g++ -march=rv32imafc -mabi=ilp32f
done
