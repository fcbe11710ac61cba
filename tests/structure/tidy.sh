#!/usr/bin/env bash
# tidy.sh ROOT BUILD: clang-tidy finds nothing in the sources of core, hal and host-sim/{report,text} that BUILD compiles, nor in
# their headers; with ZSTRIP_LONG in all of host-sim. Tables of pipelines take longest, and instantiate the same templates
# with other effects: without ZSTRIP_LONG those of all effects and of the methods that are measured are looked at.
set -euo pipefail
root=$(cd "$1" && pwd -P)
build=$(cd "$2" && pwd -P)
source "$(dirname "${BASH_SOURCE[0]}")/sources.sh"
if [[ $(clang-tidy --version 2>/dev/null) != *'version 14.'* ]]; then
  echo "clang-tidy 14 is not installed"
  exit 77
fi
if [ ! -e "$build/compile_commands.json" ]; then
  echo "$build has no compile_commands.json: configure with a preset, or with CMAKE_EXPORT_COMPILE_COMMANDS=ON"
  exit 1
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp "$root/.clang-tidy" "$work"

# Nearly all of the time goes to the headers of libraries. So sources are looked at together: those that the build compiles
# as one in its order, others of one program. Out: N.cpp and N.command.
folders=("$root"/{core,hal,host-sim/report,host-sim/text}) left_out='/rows_of_(counts|depth|methods|triangles)\.cpp	'
if [ -n "${ZSTRIP_LONG-}" ]; then folders=("$root"/{core,hal,host-sim}) left_out='^$'; fi
source_commands "$build" "${folders[@]}" | grep -vE "$left_out" | sed -E 's/ -O[0-3s]( |\t)/\1/; s/ -fpch-preprocess//; s/ -Winvalid-pch -include [^ ]*\/cmake_pch\.hxx//' |
  sort -t $'\t' -s -r -k 3,3 |
  awk -F '\t' -v work="$work" '
    { alike = $3 != "" ? $3 : $1
      if (!(alike in group)) group[alike] = ++groups
      printf "#include \"%s\"\n", $2 >(work "/" group[alike] ".cpp")
      print $1 >(work "/" group[alike] ".command") }'

# tidy SOURCE COMMAND: the sources that it includes are ours, it is not.
tidy() {
  local source=$1
  eval "set -- $2"
  while [ $# -gt 0 ] && [ "${1#-}" = "$1" ]; do shift; done  # the compiler, and what launches it
  cd "$build"
  clang-tidy --quiet --checks=-bugprone-suspicious-include --header-filter='/(core|hal|host-sim)/.*\.[ch]pp$' \
    "$source" -- "$@" 2>/dev/null
}
# Sources whose names clash, or that are too much for it together, are looked at one by one.
tidy_group() {
  local group=$1 command findings include failed=0
  read -r command <"$group.command"
  if findings=$(tidy "$group.cpp" "$command"); then return 0; fi
  while read -r include; do
    echo "$include" >"$group.one.cpp"
    tidy "$group.one.cpp" "$command" || failed=1
  done <"$group.cpp"
  if [ "$failed" -eq 0 ] && ! grep -q clang-diagnostic <<<"$findings" && [ -n "$findings" ]; then
    echo "$findings"
    failed=1
  fi
  return "$failed"
}
export build
export -f tidy tidy_group
# Diagnostics go to standard output; standard error only counts the suppressed warnings of system headers.
find "$work" -name '*.cpp' -printf '%s %p\n' | sort -rn | sed 's/^[0-9]* //; s/\.cpp$//' |
  xargs -r -P 2 -n 1 bash -c 'tidy_group "$@"' _
