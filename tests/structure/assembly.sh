#!/usr/bin/env bash
# assembly.sh ROOT: no load or store in the assembly for Thumb has a bare number for an offset. Names are those of the
# layouts that static_assert checks, or of slots on the stack; a number may only count what has a name.
set -euo pipefail
cd "$1/core/zstrip/kernels"
operations='\b(ldr|str)(b|h|d|sb|sh)?(eq|ne)?\b'
found=$(grep -rnP "$operations"'[^@\[]*(\[\w+,\s*#-?\d+(?!\d| \* \.L)|\[[^]]*\],\s*#-?\d+(?!\d| \* \.L))' thumb thumb1 thumb2 mve || true)
if [ -n "$found" ]; then
  printf 'offsets that are bare numbers:\n%s\n' "$found"
  exit 1
fi
for folder in thumb1 thumb2 mve; do
  grep -rqP "$operations"'.*\[\w+, #\.L' "$folder" || { echo "finds no assembly in $folder"; exit 1; }
done
