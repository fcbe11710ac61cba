// PROGRAM PICTURE: runs the program for ESP-IDF that it is linked with, on stand-ins for an RGB panel and a MIPI-DSI
// panel (tests/adapters). When it asks for the time of its 6th frame the glass is compared with PICTURE. Exit status 1
// if anything is wrong.
#include <cstdlib>

#include <esp_timer.h>

#include "compare_screen.hpp"
#include "esp_lcd_glass.hpp"
#include "screen.hpp"

extern "C" void app_main();

namespace {
const char* picture = nullptr;
}  // namespace

std::int64_t esp_timer_get_time() {
  using namespace zstrip::adapters_test;
  static int frames = 0;
  if (++frames > 5) {
    screen().colours = dsi_glass.is_on ? dsi_glass.colours : controller.shown();
    std::exit(backlight == 1 ? zstrip::package::compare_screen(picture) : 1);
  }
  return std::int64_t{33'000} * frames;
}

int main(int count, char** words) {
  if (count != 2) return 2;
  picture = words[1];
  app_main();
  return 1;  // only after a failure
}
