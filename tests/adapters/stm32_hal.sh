#!/usr/bin/env bash
# stm32_hal.sh ROOT FOLDER: the adapter for the HAL of STM32Cube compiles with the real one, of F4 or H7, that lies
# somewhere below FOLDER: a package of STM32Cube, or a project's folder Drivers.
set -euo pipefail
cd "$1"
folder=$2
compiler=arm-none-eabi-g++
command -v $compiler >/dev/null || { echo "$compiler is not installed"; exit 77; }
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# folder_of NAME: the first folder that has this file.
folder_of() {
  local file
  file=$(find -L "$folder" -name "$1" -type f | sort | head -n 1)
  [ -n "$file" ] || { echo "$folder has no $1" >&2; exit 1; }
  dirname "$file"
}

tried=0
# compile FAMILY PART PROCESSOR
compile() {
  [ -n "$(find -L "$folder" -name "$1xx_hal_spi.h" -type f -print -quit)" ] || return 0
  local hal device core
  hal=$(folder_of "$1xx_hal_spi.h")
  device=$(folder_of "$1xx.h")
  core=$(folder_of "core_c${3#cortex-}.h")
  mkdir "$scratch/$1"
  # A project's own configuration is beside its sources; the template switches all modules on.
  cp "$hal/$1xx_hal_conf_template.h" "$scratch/$1/$1xx_hal_conf.h"
  printf '#include "%sxx_hal.h"\n' "$1" >"$scratch/$1/main.h"
  printf '#include "stm32_hal_spi.hpp"\n' >"$scratch/$1/program.cpp"
  "$compiler" "-mcpu=$3" -mthumb -std=gnu++20 -Wall -Wextra -Werror -fno-exceptions -fno-rtti -fsyntax-only \
    "-D$2" -DUSE_HAL_DRIVER -Icore -Ihal -Ifirmware/examples/adapters -isystem "$scratch/$1" -isystem "$hal" \
    -isystem "$device" -isystem "$core" "$scratch/$1/program.cpp"
  echo "compiled with the HAL of $2"
  tried=$((tried + 1))
}
compile stm32f4 STM32F407xx cortex-m4
compile stm32h7 STM32H743xx cortex-m7
[ $tried -gt 0 ] || { echo "$folder has neither stm32f4xx_hal_spi.h nor stm32h7xx_hal_spi.h"; exit 1; }
