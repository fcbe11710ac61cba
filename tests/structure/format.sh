#!/usr/bin/env bash
# format.sh ROOT: every C++ file is as clang-format writes it. Releases differ, so that only the one of Debian 12 judges.
set -euo pipefail
cd "$1"
if [[ $(clang-format --version 2>/dev/null) != *'version 14.'* ]]; then
  echo "clang-format 14 is not installed"
  exit 77
fi
if findings=$(find . -path ./.git -prune -o -path './build*' -prune -o \
  -type f \( -name '*.hpp' -o -name '*.cpp' -o -name '*.h' -o -name '*.c' -o -name '*.ino' \) -print0 |
  xargs -0 -r -P 2 -n 32 clang-format --dry-run --Werror 2>&1); then
  exit 0
fi
unformatted=$(sed -nE 's/^(.*):[0-9]+:[0-9]+: error:.*/\1/p' <<<"$findings" | sort -u)
[ -n "$unformatted" ] || unformatted=$findings
printf 'not as clang-format writes them (clang-format -i mends it):\n%s\n' "$unformatted"
exit 1
