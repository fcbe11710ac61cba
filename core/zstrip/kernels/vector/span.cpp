// Draws flat and Gouraud spans, eight pixels at a time.
#include "zstrip/kernels/vector/span.hpp"

#include "zstrip/kernels/vector/interpolated.hpp"
#include "zstrip/pixels/colour.hpp"

#if ZSTRIP_HAS_VECTORS

namespace zstrip::detail {

using namespace vectors;

void fill_flat_vector(std::uint16_t* depth, std::uint16_t* pixel, std::int32_t length, std::uint32_t z,
                      std::uint32_t step_z, std::uint16_t colour) {
  const Halves colours = in_all_halves(colour);
  const auto one_colour = [&] { return colours; };
  if (length >= 8) {
    Interpolated depths(z, step_z);
    for_each_eight(
        length,
        [&](std::int32_t at) { draw_fragments(InOneRow{}, depth + at, pixel + at, depths.upper(), one_colour); },
        [&] { depths.next(); }, [&](std::int32_t pixels) { depths.move(pixels); });
    return;
  }
  if (length >= 4) {
    const Words first = stepped_words(z, step_z);
    draw_fragments(HalfRow{}, depth, pixel, upper_halves(first, first), one_colour);
    const std::int32_t rest = length - 4;
    if (rest == 0) return;
    const Words last = first + in_all_words(step_z * static_cast<std::uint32_t>(rest));
    draw_fragments(HalfRow{}, depth + rest, pixel + rest, upper_halves(last, last), one_colour);
    return;
  }
  do {
    const auto code = static_cast<std::uint16_t>(z >> 16);
    if (code > *depth) {
      *depth = code;
      *pixel = colour;
    }
    z += step_z;
    ++depth;
    ++pixel;
  } while (--length != 0);
}

void fill_gouraud_vector(std::uint16_t* depth, std::uint16_t* pixel, std::int32_t length, const GouraudSpan& span) {
  if (length >= 8) {
    Interpolated z(span.z, span.step_z);
    // Converted to 16.16, so that the upper half has all bits of a channel that are used.
    Interpolated r(span.r << 8, span.step_r << 8);
    Interpolated g(span.g << 8, span.step_g << 8);
    Interpolated b(span.b << 8, span.step_b << 8);
    const auto colours = [&] { return rgb565_of_halves(r.upper(), g.upper(), b.upper()); };
    for_each_eight(
        length, [&](std::int32_t at) { draw_fragments(InOneRow{}, depth + at, pixel + at, z.upper(), colours); },
        [&] { z.next(), r.next(), g.next(), b.next(); },
        [&](std::int32_t pixels) { z.move(pixels), r.move(pixels), g.move(pixels), b.move(pixels); });
    return;
  }
  GouraudSpan at = span;
  do {
    const auto code = static_cast<std::uint16_t>(at.z >> 16);
    if (code > *depth) {
      *depth = code;
      *pixel = rgb565(at.r, at.g, at.b);
    }
    at.z += at.step_z;
    at.r += at.step_r;
    at.g += at.step_g;
    at.b += at.step_b;
    ++depth;
    ++pixel;
  } while (--length != 0);
}

}  // namespace zstrip::detail

#endif
