#!/usr/bin/env bash
# compilers.sh ROOT COMPILER: what compilers say of the package's headers. With an older language every header that an
# application includes ends with one error that says what to do; sketches compile for older cores (TEST_OLD_CORE), and with g++-11.
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
exit "$failed"
