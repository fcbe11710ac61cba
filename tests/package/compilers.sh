#!/usr/bin/env bash
# compilers.sh ROOT COMPILER: what compilers say of the package's headers. With an older language every header that an
# application includes ends with one error that says what to do; sketches compile for older cores (TEST_OLD_CORE), and with g++-11.
# Core, drivers, player and a sketch compile in the newest language that an installed compiler knows.
set -euo pipefail
cd "$1"
compiler=$2
core=tests/package/arduino/hardware/zstrip/test
includes=(-Icore -Ihal -Ifirmware/player -Ifirmware/scenes/include -Ifirmware/package/src -I$core/cores/test -I$core/libraries/SPI)
failed=0

for language in gnu++11 c++17; do
  for header in core/zstrip/*.hpp firmware/package/src/zstrip.h firmware/package/src/zstrip_arduino.h; do
    said=$("$compiler" -std=$language "${includes[@]}" -fsyntax-only -x c++ "$header" 2>&1) || true
    if [ "$(grep -c 'error: #error zstrip needs C++20' <<<"$said")" -ne 1 ] || [ "$(grep -c 'error:' <<<"$said")" -ne 2 ]; then
      printf 'as %s %s does not end with one error that says what to do:\n%s\n' "$language" "$header" "$(head -n 5 <<<"$said")"
      failed=1
    fi
  done
done

# g++-11 is the oldest release that zstrip takes.
compilers=("$compiler")
if command -v g++-11 >/dev/null; then compilers+=(g++-11); else echo "g++-11 is not installed: without the oldest release"; fi
for each in "${compilers[@]}"; do
  for sketch in firmware/examples/{HelloPyramid/HelloPyramid,TwoBuffersDma/TwoBuffersDma}.ino; do
    "$each" -std=gnu++20 -Wall -Wextra -Werror -DTEST_OLD_CORE "${includes[@]}" -include Arduino.h -fsyntax-only \
      -x c++ "$sketch" || failed=1
  done
done

# ESP-IDF 6 compiles as gnu++26, which GCC 12 does not know.
scratch=$(mktemp)
trap 'rm "$scratch"' EXIT
newest=("$compiler" -std=gnu++23)
if command -v clang++-19 >/dev/null; then newest=(clang++-19 -std=gnu++26); else echo "clang++-19 is not installed: without gnu++26"; fi
{
  find core/zstrip hal/zstrip_hal firmware/player/zstrip_player firmware/scenes/stage.cpp -name '*.cpp' ! -name 'any_p*.cpp' \
    ! -name '*rows*.cpp' -printf '#include "%p"\n'
  printf '#include "%s"\n' Arduino.h firmware/examples/HelloPyramid/HelloPyramid.ino
} >"$scratch"
"${newest[@]}" -Wall -Wextra -Werror "${includes[@]}" -I. -fsyntax-only -x c++ "$scratch" || failed=1
exit "$failed"
