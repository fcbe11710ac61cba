#!/usr/bin/env bash
# assembly.sh ROOT: no load or store in the assembly for Thumb has a bare number for an offset. Names are those of the
# layouts that static_assert checks, or of slots on the stack; a number may only count what has a name.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/search.sh"
cd "$1/core/zstrip/kernels"
operations='\bv?(ldr|str)(b|h|d|w|sb|sh)?(eq|ne|cs|hs|cc|lo|mi|pl|vs|vc|hi|ls|ge|lt|gt|le)?(\.\w+)?(?![\w.])'
# Anywhere in the offset, in the brackets or behind them.
number='#(?:[^]@"\n]*[^]\w.\\])?\d+(?![\w.]| \* \.L)'
lines -rnP "$operations"'[^@\[]*\[[\w\\]+(,\s*'"$number"'|[^]]*\],\s*'"$number"')' thumb thumb1 thumb2 mve
if [ -n "$found" ]; then
  printf 'offsets that are bare numbers:\n%s\n' "$found"
  exit 1
fi
for folder in thumb1 thumb2 mve; do
  grep -rqP "$operations"'.*\[\w+, #\.L' "$folder" || { echo "finds no assembly in $folder"; exit 1; }
done
