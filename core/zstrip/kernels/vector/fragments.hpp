// Eight fragments at once: depth test of z16, write of depth and colour.
#pragma once

#include "zstrip/kernels/vector/vector.hpp"

#if ZSTRIP_HAS_VECTORS

#include <cstdint>

namespace zstrip::detail::vectors {

/// Eight cells or pixels in a row.
struct InOneRow {
  static Halves load(const std::uint16_t* at) { return load_8(at); }
  static void store(std::uint16_t* at, Halves values) { store_8(at, values); }
};
/// Four, and none in the upper lanes.
struct HalfRow {
  static Halves load(const std::uint16_t* at) { return load_4(at); }
  static void store(std::uint16_t* at, Halves values) { store_4(at, values); }
};

/// RGB565 of channels in 8.8.
inline Halves rgb565_of_halves(Halves r, Halves g, Halves b) {
  return ((r & in_all_halves(0xF800)) | ((g >> 5) & in_all_halves(0x07E0))) | (b >> 11);
}

/// Draws the fragments whose code is greater than their cell. `cells` and `pixels` load and store eight, or four, from
/// an address on; colour_of() gives the fragments' colours.
template <class Cells, class Pixels, class ColourOf>
[[gnu::always_inline]] inline void draw_fragments(const Cells& cells, const Pixels& pixels, std::uint16_t* depth,
                                                  std::uint16_t* pixel, Halves codes, const ColourOf& colour_of) {
  const Halves old = cells.load(depth);
  const Halves nearer = saturated_difference(codes, old);  // by how much; 0 where it is not
  cells.store(depth, old + nearer);
  const Halves hidden = as_halves(nearer == Halves{});
  const Halves drawn_over = pixels.load(pixel);
  pixels.store(pixel, chosen(hidden, drawn_over, colour_of()));
}
template <class Place, class ColourOf>
[[gnu::always_inline]] inline void draw_fragments(const Place& place, std::uint16_t* depth, std::uint16_t* pixel,
                                                  Halves codes, const ColourOf& colour_of) {
  draw_fragments(place, place, depth, pixel, codes, colour_of);
}

}  // namespace zstrip::detail::vectors

#endif
