// Draws spans with one colour and with interpolated colours in vectors, with the depth test of z16.
#pragma once

#include <cstdint>

#include "zstrip/base/processor.hpp"

namespace zstrip::detail {

/// The begin of a span with interpolated colours: values in 16.16 and 8.16, and their steps a pixel.
struct GouraudSpan {
  std::uint32_t z, r, g, b;
  std::uint32_t step_z, step_r, step_g, step_b;
};

void fill_flat_vector(std::uint16_t* depth, std::uint16_t* pixel, std::int32_t length, std::uint32_t z,
                      std::uint32_t step_z, std::uint16_t colour);

/// Draws a span with a colour that varies. In both functions `length` > 0.
void fill_gouraud_vector(std::uint16_t* depth, std::uint16_t* pixel, std::int32_t length, const GouraudSpan& span);

}  // namespace zstrip::detail
