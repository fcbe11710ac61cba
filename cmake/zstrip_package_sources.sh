#!/usr/bin/env bash
# zstrip_package_sources.sh FOLDER [URL]: writes zstrip as a library for microcontrollers, the same for Arduino,
# PlatformIO, ESP-IDF and Zephyr: FOLDER/zstrip, FOLDER/zstrip-VERSION.tar.gz and, for the Arduino IDE, .zip. Needs no build
# tree. The same sources give the same bytes anywhere. URL: where the library is to be found, for the files that say it.
# Exit status 1 if a file is missing; 2 for wrong words.
set -euo pipefail
if [ $# -lt 1 ] || [ $# -gt 2 ]; then
  sed -n '2,5s/^# //p' "${BASH_SOURCE[0]}" >&2
  exit 2
fi
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd -P)
url=${2-}
mkdir -p "$1"
cd "$1"

version=$(sed -nE 's/^project\(zstrip VERSION ([0-9.]+) .*/\1/p' "$root/CMakeLists.txt")
[ -n "$version" ] || { echo "CMakeLists.txt states no version" >&2; exit 1; }

rm -rf zstrip
cp -R "$root/firmware/package" zstrip
cp -R "$root/core/zstrip" "$root/hal/zstrip_hal" zstrip/src
cp -R "$root/firmware/examples" zstrip/examples
cp "$root/LICENSE" "$root/CHANGELOG.md" zstrip
find zstrip -name '.*' -delete
# Every pipeline, for programs on hosts.
rm zstrip/src/zstrip/frame/{any_pipeline,no_seldom_rows,rows_of_*}.cpp

while IFS= read -r file; do
  sed -i -e "s|@VERSION@|$version|" -e "${url:+s|@URL@|$url|;}/@URL@/d" "$file"
done < <(grep -rlE '@(VERSION|URL)@' zstrip)

# Nothing of this machine and this day: times (the first that .zip has), owners, modes, order.
find zstrip -exec touch -h -d '1980-01-01 00:00:00 UTC' {} +
chmod -R u=rwX,go=rX zstrip
export LC_ALL=C TZ=UTC
tar --sort=name --owner=0 --group=0 --numeric-owner --format=ustar -cf - zstrip | gzip -9n >"zstrip-$version.tar.gz"
rm -f "zstrip-$version.zip"
find zstrip -type f | sort | zip -9Xq "zstrip-$version.zip" -@
