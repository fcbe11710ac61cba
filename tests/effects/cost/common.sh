# What scripts that measure programs for boards share: their words, and builds of a project. Sourced under
# `set -euo pipefail`.
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../../.." && pwd -P)
project=$root/tests/effects/cost
declare -A cpu=([m0]=cortex-m0 [m3]=cortex-m3 [m4f]=cortex-m4)

# if_long WORDS ELSE
if_long() { if [ -n "${ZSTRIP_LONG-}" ]; then echo "$1"; else echo "$2"; fi; }

# take_words TOOL BUILD [--exact | --check] [ROW...]: sets whole_build, tool, build (for programs of the project), check,
# exact and rows. To check without a ROW is to check the usual ones; ZSTRIP_LONG=1 in the environment: all.
take_words() {
  tool=$2/tests/$1 whole_build=$2 build=$2/tests/$(dirname "$1")/programs
  exact=() check=false
  shift 2
  case "${1-}" in
    --exact) exact=(--exact); shift ;;
    --check) check=true; shift ;;
  esac
  rows=("$@")
  mkdir -p "$build"
  if $check && [ ${#rows[@]} -eq 0 ]; then
    read -r -a rows <<<"$("$tool" "$(if_long names usual)" | paste -sd ' ')"
    echo "${rows[*]}"
  fi
}

# build FOLDER TARGET... -- OPTION...
build() {
  local folder=$1 targets=()
  shift
  while [[ $1 != -- ]]; do targets+=("$1"); shift; done
  shift
  if ! { cmake -G Ninja -S "$project" -B "$folder" -DCMAKE_BUILD_TYPE=Release "$@" &&
         cmake --build "$folder" --parallel 2 --target "${targets[@]}"; } >"$folder.log" 2>&1; then
    cat "$folder.log" >&2
    return 1
  fi
}

# build_for_board FOLDER MACHINE TARGET... -- OPTION...: with the libraries of the programs for boards.
build_for_board() {
  local folder=$1 machine=$2 libraries=
  shift 2
  if grep -q '^ZSTRIP_FIRMWARE:BOOL=ON$' "$whole_build/CMakeCache.txt"; then
    libraries=$whole_build/firmware/${cpu[$machine]}
  fi
  build "$folder" "$@" -DZSTRIP_CPU="${cpu[$machine]}" "-DBOARD_LIBRARIES=$libraries" \
    -DCMAKE_TOOLCHAIN_FILE="$root/cmake/toolchains/arm-none-eabi.cmake"
}

# joined WORD...: with semicolons, as CMake's lists.
joined() { local IFS=';'; echo "$*"; }
