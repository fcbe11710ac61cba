// PROGRAM PICTURE: runs the sketch that it is linked with for 20 turns of its loop, on a stand-in for a library of
// displays (tests/adapters), and compares the screen with PICTURE. Exit status 1 if anything is wrong.
#include <chrono>
#include <cstdio>

#include <Arduino.h>
#undef abs
#undef max
#undef min
#undef round

#include "compare_screen.hpp"

namespace {
bool has_spoken = false;
}

SerialPort Serial;
void SerialPort::begin(unsigned long) {}
size_t SerialPort::println(const char* text) {
  std::printf("the sketch says: %s\n", text);
  has_spoken = true;
  return 0;
}
unsigned long millis() {
  static unsigned long now = 0;
  return now += 33;
}

int main(int count, char** words) {
  if (count != 2) return 2;
  setup();
  for (int turn = 0; turn < 20; ++turn) loop();
  return has_spoken ? 1 : zstrip::package::compare_screen(words[1]);
}
