// A coordinate of bilinear texels: between which texels it lies, and where.
#pragma once

#include <cstdint>

namespace zstrip::detail {

/// A texture coordinate of a run, from the centres of texels: the texel before it, and its distance from that one. On a
/// side of one texel it stays 0, and the next texel is the same one.
struct CellAxis {
  /// The bit of a distance that a step has moved beyond one of the two texels.
  static constexpr std::uint32_t kOutside = 1U << 31;

  std::uint32_t start, step;   ///< 0.32 of the texture
  std::uint32_t step_in_cell;  ///< 1.31 texels; kOutside if a step is as long as a texel, or longer
  std::uint32_t log2_size, to_texel;

  CellAxis(std::uint32_t place, std::uint32_t place_step, std::uint32_t log2)
      : start(log2 == 0 ? 0 : place - (1U << (31 - log2))),
        step(log2 == 0 ? 0 : place_step),
        log2_size(log2),
        to_texel(log2 == 0 ? 31 : 32 - log2) {
    const std::int32_t texels = log2 == 0 ? 0 : static_cast<std::int32_t>(step) >> (32 - log2);
    step_in_cell = log2 == 0 ? 0 : texels == 0 || texels == -1 ? step << (log2 - 1) : kOutside;
  }
  std::uint32_t at(std::int32_t pixel) const { return start + step * static_cast<std::uint32_t>(pixel); }
  std::uint32_t texel(std::uint32_t coordinate) const { return coordinate >> to_texel; }
  /// Returns the distance from the texel, 0.31. No bit is lost: a side of two texels or more has one to spare.
  std::uint32_t in_cell(std::uint32_t coordinate) const { return coordinate << log2_size >> 1; }
  /// Returns the next texel's weight, 0 .. 255.
  static std::uint32_t weight(std::uint32_t in_cell) { return in_cell >> 23; }
};

}  // namespace zstrip::detail
