// The words that select the benchmark's run: "workload=K5 depth=z16 size=320x240 rows=16 columns=64 frames=2 first=0
// buffers=2 ram=65536 order=turns".
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
  std::uint16_t rows = 0;              ///< rows of a strip; 0: the planner decides
  std::uint16_t columns = 0;           ///< columns of a strip; 0: the picture's width
  std::uint32_t frames = 1;            ///< number of measured frames
  std::uint32_t first = 0;             ///< number of the first frame
  std::uint8_t buffers = 0;            ///< pixel buffers of a strip that `ram` must also hold: 0 .. 2
  std::string_view format = "rgb565";  ///< pixel format, a part of the text that was parsed; only a program with its
                                       ///< own scene draws other formats
  bool in_turns = false;               ///< draws strips in the order of two cores: every other one, then the remaining
                                       ///< ones
  std::uint32_t ram = 0;               ///< bytes for the plan; 0: only the board limits it
  std::string_view wrong_word{};       ///< the first unknown word; empty if all are known
};

/// Parses words that are separated by spaces; a missing word keeps its default. A number must fit its field.
Arguments parse_arguments(std::string_view text);

}  // namespace zstrip::bench
