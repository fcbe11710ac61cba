// Draws eight fragments at once: depth test of z16, write of depth and colour.
#pragma once

#include "zstrip/kernels/vector/vector.hpp"

#if ZSTRIP_HAS_VECTORS

#include <cstdint>

namespace zstrip::detail::vectors {

/// Loads and stores eight cells or pixels in a row.
struct InOneRow {
  static Halves load(const std::uint16_t* at) { return load_8(at); }
  static void store(std::uint16_t* at, Halves values) { store_8(at, values); }
};
/// Loads and stores four cells or pixels in the lower lanes; the upper lanes have none.
struct HalfRow {
  static Halves load(const std::uint16_t* at) { return load_4(at); }
  static void store(std::uint16_t* at, Halves values) { store_4(at, values); }
};

/// Draws the fragments whose code is greater than their cell. `cells` and `pixels` load and store eight or four values
/// at an address; colour_of() returns the fragments' colours.
template <class Cells, class Pixels, class ColourOf>
[[gnu::always_inline]] inline void draw_fragments(const Cells& cells, const Pixels& pixels, std::uint16_t* depth,
                                                  std::uint16_t* pixel, Halves codes, const ColourOf& colour_of) {
  const Halves old = cells.load(depth);
  const Halves nearest = unsigned_max(codes, old);
  cells.store(depth, nearest);
  const Halves hidden = as_halves(nearest == old);
  const Halves old_colours = pixels.load(pixel);
  pixels.store(pixel, chosen(hidden, old_colours, colour_of()));
}
template <class Place, class ColourOf>
[[gnu::always_inline]] inline void draw_fragments(const Place& place, std::uint16_t* depth, std::uint16_t* pixel,
                                                  Halves codes, const ColourOf& colour_of) {
  draw_fragments(place, place, depth, pixel, codes, colour_of);
}

}  // namespace zstrip::detail::vectors

#endif
