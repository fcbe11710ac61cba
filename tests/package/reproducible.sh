#!/usr/bin/env bash
# reproducible.sh ROOT: the package is the same, byte for byte, wherever, when and by whom it is made.
set -euo pipefail
root=$(cd "$1" && pwd -P)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# The second: of a copy of the sources with other times, with other rights and in another time zone.
mkdir "$scratch/copy"
cp -R "$root"/{CMakeLists.txt,CHANGELOG.md,LICENSE,cmake,core,hal} "$scratch/copy"
mkdir "$scratch/copy/firmware"
cp -R "$root"/firmware/{package,examples,player,scenes} "$scratch/copy/firmware"
bash "$root/cmake/zstrip_package_sources.sh" "$scratch/first"
(umask 077 && cd / && TZ=Asia/Tokyo LC_ALL=C.UTF-8 bash "$scratch/copy/cmake/zstrip_package_sources.sh" "$scratch/second")

failed=0
for archive in "$scratch"/first/*.{tar.gz,zip}; do
  cmp "$archive" "$scratch/second/${archive##*/}" || failed=1
done
# What is in the archives is the folder.
mkdir "$scratch/tar" "$scratch/zip"
tar -C "$scratch/tar" -xzf "$scratch"/first/*.tar.gz
(cd "$scratch/zip" && cmake -E tar xf "$scratch"/first/*.zip)
diff -r "$scratch/first/zstrip" "$scratch/tar/zstrip" || failed=1
diff -r "$scratch/first/zstrip" "$scratch/zip/zstrip" || failed=1
exit "$failed"
