#!/usr/bin/env bash
# zstrip_release.sh FOLDER [--url URL] [PART...]: makes a release of the commit that is checked out, in FOLDER, and tries it
# from these files alone (tests/package/newcomer.sh). Parts, all of them by default, in this order:
#   packages    zstrip-VERSION.tar.gz and .zip, for Arduino, PlatformIO, ESP-IDF and Zephyr
#   debian      libzstrip-dev_VERSION_ARCHITECTURE.deb and zstrip_VERSION_ARCHITECTURE.deb
#   npm         zstrip-npm-VERSION.tgz
#   rust        zstrip-rust-VERSION.tar.gz
#   micropython zstrip-micropython-VERSION.tar.gz
#   pico        zstrip_pico_*.uf2 and zstrip_pico2_*.uf2
#   playground  zstrip-playground-VERSION.tar.gz, which has the programs of the part pico in it
#   site        zstrip-site-VERSION.tar.gz, the documents, with the playground
# and always zstrip-VERSION-source.tar.gz, from which all others are built, and SHA256SUMS. Builds in FOLDER/build, which may
# be deleted, and is if it is another commit's. The same commit gives the same bytes with the same compilers. ZSTRIP_JOBS:
# how many compilers at a time, 2 by default. URL is written into the files that name an address.
# Exit status 1 if a part cannot be made or does not work; 2 for wrong words.
set -euo pipefail
umask 022  # of folders in packages for Debian, too: CPack gives them the rights that the umask leaves
parts=(packages debian npm rust micropython pico playground site)
say() { printf 'release: %s\n' "$*" >&2; }
usage() {
  sed -n '2,16s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" >&2
  exit 2
}

if [ $# -lt 1 ] || [[ $1 == -* ]]; then usage; fi
folder=$1 url=
shift
if [ "${1-}" = --url ]; then
  [ $# -ge 2 ] || usage
  url=$2
  shift 2
fi
for part in "$@"; do
  [[ " ${parts[*]} " == *" $part "* ]] || { say "there is no part '$part'; choose among: ${parts[*]}"; exit 2; }
done
wanted=" ${*:-${parts[*]}} "
wants() { [[ $wanted == *" $1 "* ]]; }

source "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/zstrip_package_files.sh"
version=$zstrip_version
jobs=${ZSTRIP_JOBS:-2}
SOURCE_DATE_EPOCH=$(date -u -d "$zstrip_day" +%s)
export SOURCE_DATE_EPOCH
git -C "$zstrip_root" diff --quiet HEAD -- || { say "the sources differ from their commit; commit first"; exit 1; }
mkdir -p "$folder"
folder=$(cd "$folder" && pwd -P)
build=$folder/build
rm -f "$folder"/{*.tar.gz,*.tgz,*.zip,*.deb,*.uf2,SHA256SUMS}
# Sources of another commit may be older than the objects that ninja finds there, which it would keep.
commit=$(git -C "$zstrip_root" rev-parse HEAD)
[ "$(cat "$build/commit" 2>/dev/null)" = "$commit" ] || rm -rf "$build"
mkdir -p "$build"
echo "$commit" >"$build/commit"

git -C "$zstrip_root" archive --prefix="zstrip-$version/" HEAD | gzip -9n >"$folder/zstrip-$version-source.tar.gz"
root=$build/zstrip-$version
rm -rf "$root"
tar -C "$build" -xzf "$folder/zstrip-$version-source.tar.gz"

# quietly WHAT COMMAND...: the output is shown if the command fails.
quietly() {
  say "$1"
  shift
  "$@" </dev/null >"$build/log" 2>&1 || { tail -n 60 "$build/log" >&2; say "failed; the whole output is $build/log"; exit 1; }
}
# in_archive FOLDER ARCHIVE: FOLDER with the release's day, whose name is its base name.
in_archive() {
  find "$1" -exec touch -h -d "@$SOURCE_DATE_EPOCH" {} +
  chmod -R u=rwX,go=rX "$1"
  (cd "$(dirname "$1")" && zstrip_archive "$(basename "$1")") >"$folder/$2"
}
# configure NAME OPTION...: a build folder without tests.
configure() {
  quietly "configuring $1" cmake -S "$root" -B "$build/$1" -G Ninja -DCMAKE_BUILD_TYPE=Release -DZSTRIP_TESTS=OFF "${@:2}"
}

if wants packages; then
  quietly "packages for microcontrollers" bash "$root/cmake/zstrip_package_sources.sh" "$build/packages" ${url:+"$url"}
  cp "$build"/packages/zstrip-"$version".{tar.gz,zip} "$folder"
fi

if wants debian; then
  configure host -DZSTRIP_FIRMWARE=OFF -DZSTRIP_COMPILE_TOGETHER=host-sim -DCMAKE_INSTALL_PREFIX=/usr
  quietly "the command and libraries for Debian" cmake --build "$build/host" --parallel "$jobs"
  rm -rf "$build/host/packages"
  quietly "packages for Debian" cpack --config "$build/host/CPackConfig.cmake" -G DEB -B "$build/host/packages"
  cp "$build"/host/packages/*.deb "$folder"
  if command -v lintian >/dev/null; then
    quietly "Debian's rules for packages" lintian --allow-root --fail-on error,warning "$folder"/*.deb
  else
    say "lintian is not installed: nothing looks whether the packages keep Debian's rules"
  fi
fi

if wants npm; then
  quietly "the package for pages" bash "$root/cmake/zstrip_package_npm.sh" "$build/npm" ${url:+"$url"}
  cp "$build/npm/zstrip-npm-$version.tgz" "$folder"
fi

if wants rust; then
  quietly "the crate for Rust" bash "$root/cmake/zstrip_package_rust.sh" "$build/rust" ${url:+"$url"}
  cp "$build/rust/zstrip-rust-$version.tar.gz" "$folder"
fi

if wants micropython; then
  quietly "the module for MicroPython" bash "$root/cmake/zstrip_package_micropython.sh" "$build/micropython"
  cp "$build/micropython/zstrip-micropython-$version.tar.gz" "$folder"
fi

# pico BOARD TOOLCHAIN OPTION...
pico() {
  configure "$1" "-DCMAKE_TOOLCHAIN_FILE=$root/cmake/toolchains/$2.cmake" -DZSTRIP_HOST_SIM=OFF "${@:3}"
  quietly "programs for $1" cmake --build "$build/$1" --parallel "$jobs" --target "zstrip_$1_uf2"
  cp "$build/$1"/firmware/bin/zstrip_"$1"_*.uf2 "$folder"
}
if wants pico; then
  pico pico arm-none-eabi -DZSTRIP_CPU=cortex-m0
  pico pico2 arm-none-eabi -DZSTRIP_CPU=cortex-m33
  pico pico2_riscv rv32imac -DZSTRIP_CPU=rv32imac
fi

if wants playground; then
  for board in PICO PICO2; do
    program=$folder/zstrip_${board,,}_player.uf2
    if [ -f "$program" ]; then export "ZSTRIP_${board}_PROGRAM=$program"; fi
  done
  quietly "the playground, some minutes" bash "$root/host-sim/play/build" "$build/play"
  rm -rf "$build/zstrip-playground-$version"
  cp -R "$build/play/page" "$build/zstrip-playground-$version"
  in_archive "$build/zstrip-playground-$version" "zstrip-playground-$version.tar.gz"
fi

if wants site; then
  page=()
  if wants playground; then page=("$build/play/page"); fi
  quietly "the documents as a site" bash "$root/docs/site/build" "$build/site" "${page[@]}"
  rm -rf "$build/zstrip-site-$version"
  cp -R "$build/site/html" "$build/zstrip-site-$version"
  in_archive "$build/zstrip-site-$version" "zstrip-site-$version.tar.gz"
fi

(cd "$folder" && find . -maxdepth 1 -type f ! -name SHA256SUMS -printf '%f\n' | sort | xargs sha256sum >SHA256SUMS)
quietly "what a newcomer does with it" bash "$root/tests/package/newcomer.sh" "$folder"
cat "$build/log" >&2
cat "$folder/SHA256SUMS"
