#!/usr/bin/env bash
# debian.sh ROOT BUILD VERSION COMPILER: the packages for Debian hold what they must, and programs are built against them by
# pkg-config, unpacked into a root of its own: that of docs/program.md, and one with AnyRenderer.
set -euo pipefail
root=$(cd "$1" && pwd -P)
build=$2 version=$3 compiler=$4
for tool in cpack dpkg-deb dpkg-shlibdeps pkg-config; do
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
[ -s "$system/usr/share/doc/libzstrip-dev/copyright" ] || complain "libzstrip-dev has no copyright"
[ "$(dpkg-deb -f "$library" Version)" = "$version" ] || complain "libzstrip-dev is of another version"
if [ -n "$(find "$system" -type f ! -path '*/usr/*')" ]; then complain "libzstrip-dev has files outside of /usr"; fi

# Nothing of the repository, and nothing that is installed here.
cat >"$scratch/pages.awk" <<'AWK'
$0 == "<!-- tests/consumer compiles and runs this -->" { found = 1; next }
found && /^```/ { if (inside) exit; inside = 1; next }
inside { print }
AWK
awk -f "$scratch/pages.awk" "$root/docs/program.md" >"$scratch/pyramid.cpp"
PKG_CONFIG_LIBDIR=$(find "$system" -type d -name pkgconfig)
export PKG_CONFIG_LIBDIR
# program NAME SOURCE MODULE
program() {
  local flags
  read -r -a flags <<<"$(pkg-config --cflags --libs "$3")"
  "$compiler" -std=c++20 -O1 "$2" "${flags[@]}" -o "$scratch/$1" && "$scratch/$1" || complain "$1 is not built or does not run"
}
program pyramid "$scratch/pyramid.cpp" zstrip
program any "$root/tests/consumer/project/triangle.cpp" zstrip-any
pkg-config --exact-version "$version" zstrip || complain "zstrip.pc is of another version"

if [ -e "$command" ]; then
  dpkg-deb -x "$command" "$system"
  [ "$("$system/usr/bin/zstrip" --version)" = "zstrip $version" ] || complain "the command does not run"
  "$system/usr/bin/zstrip" render knot --size 64x64 -o "$scratch/knot.png" --quiet || complain "the command does not draw"
  dpkg-deb -f "$command" Depends | grep -q 'libassimp5' || complain "zstrip does not depend on the libraries it needs"
fi
exit "$failed"
