# How programs of tests/flash/project are built, and its core, which tests/gallery links, too. Sourced under
# `set -euo pipefail`.
flash_project=$(cd "$(dirname "${BASH_SOURCE[0]}")/project" && pwd -P)
declare -A flash_cpu=([m0]=cortex-m0 [m3]=cortex-m3)

# build_flash BUILD MACHINE PRESET TARGET...: in the folder BUILD/tests/flash/programs/MACHINE_PRESET.
build_flash() {
  local whole_build=$1 folder=$1/tests/flash/programs/$2_$3 libraries=
  if grep -q '^ZSTRIP_FIRMWARE:BOOL=ON$' "$whole_build/CMakeCache.txt"; then
    libraries=$whole_build/firmware/${flash_cpu[$2]}
  fi
  mkdir -p "$whole_build/tests/flash/programs"
  if ! { cmake -G Ninja -S "$flash_project" -B "$folder" -DCMAKE_BUILD_TYPE=Release -DZSTRIP_CPU="${flash_cpu[$2]}" \
           -DZSTRIP_PRESET="$3" "-DFLASH_LIBRARIES=$libraries" \
           -DCMAKE_TOOLCHAIN_FILE="$flash_project/../../../cmake/toolchains/arm-none-eabi.cmake" &&
         cmake --build "$folder" --parallel 2 --target "${@:4}"; } >"$folder.log" 2>&1; then
    cat "$folder.log" >&2
    return 1
  fi
}
