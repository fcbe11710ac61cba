// Dithers a background of one colour. A separate file, because only pictures in RGB565 with fog link it.
#include "zstrip/base/bayer.hpp"
#include "zstrip/effects/dithering/dither.hpp"
#include "zstrip/pixels/colour.hpp"

namespace zstrip {

void detail::fill_dithered(const Rect& area, const Colour& colour, std::uint16_t* pixels) {
  for (std::int32_t y = area.top; y < area.bottom; ++y) {
    std::uint16_t repeated[8];
    for (std::uint32_t x = 0; x < 8; ++x) repeated[x] = dithered_rgb565(colour.r, colour.g, colour.b, kBayer[y & 7][x]);
    for (std::int32_t x = area.left; x < area.right; ++x) *pixels++ = repeated[x & 7];
  }
}

}  // namespace zstrip
