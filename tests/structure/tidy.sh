#!/usr/bin/env bash
# tidy.sh ROOT BUILD: clang-tidy finds nothing in the sources of core, hal and host-sim that BUILD compiles.
set -euo pipefail
root=$(cd "$1" && pwd -P) build=$2
if ! clang-tidy --version 2>/dev/null | grep -q 'version 14\.'; then
  echo "clang-tidy 14 is not installed"
  exit 77
fi
if [ ! -e "$build/compile_commands.json" ]; then
  echo "$build has no compile_commands.json: configure with a preset, or with CMAKE_EXPORT_COMPILE_COMMANDS=ON"
  exit 1
fi
sources=$(sed -nE 's/^ *"file": "(.*)",?$/\1/p' "$build/compile_commands.json" |
  grep -E "^$root/(core|hal|host-sim)/.*\.cpp$" | sort -u)
# Diagnostics go to standard output; standard error only counts the suppressed warnings of system headers.
xargs -P 2 -n 1 clang-tidy -p "$build" --quiet 2>/dev/null <<<"$sources"
