#!/usr/bin/env bash
# freestanding.sh ROOT [--few] COMPILER FLAGS...: compiles core, hal and player for a freestanding target and reads the
# objects: they may call the four mem functions and the compiler's integer helpers, and nothing may run before main. The
# sources of each are compiled together. The pipelines that are for hosts alone are left out, but with ZSTRIP_LONG and
# without --few.
# freestanding.sh ROOT --built BUILD [--player] COMPILER: reads the libraries of a build for boards instead; that of the
# player where one of the boards has a program with it.
set -euo pipefail
root=$1
shift
few=yes built= player=
if [ -n "${ZSTRIP_LONG-}" ]; then few=; fi
case $1 in
  --few) few=yes; shift ;;
  --built) few=yes built=$2; shift 2 ;;
esac
if [ "$1" = --player ]; then player=yes; shift; fi
compiler=$1
shift
if ! command -v "$compiler" >/dev/null; then
  echo "$compiler is not installed"
  exit 77
fi
objects=$(mktemp -d)
trap 'rm -rf "$objects"' EXIT

# The headers' templates are instantiated by the .cpp files. Without optimisation, which is quicker and folds nothing away:
# what the sources call, the objects call. Firmware is linked without a library anyway.
pipelines='/(any_p[a-z]*|rows_of_[a-z_]*)\.cpp"'
# compile FOLDER/WHAT COMPILER FLAGS...: WHAT is `pipelines` or `others`.
compile() {
  local folder=${1%/*} what=${1##*/} included
  shift
  included=$(find "$folder" -name '*.cpp' ! -name 'no_rows_of_*' -printf '#include "%p"\n' | sort)
  [ -n "$included" ] || { echo "$folder holds no source"; return 1; }
  if [ "$what" = pipelines ]; then included=$(grep -E "$pipelines" <<<"$included"); else included=$(grep -vE "$pipelines" <<<"$included"); fi
  "$@" -std=c++20 -O0 -ffreestanding -fno-exceptions -fno-rtti -fno-threadsafe-statics -Wall -Wextra -Werror \
    -I"$root/core" -I"$root/hal" -I"$root/firmware/player" -I"$root/firmware/scenes/include" \
    -o "$objects/$(tr / _ <<<"${folder#"$root"/}")_$what.o" -c -x c++ - <<<"$included"
}
export root objects pipelines
export -f compile
if [ -n "$built" ]; then
  read_from=("$built"/{core/libzstrip_core,hal/libzstrip_hal}.a)
  if [ -n "$player" ]; then read_from+=("$built/firmware/player/libzstrip_player.a"); fi
else
  units=("$root"/{core/zstrip,hal/zstrip_hal,firmware/player/zstrip_player}/others)
  if [ -z "$few" ]; then units+=("$root"/core/zstrip/{frame,visibility}/pipelines); fi
  printf '%s\n' "${units[@]}" |
    xargs -P 2 -I{} bash -euo pipefail -c 'compile "$@"' _ {} "$compiler" "$@"
  read_from=("$objects"/*.o)
fi

prefix=
case "$compiler" in *arm-none-eabi-*) prefix=arm-none-eabi- ;; esac
"${prefix}nm" --format=posix --defined-only "${read_from[@]}" | awk 'NF > 2 { print $1 }' | sort -u >"$objects/defined"
"${prefix}nm" --format=posix --undefined-only "${read_from[@]}" | awk 'NF == 2 && $2 == "U" { print $1 }' | sort -u >"$objects/undefined"
[ -s "$objects/defined" ] || { echo "no object defines anything"; exit 1; }

# Integer division, shifts, multiplication, counting bits, switch tables; never __aeabi_f*, __aeabi_d*, __aeabi_*2f.
allowed='mem(cpy|move|set|cmp)|__aeabi_(mem(cpy|move|set|clr)[48]?|u?idiv|u?idivmod|u?ldivmod|lmul|llsl|llsr|lasr|u?lcmp)'
allowed+='|__gnu_thumb1_case_(uqi|sqi|uhi|shi|si)|__(clz|ctz|popcount|ffs|bswap)[sd]i2|_GLOBAL_OFFSET_TABLE_'
allowed+='|_ZN6zstrip6scenes.*'  # the turntable, for the player
foreign=$(comm -13 "$objects/defined" "$objects/undefined" | grep -vxE "$allowed${few:+|_ZNK?6zstrip.*}" || true)
failed=0
if [ -n "$foreign" ]; then
  echo "symbols that a freestanding program does not have:"
  for symbol in $foreign; do
    echo "  $symbol" "$("${prefix}nm" -A --undefined-only "${read_from[@]}" | awk -v s="$symbol" '$NF == s { print $1 }' | head -n 3 | tr '\n' ' ')"
  done
  failed=1
fi

# A lone object is read without its name: the section's is always there.
starters=$("${prefix}readelf" -SW "${read_from[@]}" |
  awk '/^File:/ { file = $2 } match($0, /\.(init_array|ctors|preinit_array|tbss|tdata)/) { print substr($0, RSTART, RLENGTH), file }' | sort -u)
if [ -n "$starters" ]; then
  printf 'code that runs before main, or thread-local data:\n%s\n' "$starters"
  failed=1
fi
exit "$failed"
