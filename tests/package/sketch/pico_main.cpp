// PROGRAM PICTURE: runs the program for the Raspberry Pi Pico SDK that it is linked with, whose main() is called
// pico_main(), on a stand-in for the SDK (tests/adapters). When it asks for the time of its 21st frame the screen is
// compared with PICTURE. Exit status 1 if anything is wrong.
#include <cstdio>
#include <cstdlib>
#include <thread>

#include <pico/multicore.h>
#include <pico/stdlib.h>

#include "compare_screen.hpp"

int pico_main();

namespace {
const char* picture = nullptr;
}

absolute_time_t get_absolute_time() {
  static int turns = 0;
  if (++turns > 20) {
    const int status = zstrip::package::compare_screen(picture);
    std::fflush(nullptr);
    std::_Exit(status);  // a second core does not end
  }
  return {std::uint64_t{33'000} * static_cast<unsigned>(turns)};
}
std::uint32_t to_ms_since_boot(absolute_time_t time) { return static_cast<std::uint32_t>(time.microseconds / 1000); }

void multicore_launch_core1(void (*entry)()) { std::thread(entry).detach(); }
void tight_loop_contents() { std::this_thread::yield(); }

int main(int count, char** words) {
  if (count != 2) return 2;
  picture = words[1];
  return pico_main();
}
