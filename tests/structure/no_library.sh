#!/usr/bin/env bash
# no_library.sh ROOT COMPILER FLAGS...: the boards' own sources, compiled for size, call no function of a C library beyond
# the four mem functions that boards/portable has. At -O2 the compiler knows the length of a literal, at -Os it asks.
set -euo pipefail
root=$1 compiler=$2
shift 2
if ! command -v "$compiler" >/dev/null; then
  echo "$compiler is not installed"
  exit 77
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Without those that instantiate a renderer, which would take long.
sources=$(grep -LE 'Renderer<|begin_frame|bench_run\.hpp|scene_player' "$root"/firmware/boards/{cortex_m,mps2,portable}/*.cpp)
for source in $sources; do
  "$compiler" "$@" -std=c++20 -Os -ffreestanding -fno-exceptions -fno-rtti -fno-threadsafe-statics \
    -fno-tree-loop-distribute-patterns -I"$root/core" -I"$root/hal" -I"$root/firmware/boards" -I"$root/firmware/scenes/include" -I"$root/tests/kernels" \
    -c "$source" -o "$work/$(basename "$source").o"
done
called=$("${compiler%g++}nm" -A --undefined-only "$work"/*.o | sed "s|$work/||" |
  grep -E ' U (str[a-z]+|mem[a-z]+|[a-z]*printf|malloc|free|abort)$' | grep -vE ' mem(cpy|move|set|cmp)$' || true)
if [ -n "$called" ]; then
  printf 'calls of a C library that boards do not have:\n%s\n' "$called"
  exit 1
fi
echo "$(wc -w <<<"$sources") sources"
