#!/usr/bin/env bash
# zstrip_package_sources.sh FOLDER [URL]: writes zstrip as a library for microcontrollers, the same for Arduino,
# PlatformIO, ESP-IDF and Zephyr: FOLDER/zstrip, FOLDER/zstrip-VERSION.tar.gz and, for the Arduino IDE, .zip. Needs no build
# tree. The same sources give the same bytes anywhere. URL: where the library is to be found, for the files that say it;
# without it they say https://example.org/, because Arduino requires an address.
# Exit status 1 if a file is missing; 2 for wrong words.
set -euo pipefail
if [ $# -lt 1 ] || [ $# -gt 2 ]; then
  sed -n '2,6s/^# //p' "${BASH_SOURCE[0]}" >&2
  exit 2
fi
source "$(dirname "${BASH_SOURCE[0]}")/zstrip_package_files.sh"
root=$zstrip_root
mkdir -p "$1"
cd "$1"

rm -rf zstrip
cp -R "$root/firmware/package" zstrip
cp -R "$root/core/zstrip" "$root/hal/zstrip_hal" "$root"/firmware/player/zstrip_player{,.h} zstrip/src
rm zstrip/src/zstrip_player/any_player.hpp
# The headers that set scenes in motion, for the player.
mkdir zstrip/src/zstrip_scenes
cp "$root"/firmware/scenes/stage.cpp "$root"/firmware/scenes/include/zstrip_scenes/{stage,baked_stage,built_in}.hpp zstrip/src/zstrip_scenes
cp -R "$root/firmware/examples" zstrip/examples
# The sketches for libraries of displays have the model of YourModel, and their adapter beside them.
for sketch in $(grep -l 'adapters::' zstrip/examples/*/*.ino); do
  adapter=$(sed -nE 's/^#include "(.*)"$/\1/p' "$sketch" | grep -v '^scene')
  cp zstrip/examples/{YourModel/scene.hpp,adapters/"$adapter"} "$(dirname "$sketch")"
done
# Sketches only; and of the adapters those for what takes the package in.
mv zstrip/examples/adapters zstrip/adapters
rm zstrip/adapters/{pico_spi_dma,sdl2_texture}.hpp
cp "$root/LICENSE" "$root/CHANGELOG.md" zstrip
find zstrip -name '.*' -delete
# Every pipeline, for programs on hosts; visibility methods, but the declarations that stages include.
rm zstrip/src/zstrip/frame/{any_p{icker,ipeline},{no_,}rows_of_*}.cpp zstrip/src/zstrip/visibility.hpp \
  zstrip/src/zstrip/visibility/{{no_,}rows_of_*.cpp,{bsp_order,make_rows,midpoint,stages,visible_sets}.hpp}

zstrip_write_out zstrip "${2:-https://example.org/}"
zstrip_archive zstrip >"zstrip-$zstrip_version.tar.gz"
rm -f "zstrip-$zstrip_version.zip"
find zstrip -type f | sort | zip -9Xq "zstrip-$zstrip_version.zip" -@
