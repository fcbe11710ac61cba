#!/usr/bin/env bash
# debian.sh ROOT BUILD VERSION COMPILER [command]: the packages for Debian hold what they must, and programs are built against them
# by pkg-config and by CMake, unpacked into a root of its own: that of docs/program.md, one with AnyRenderer, and players
# in C and in C++, which draw what the command does. With the word `command`, BUILD has the command, and a package of it.
set -euo pipefail
root=$(cd "$1" && pwd -P)
build=$2 version=$3 compiler=$4 has_command=${5-}
for tool in cpack dpkg-deb dpkg-shlibdeps dpkg-parsechangelog pkg-config cmake cc gzip; do
  command -v "$tool" >/dev/null || { echo "$tool is not installed"; exit 77; }
done
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
failed=0
complain() {
  echo "$*"
  failed=1
}

cpack --config "$build/CPackConfig.cmake" -B "$scratch/packages" >"$scratch/said" 2>&1 || { cat "$scratch/said"; exit 1; }
library=$(echo "$scratch"/packages/libzstrip-dev_"${version}"_*.deb)
command=$(echo "$scratch"/packages/zstrip_"${version}"_*.deb)
system=$scratch/system
dpkg-deb -x "$library" "$system"
# documented PACKAGE ARCHIVE FILE...: what Debian's rules ask for that lintian would miss (cmake/zstrip_release.sh).
documented() {
  local package=$1 file
  dpkg-deb -f "$2" Maintainer | grep -qE '^[^<]+ <[^@ ]+@[^@ ]+>$' || complain "$package has a maintainer without an address"
  for file in "share/doc/$package/copyright" "share/doc/$package/changelog.gz" "${@:3}"; do
    [ -s "$system/usr/$file" ] || complain "$package has no $file"
  done
  gzip -dc "$system/usr/share/doc/$package/changelog.gz" >"$scratch/changelog"
  dpkg-parsechangelog -l "$scratch/changelog" -S Version | grep -qxF "$version" ||
    complain "$package has a changelog of another version, or none that dpkg can read"
}
documented libzstrip-dev "$library"
[ "$(dpkg-deb -f "$library" Version)" = "$version" ] || complain "libzstrip-dev is of another version"
if [ -n "$(find "$system" -type f ! -path '*/usr/*')" ]; then complain "libzstrip-dev has files outside of /usr"; fi

# Nothing of the repository, and nothing that is installed here.
cat >"$scratch/pages.awk" <<'AWK'
$0 == "<!-- tests/consumer compiles and runs this -->" { found = 1; next }
found && /^```/ { if (inside) exit; inside = 1; next }
inside { print }
AWK
awk -f "$scratch/pages.awk" "$root/docs/program.md" >"$scratch/main.cpp"
PKG_CONFIG_LIBDIR=$(find "$system" -type d -name pkgconfig)
export PKG_CONFIG_LIBDIR
read -r -a flags <<<"$(pkg-config --cflags --libs zstrip-any)"
"$compiler" -std=c++20 -O1 "$root/tests/consumer/project/triangle.cpp" "${flags[@]}" -o "$scratch/any" && "$scratch/any" ||
  complain "a program with zstrip-any is not built or does not run"

# The lines that the documents print.
for page in program releasing; do
  line=$(grep -m 1 '^g++ .*pkg-config .*zstrip)' "$root/docs/$page.md") || complain "docs/$page.md has no line with pkg-config"
  (cd "$scratch" && rm -f main && eval "${line/#g++/"$compiler"}" && ./main) || complain "docs/$page.md: $line"
done
said=$("$compiler" -std=c++17 -fsyntax-only "$scratch/main.cpp" "${flags[@]}" 2>&1) && complain "C++17 is not refused"
grep -q 'zstrip needs C++20.* -std=c++20' <<<"$said" || complain "nothing says that -std=c++20 is missing: $said"
pkg-config --exact-version "$version" zstrip || complain "zstrip.pc is of another version"

# players: a scene that the command bakes, drawn with the player.
players() {
  local sources=$root/tests/package/player zstrip=$system/usr/bin/zstrip view=(--size 160x120 --quiet)
  local flags libraries program
  mkdir "$scratch/baked"
  for type in zsc hpp; do "$zstrip" bake room -o "$scratch/baked/scene.$type" "${view[@]}"; done
  "$zstrip" render room -o "$scratch/expected.raw" --format rgb565 "${view[@]}"
  read -r -a flags <<<"$(pkg-config --cflags zstrip-player) -O1 -Wall -Wextra -Werror -I$scratch/baked"
  read -r -a libraries <<<"$(pkg-config --libs zstrip-player)"
  cc -std=c99 -pedantic "${flags[@]}" -c "$sources/picture.c" -o "$scratch/picture.o"
  "$compiler" -std=c++20 "${flags[@]}" "$sources/pipeline.cpp" "$scratch/picture.o" "${libraries[@]}" \
    -o "$scratch/in_c"
  "$compiler" -std=c++20 "${flags[@]}" "$sources/picture.cpp" "${libraries[@]}" -o "$scratch/in_cpp"
  cmake -S "$sources" -B "$scratch/by_cmake" -DCMAKE_PREFIX_PATH="$system/usr" -DCMAKE_CXX_COMPILER="$compiler" \
    -DVERSION="$version" -DBAKED="$scratch/baked" >"$scratch/said" 2>&1 || cat "$scratch/said"
  cmake --build "$scratch/by_cmake" >"$scratch/said" 2>&1 || cat "$scratch/said"
  for program in "$scratch"/{in_,by_cmake/in_}{c,cpp}; do
    "$program" "$scratch/baked/scene.zsc" 160 120 >"$scratch/picture.raw" || complain "$program does not run"
    cmp "$scratch/picture.raw" "$scratch/expected.raw" || complain "$program draws another picture"
  done
}

if [ -n "$has_command" ]; then
  [ -e "$command" ] || { echo "the build has the command, but cpack makes no package of it"; exit 1; }
  dpkg-deb -x "$command" "$system"
  documented zstrip "$command" share/man/man1/zstrip{,-any,-measure}.1.gz
  names=$("$system/usr/bin/zstrip" --help | sed -n '/^Subcommands/,/^Examples/s/^  \([a-z]*\) .*/\1/p')
  [ -n "$names" ] || complain "zstrip --help names no command"
  for name in $names; do
    gzip -dc "$system/usr/share/man/man1/zstrip.1.gz" | grep -qE "^\.BR? .*\b$name\b" || complain "zstrip.1 has no '$name'"
  done
  [ "$("$system/usr/bin/zstrip" --version)" = "zstrip $version" ] || complain "the command does not run"
  "$system/usr/bin/zstrip" render knot --size 64x64 -o "$scratch/knot.png" --quiet || complain "the command does not draw"
  players
  dpkg-deb -f "$command" Depends | grep -q 'libassimp5' || complain "zstrip does not depend on the libraries it needs"
fi
exit "$failed"
