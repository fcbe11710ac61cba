// Computes the mean of a pixel's samples.
#pragma once

#include <cstdint>

#include "zstrip/base/bayer.hpp"
#include "zstrip/pixels/colour.hpp"
#include "zstrip/view.hpp"

namespace zstrip::detail {

using SamplePair [[gnu::may_alias]] = std::uint32_t;

/// Returns the sums of the channels of two adjacent samples, spread as in kSpreadChannels. The sum of four samples and
/// the rounding needs 8 bits for green (4 * 63 + 3), 7 for red and blue.
constexpr std::uint32_t sum_of_pair(std::uint32_t pair) {
  return (pair & kSpreadChannels) + (((pair >> 16) | (pair << 16)) & kSpreadChannels);
}

/// Computes the pixels of `area`, a rectangle of the picture, from their samples: area.width() * sample_columns(view) a
/// row, sample_rows(view) rows a pixel, without gaps, aligned to 4. A channel is the mean of its samples, rounded to
/// nearest, halves up. `dithered`: rounded by the threshold of Bayer's matrix of order 2, because the samples were
/// dithered with the finer matrix. `pixels` may be the samples' own memory: each pixel is written after its samples
/// were read.
template <bool dithered>
void average_samples(const View& view, const Rect& area, const std::uint16_t* samples, std::uint16_t* pixels) {
  const auto* pairs = reinterpret_cast<const SamplePair*>(samples);
  const std::int32_t width = area.width();
  const bool square = sample_rows(view) == 2;
  const std::uint32_t shift = square ? 2 : 1;
  for (std::int32_t y = area.top; y < area.bottom; ++y) {
    for (std::int32_t x = 0; x < width; ++x, ++pairs) {
      std::uint32_t sum = sum_of_pair(pairs[0]);
      if (square) sum += sum_of_pair(pairs[width]);
      std::uint32_t added = shift;  // half of the number of samples
      if constexpr (dithered) added = std::uint32_t{kBayer[(y >> 1) & 1][((area.left + x) >> 1) & 1]} >> (6 - shift);
      sum = ((sum + added * kOneInEach) >> shift) & kSpreadChannels;
      *pixels++ = static_cast<std::uint16_t>(sum | (sum >> 16));
    }
    if (square) pairs += width;
  }
}

}  // namespace zstrip::detail
