#!/usr/bin/env bash
# without_cmake.sh ROOT: the commands of docs/porting.md that build zstrip without CMake, with the program of
# docs/program.md as main.cpp: what they make is whole, and draws, and the compilers say nothing. They are run as they are
# with ZSTRIP_LONG. Without, that for a Cortex-M3 gets only the sources that no other processor compiles; the program for
# the PC shows that all are named, and its sources are compiled as one, without optimisation.
set -euo pipefail
root=$(cd "$1" && pwd -P)
command -v arm-none-eabi-g++ >/dev/null || { echo "arm-none-eabi-g++ is not installed"; exit 77; }
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# block_after MARKER FILE: the block of code behind a comment of the page.
block_after() {
  awk -v marker="<!-- $1 -->" '$0 == marker { found = 1; next }
    found && /^```/ { if (inside) exit; inside = 1; next }
    inside { print }' "$2"
}
block_after "tests/structure/without_cmake.sh runs this" "$root/docs/porting.md" >"$scratch/commands"
block_after "tests/consumer compiles and runs this" "$root/docs/program.md" >"$scratch/main.cpp"
[ "$(grep -c 'g++' "$scratch/commands")" -eq 4 ] || { echo "docs/porting.md has no commands without CMake"; exit 1; }

if [ -z "${ZSTRIP_LONG-}" ]; then
  sed -i '/^arm-/s/ -r \$sources / -r $(grep thumb <<<"$sources") /' "$scratch/commands"
  grep -qF ' -r $(grep ' "$scratch/commands" || { echo "docs/porting.md has no line for all sources of a Cortex-M3"; exit 1; }
  echo 'printf "#include \"%s\"\n" $(sort <<<"$sources") >all.cpp' >"$scratch/join"
  sed -i -e "/^sources=/r $scratch/join" -e '/^g++/s/ -r \$sources / -r all.cpp /' \
    -e '/main\.cpp\|all\.cpp -o/s/\$options/& -O0/' "$scratch/commands"
  [ "$(grep -c -- '-O0' "$scratch/commands")" -eq 3 ] || { echo "docs/porting.md has no line for all sources of a PC"; exit 1; }
fi

ln -s "$root" "$scratch/zstrip"
cd "$scratch"
bash -euo pipefail commands 2>said || { cat said; exit 1; }
[ ! -s said ] || { echo "a compiler prints, for commands that a user types:"; cat said; exit 1; }
./main
missing=$(nm -u zstrip.o | awk '$2 ~ /6zstrip/ { print $2 }')
[ -z "$missing" ] || { echo "zstrip.o lacks $missing"; exit 1; }
if [ -z "${ZSTRIP_LONG-}" ]; then exit; fi
# What zstrip_m3.o lacks is the C library's or the compiler's.
missing=$(arm-none-eabi-nm -u zstrip_m3.o | awk '{ print $2 }' | grep -vE '^(mem(cpy|move|set|cmp)|__aeabi_.*|__clzsi2|__popcountsi2)$' || true)
[ -z "$missing" ] || { echo "zstrip_m3.o lacks $missing"; exit 1; }
# What main_m3.o needs of zstrip is there.
arm-none-eabi-nm -u main_m3.o | awk '$2 ~ /6zstrip/ { print $2 }' | sort -u >needed
arm-none-eabi-nm --defined-only zstrip_m3.o | awk '{ print $3 }' | sort -u >defined
missing=$(comm -23 needed defined)
[ -z "$missing" ] || { echo "main_m3.o needs what zstrip_m3.o lacks: $missing"; exit 1; }
[ -s needed ] || { echo "main_m3.o needs nothing of zstrip"; exit 1; }
