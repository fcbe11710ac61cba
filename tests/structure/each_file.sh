#!/usr/bin/env bash
# each_file.sh ROOT BUILD: sources that BUILD compiles joined compile by themselves, too, as the README's plain build does
# it. A joined source's first one does in any case; the others are compiled with ZSTRIP_LONG, else those of host-sim/text,
# which parse the fewest headers of libraries.
set -euo pipefail
root=$(cd "$1" && pwd -P)
build=$(cd "$2" && pwd -P)
source "$(dirname "${BASH_SOURCE[0]}")/sources.sh"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

folders=("$root/host-sim/text")
if [ -n "${ZSTRIP_LONG-}" ]; then folders=("$root"/{host-sim,tests}); fi
source_commands "$build" "${folders[@]}" | awk -F '\t' '$3 != ""' >"$work/chosen"
compile() {
  local command source
  IFS=$'\t' read -r command source _ <<<"$1"
  cd "$build"
  eval "set -- ${command% -o *}"
  "$@" -fsyntax-only "$source" 2>&1 || { echo "$source does not compile by itself"; return 1; }
}
export build
export -f compile
xargs -r -d '\n' -P 2 -n 1 bash -c 'compile "$@"' _ <"$work/chosen"
if [ ! -s "$work/chosen" ] && grep -q '^ZSTRIP_COMPILE_TOGETHER:.*host-sim' "$build/CMakeCache.txt"; then
  echo "$build joins sources of host-sim, and none of ${folders[*]} is found"
  exit 1
fi
echo "$(wc -l <"$work/chosen") sources compiled by themselves"
