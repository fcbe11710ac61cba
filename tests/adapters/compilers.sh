#!/usr/bin/env bash
# compilers.sh ROOT COMPILER: adapters compile with every release and variant of a library that their pages name, and
# one that is too old ends with one error that says what to install.
set -euo pipefail
cd "$1"
here=tests/adapters
adapters=firmware/examples/adapters
compile=("$2" -std=c++20 -Icore -Ihal -Ifirmware/player -Ifirmware/scenes/include -Ifirmware/package/src -fsyntax-only -x c++)
failed=0

# compiles WHAT OPTION...
compiles() {
  local said
  said=$("${compile[@]}" "${@:2}" 2>&1) || { printf '%s:\n%s\n' "$1" "$(head -n 5 <<<"$said")"; failed=1; }
}
compiles "LovyanGFX alone is not taken" -I$here/declarations $adapters/lovyangfx.hpp
compiles "M5GFX alone is not taken" -I$here/declarations_m5gfx $adapters/lovyangfx.hpp
compiles "M5GFX, which the sketch includes, is not taken where LovyanGFX is installed, too" \
  -I$here/declarations_m5gfx -I$here/declarations -include M5GFX.h $adapters/lovyangfx.hpp
compiles "LovyanGFX is not taken where M5GFX is installed, too" \
  -I$here/declarations_m5gfx -I$here/declarations $adapters/lovyangfx.hpp
compiles "the sketch of M5GFX does not compile" -I$here/declarations_m5gfx -I$adapters -Ifirmware/examples/YourModel \
  -Itests/package/arduino/hardware/zstrip/test/cores/test -include Arduino.h firmware/examples/M5Gfx/M5Gfx.ino

compiles "ESP-IDF 5.0.1 is refused" -I$here/declarations $adapters/esp_lcd.hpp
said=$("${compile[@]}" -I$here/declarations -DESP_IDF_VERSION_PATCH=0 $adapters/esp_lcd.hpp 2>&1) || true
if ! grep -q 'error: #error esp_lcd.hpp needs ESP-IDF 5.0.1' <<<"$said"; then
  printf 'ESP-IDF 5.0.0 does not end with an error that says what to install:\n%s\n' "$(head -n 5 <<<"$said")"
  failed=1
fi
exit "$failed"
