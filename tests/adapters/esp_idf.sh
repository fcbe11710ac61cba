#!/usr/bin/env bash
# esp_idf.sh ROOT ZSTRIP FOLDER: the adapter for esp_lcd, and the program of `zstrip bake --project esp_idf`, compile with the
# headers of the real ESP-IDF in FOLDER, for an ESP32-C3 by Debian's compiler for RISC-V: as gnu++20, and as gnu++23, the
# newest that it knows (release 6 has gnu++26).
set -euo pipefail
root=$(cd "$1" && pwd -P)
zstrip=$2 components=$3/components
compiler=riscv64-unknown-elf-g++
for tool in $compiler arm-none-eabi-g++; do
  command -v $tool >/dev/null || { echo "$tool is not installed"; exit 77; }
done
[ -f "$components/esp_lcd/include/esp_lcd_panel_io.h" ] || { echo "$3 is not the folder of ESP-IDF"; exit 1; }
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# Of what menuconfig writes, what these headers need.
cat >"$scratch/sdkconfig.h" <<'CONFIG'
#define CONFIG_IDF_TARGET "esp32c3"
#define CONFIG_IDF_TARGET_ESP32C3 1
#define CONFIG_IDF_TARGET_ARCH_RISCV 1
#define CONFIG_ESP_SYSTEM_SINGLE_CORE_MODE 1
#define CONFIG_FREERTOS_HZ 100
#define CONFIG_FREERTOS_UNICORE 1
#define CONFIG_FREERTOS_NUMBER_OF_CORES 1
#define CONFIG_FREERTOS_MAX_TASK_NAME_LEN 16
#define CONFIG_FREERTOS_TASK_NOTIFICATION_ARRAY_ENTRIES 1
CONFIG
# The C++ headers are those of the Arm compiler, as in cmake/toolchains/libstdcxx_headers.cmake.
include=(-isystem "$scratch")
while IFS= read -r folder; do include+=(-isystem "$folder"); done < <(
  arm-none-eabi-g++ -E -v -x c++ /dev/null 2>&1 >/dev/null |
    sed -n '/search starts here/,/End of search/s/^ //p' | grep -E '/include(/c\+\+/.*)?$' |
    grep -vE '/lib/gcc/[^/]*/[^/]*/include$|/backward$'
  chip=esp32c3 kernel=$components/freertos/FreeRTOS-Kernel
  for folder in "$components"/*/{include,platform_include} "$components"/*/$chip/{include,register} \
      "$components"/esp_hw_support/{include/soc,etm/include} "$components"/freertos/{config,esp_additions}/include \
      "$components"/freertos/config/{include/freertos,riscv/include} "$kernel"/include \
      "$kernel"/portable/riscv/include{,/freertos}; do
    if [ -d "$folder" ]; then echo "$folder"; fi
  done)

"$zstrip" bake teapot -o "$scratch/teapot/" --project esp_idf --quiet
for standard in gnu++20 gnu++23; do
  "$compiler" -march=rv32imac -mabi=ilp32 -std=$standard -Wall -Wextra -Werror -Wno-missing-field-initializers -fno-exceptions \
    -fno-rtti -fsyntax-only -DESP_PLATFORM "${include[@]}" -I"$root/core" -I"$root/hal" -I"$root/firmware/player" \
    -I"$root/firmware/scenes/include" "$scratch/teapot/main/main.cpp"
  echo "compiled as $standard"
done
