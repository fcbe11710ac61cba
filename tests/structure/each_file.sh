#!/usr/bin/env bash
# each_file.sh ROOT BUILD: sources that BUILD compiles joined compile by themselves, too, as the README's plain build does
# it: those that have changed, and a sample that the date chooses; all with ZSTRIP_LONG.
set -euo pipefail
root=$(cd "$1" && pwd -P)
build=$(cd "$2" && pwd -P)
source "$(dirname "${BASH_SOURCE[0]}")/sources.sh"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

source_commands "$build" "$root"/{host-sim,tests} | awk -F '\t' '$3 != ""' | chosen "$root" 60 >"$work/chosen"
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
echo "$(wc -l <"$work/chosen") sources compiled by themselves"
