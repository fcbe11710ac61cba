#!/usr/bin/env bash
# format.sh ROOT: every C++ file is as clang-format writes it. Releases differ, so that only the one of Debian 12 judges.
set -euo pipefail
cd "$1"
if ! clang-format --version 2>/dev/null | grep -q 'version 14\.'; then
  echo "clang-format 14 is not installed"
  exit 77
fi
unformatted=$(find . -path ./.git -prune -o -path './build*' -prune -o \
  -type f \( -name '*.hpp' -o -name '*.cpp' -o -name '*.h' -o -name '*.c' \) -print0 |
  xargs -0 -r -P 2 -I{} bash -c 'clang-format "$1" | cmp -s - "$1" || echo "$1"' _ {})
if [ -n "$unformatted" ]; then
  printf 'not as clang-format writes them (clang-format -i mends it):\n%s\n' "$unformatted"
  exit 1
fi
