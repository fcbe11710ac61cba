// Steps that all decoders of records use.
#pragma once

#include <cstdint>

#include "zstrip/store/tile.hpp"

namespace zstrip::detail {

/// Calls `step(x)` for each cell of a row; unrolled for a row of full width.
template <typename Step>
[[gnu::always_inline]] inline void for_row(std::uint32_t width, Step step) {
  if (width == kTileSide) {
    step(0), step(1), step(2), step(3), step(4), step(5), step(6), step(7);
  } else {
    for (std::uint32_t x = 0; x < width; ++x) step(x);
  }
}

/// Makes the compiler compute a chain of values one after the other. Otherwise it computes them in parallel, which
/// needs more registers than Thumb-1 has and takes twice the time.
[[gnu::always_inline]] inline void in_order(std::uint32_t& value) { asm("" : "+r"(value)); }

/// True if a row's cover has cell x. A shift and a test of the sign take one instruction less on Thumb-1 than a mask.
[[gnu::always_inline]] inline bool covers(std::uint32_t row, std::uint32_t x) {
  std::uint32_t at_the_top = row << (31 - x);
  return static_cast<std::int32_t>(at_the_top) < 0;
}

[[gnu::always_inline]] inline std::uint32_t little_endian(const std::uint8_t* bytes) {
  return bytes[0] | std::uint32_t{bytes[1]} << 8 | std::uint32_t{bytes[2]} << 16 | std::uint32_t{bytes[3]} << 24;
}

}  // namespace zstrip::detail
