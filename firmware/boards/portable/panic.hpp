// The end of a program that cannot go on: it shows why, on the console and on the panel as far as that still works.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "portable/failure.hpp"
#include "zstrip_hal/message_screen.hpp"

namespace zstrip::board {

/// After any failure, also amid a write: what is under way ends first. Waits for the bus only, at most for three of its
/// time-outs; a bus that never returns is the watchdog's. Afterwards the caller ends the program without feeding it:
/// the board starts again, where it has one. The panel shows the first `max_words` characters.
template <std::size_t max_words = 96, hal::Display Panel>
void panic(Panel& panel, const Failure& failure) {
  print("panic: ");
  print(failure);
  std::array<char, max_words> text{};
  std::size_t size = 0;
  for (const char* part : std::array{"panic: ", failure.doing, ": ", failure.error}) {
    while (*part != '\0' && size < text.size()) text[size++] = *part++;
  }
  static_cast<void>(panel.wait());
  const std::string_view words(text.data(), size);
  hal::Error error = hal::show_message(panel, words);
  // A command may have been broken off: the frame after an error shows right.
  if (error != hal::Error::none) error = hal::show_message(panel, words);
  if (error != hal::Error::none) print(Failure{"panic on the display", hal::message(error)});
}

}  // namespace zstrip::board
