// Ends a program that cannot continue: shows the reason on the console and, if it still works, on the panel.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "portable/failure.hpp"
#include "zstrip_hal/message_screen.hpp"

namespace zstrip::board {

/// Call it after any failure, also during a write, which ends first. Waits only for the bus, at most for three of its
/// time-outs; if a bus never returns, the watchdog resets the board. Afterwards the caller ends the program without
/// feeding the watchdog, so that a board with one starts again. The panel shows the first `max_words` characters.
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
  // A command may have been interrupted: the frame after an error is shown correctly.
  if (error != hal::Error::none) error = hal::show_message(panel, words);
  if (error != hal::Error::none) print(Failure{"panic on the display", hal::message(error)});
}

}  // namespace zstrip::board
