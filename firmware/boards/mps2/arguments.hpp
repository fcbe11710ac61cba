// The words that select what the benchmark runs: "workload=K5 depth=z16 size=320x240 rows=16 columns=64
// frames=2 first=0 buffers=2 ram=65536 order=turns".
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace zstrip::bench {

struct Arguments {
  std::string_view workload = "K5";  ///< a part of the text that was parsed
  std::string_view depth = "z16";    ///< a part of the text that was parsed
  std::uint16_t width = 320;
  std::uint16_t height = 240;
  std::uint16_t rows = 0;              ///< of a strip; 0: the planner decides
  std::uint16_t columns = 0;           ///< of a strip; 0: the picture's width
  std::uint32_t frames = 1;            ///< how many are measured
  std::uint32_t first = 0;             ///< the number of the first one
  std::uint8_t buffers = 0;            ///< of a strip's pixels that `ram` has to hold, too: 0 .. 2
  std::string_view format = "rgb565";  ///< of the pixels, likewise; a program with a scene of its own draws others too
  bool in_turns = false;               ///< strips as two cores draw them: every other one, then those between
  std::uint32_t ram = 0;               ///< bytes that the plan may take; 0: no limit but the board's
  std::string_view wrong_word{};       ///< the first word that is not understood; empty if all are
};

/// Words are separated by spaces; what is not given keeps its default. A number must fit its field.
Arguments parse_arguments(std::string_view text);

}  // namespace zstrip::bench
