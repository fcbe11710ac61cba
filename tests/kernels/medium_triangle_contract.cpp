// Medium triangles against the span rasteriser: their planes, then whole ones in strips that cut them on all sides.
// Anywhere in the narrow range, boxes of all sizes, slivers among them, depths and colours that change by little and by
// all. Textured ones with texture coordinates and distances of all sizes, in each light.
#include <algorithm>
#include <cstdint>
#include <utility>

#include "contracts.hpp"
#include "pictures.hpp"
#include "random.hpp"
#include "raster_vertex.hpp"
#include "textures.hpp"
#include "zstrip/kernels/medium_textured.hpp"
#include "zstrip/kernels/medium_triangle.hpp"
#include "zstrip/kernels/thumb/medium_textured.hpp"
#include "zstrip/raster/clip_triangle.hpp"
#include "zstrip/raster/span_triangle.hpp"

namespace zstrip::kernels_test {
namespace {

using namespace detail;

struct Medium {
  SnappedVertex v[3];
  Colour colours[3];
  RasterVertex raster[3];  ///< the same for spans
  std::int32_t area;
  std::int32_t width, height;  ///< of its box, in 1/16 pixels
  Rect box;
};

/// False if nothing is to be drawn. No side of the box is longer than `extent`, in 1/16 pixels.
bool make(Random& random, std::int32_t extent, Medium& medium) {
  auto& v = medium.v;
  const std::int32_t width = random.between(1, extent), height = random.between(1, extent);
  const std::int32_t left = random.within(16'000 - extent), top = random.within(16'000 - extent);
  const std::uint32_t depth = random.word(), range = std::uint32_t{1} << random.between(8, 31);
  const std::int32_t kind = random.below(6);
  for (int i = 0; i < 3; ++i) {
    v[i].x = static_cast<std::int16_t>(left + random.between(0, width));
    v[i].y = static_cast<std::int16_t>(top + random.between(0, height));
    v[i].depth = depth + random.word() % range;
    Colour& colour = medium.colours[i];
    colour = random.colour();
    if (kind < 2) colour = {static_cast<std::uint8_t>(128 + i), 128, 127, 255};
    if (kind > 3) colour.g = colour.b = colour.r;
  }
  // Grey, but for one channel of one vertex.
  if (kind == 5) (random.below(2) == 0 ? medium.colours[random.below(3)].g : medium.colours[random.below(3)].b) ^= 1;
  medium.area = (v[2].x - v[0].x) * (v[1].y - v[0].y) - (v[1].x - v[0].x) * (v[2].y - v[0].y);
  if (medium.area < 0) {
    std::swap(v[1], v[2]);
    medium.area = -medium.area;
  }
  const SnappedVertex *a = &v[0], *b = &v[1], *c = &v[2];
  rotate_to_first([](const SnappedVertex* vertex) { return vertex->y * 65536 + vertex->x; }, a, b, c);
  const SnappedVertex rotated[3] = {*a, *b, *c};
  std::copy_n(rotated, 3, v);
  for (int i = 0; i < 3; ++i) medium.raster[i] = raster_vertex(v[i], medium.colours[i]);
  const auto [min_x, max_x] = std::minmax<std::int32_t>({v[0].x, v[1].x, v[2].x});
  const auto [min_y, max_y] = std::minmax<std::int32_t>({v[0].y, v[1].y, v[2].y});
  medium.width = max_x - min_x, medium.height = max_y - min_y;
  medium.box = {min_x >> 4, min_y >> 4, max_x >> 4, max_y >> 4};
  return medium.area != 0 && !medium.box.empty();
}

bool equal(const Plane& plane, const MediumScan& scan, MediumScan::Value value) {
  return plane.start == scan.start[value] && plane.step_x == scan.step_x[value] && plane.step_y == scan.step_y[value];
}

bool planes_differ(Random& random, std::uint32_t number, Outcome& outcome) {
  Medium m;
  const Picture nowhere({portable_depth, portable_colour}, 1, 1, false);
  if (!make(random, 1 << random.between(4, 13), m)) return false;
  if (!fits_words({nowhere.target(0, 0, nullptr), m.v[0], m.v[1], m.v[2], m.area}, m.width, m.height)) return false;
  MediumScan scan{};
  scan.area = m.area, scan.anchor_x = m.box.left + random.below(m.box.width());
  scan.anchor_y = m.box.top - random.below(2) * random.within(100);
  scan.has_channels = true;
  std::copy_n(m.colours, 3, scan.colours);
  if (!set_up_medium(scan, m.v[0], m.v[1], m.v[2])) return false;
  const RasterVertex(&v)[3] = m.raster;
  const PlaneSetup setup(v[0], v[1], v[2], m.area, scan.anchor_x, scan.anchor_y);
  const auto plane = [&](auto member) {
    const auto value = [&](int i) { return std::int64_t{v[i].*member}; };
    return setup.plane(value(0), value(1) - value(0), value(2) - value(0));
  };
  ++outcome.compared;
  const bool same = equal(plane(&RasterVertex::depth), scan, MediumScan::depth) &&
                    equal(plane(&RasterVertex::r), scan, MediumScan::red) &&
                    equal(plane(&RasterVertex::g), scan, MediumScan::green) &&
                    equal(plane(&RasterVertex::b), scan, MediumScan::blue);
  return !same && outcome.differs("the planes of a medium triangle", number);
}

/// A strip that cuts a triangle above and below, or with `sides` often at the left and at the right, too.
struct Cut {
  std::int32_t left, top, width, height;

  Cut(Random& random, const Rect& box, bool sides)
      : left(box.left - random.below(3)),
        top(box.top + random.between(-8, 8)),
        width(box.right - left + random.below(3)) {
    if (sides && random.below(2) == 0) {
      const std::int32_t more = random.below(width);
      left += more, width = random.between(1, width - more);
    }
    height = random.between(1, std::min<std::int32_t>(70, static_cast<std::int32_t>(kMaxCells) / width));
  }
};

template <Shade shade>
bool differ(Random& random, std::uint32_t number, Outcome& outcome) {
  Medium m;
  if (!make(random, random.between(2, 900), m)) return false;
  const Cut strip(random, m.box, true);
  const Pictures pictures(random, strip.width, strip.height, m.v[0].depth >> 16);
  constexpr std::uint16_t kFlat = 0x1234;
  const Colour* const colours[3] = {&m.colours[0], &m.colours[1], &m.colours[2]};
  const StripTarget own = pictures.own.target(strip.left, strip.top, nullptr);
  const MediumTriangle triangle{own, m.v[0], m.v[1], m.v[2], m.area};
  // Where vectors draw, the C++ for words of 32 bits in every second case.
  const auto drawn = [&](bool by_words) {
    constexpr bool kGouraud = shade == Shade::gouraud;
    if (!by_words && draw_medium<kGouraud>(triangle, colours, kFlat)) return true;
    if constexpr (kGouraud) {
      if (by_words && draw_medium_gouraud_by_rows(triangle, colours)) return true;
      return draw_cut_gouraud_by_rows(triangle, colours);
    } else {
      if (by_words && draw_medium_flat_by_rows(triangle, kFlat)) return true;
      return draw_cut_flat_by_rows(triangle, kFlat);
    }
  };
  if (!drawn(number % 8 < 4)) return false;
  Statistics statistics{};
  draw_span_triangle<shade, false, true>(pictures.portable.target(strip.left, strip.top, &statistics), m.raster[0],
                                         m.raster[1], m.raster[2],
                                         {.flat_colour = kFlat, .texture = {}, .depth_offset = 0}, true);
  outcome.compared += statistics.depth_passes != 0 ? 1U : 0U;
  return !pictures.equal() && outcome.differs("a medium triangle", number);
}

template <TexelLight lit, std::int32_t perspective = kPerspectiveRun>
bool textured_differ(Random& random, std::uint32_t number, Outcome& outcome) {
  Medium m;
  if (!make(random, random.between(2, 260), m)) return false;
  const int less = random.below(32);
  TexturedVertex corners[3];
  for (int i = 0; i < 3; ++i) {
    corners[i] = {m.v[i].depth, static_cast<std::int32_t>(random.word()) >> less,
                  static_cast<std::int32_t>(random.word()) >> less};
    m.raster[i].u = corners[i].u, m.raster[i].v = corners[i].v;
  }
  // Up to 2^17 texels: more than vectors know.
  const auto side = [&random](std::int32_t most) { return static_cast<std::uint8_t>(random.below(most + 1)); };
  const TextureView texture{texels.data(), side(kMaxLog2Width), side(kMaxLog2Height)};
  const std::int64_t depth_offset = static_cast<std::int64_t>(random.word()) << random.below(8);
  const Cut strip(random, m.box, false);
  const Pictures pictures(random, strip.width, strip.height, m.v[0].depth >> 16);

  const StripTarget own = pictures.own.target(strip.left, strip.top, nullptr);
  const TexturedVertex* const vertices[3] = {&corners[0], &corners[1], &corners[2]};
  const Colour* const colours[3] = {&m.colours[0], &m.colours[1], &m.colours[2]};
  const Surface surface{0, texture, depth_offset, less < 2};
  if (!draw_medium_textured<lit, perspective == 0>({own, m.v[0], m.v[1], m.v[2], m.area},
                                                   {vertices, colours, surface})) {
    return false;
  }
  constexpr Shade kShade = lit == TexelLight::none   ? Shade::textured
                           : lit == TexelLight::flat ? Shade::textured_flat
                                                     : Shade::textured_gouraud;
  Statistics statistics{};
  draw_span_triangle<kShade, false, true, DepthMode{}, perspective>(
      pictures.portable.target(strip.left, strip.top, &statistics), m.raster[0], m.raster[1], m.raster[2], surface,
      true);
  outcome.compared += statistics.depth_passes != 0 ? 1U : 0U;
  return !pictures.equal() && outcome.differs("a medium textured triangle", number);
}

/// The planes of texture coordinates in assembly against those of 64 bits: what is rounded away shows in few pixels.
[[maybe_unused]] bool texture_planes_differ(Random& random, std::uint32_t number, Outcome& outcome) {
  Medium m;
  if (!make(random, random.between(2, 260), m)) return false;
  const int less = random.below(32);
  TexturedVertex corners[3];
  for (int i = 0; i < 3; ++i) {
    corners[i] = {m.v[i].depth, static_cast<std::int32_t>(random.word()) >> less,
                  static_cast<std::int32_t>(random.word()) >> less};
  }
  const TexturedVertex* const vertices[3] = {&corners[0], &corners[1], &corners[2]};
  const bool near = random.below(4) == 0;  // no offset: 1/w is what the depth is, and may be small
  if (near) {
    for (TexturedVertex& corner : corners) corner.depth >>= less;
  }
  const std::int64_t depth_offset = near ? 0 : static_cast<std::int64_t>(random.word()) << random.below(27);
  const Picture nowhere({portable_depth, portable_colour}, 1, 1, false);
  if (!fits_words({nowhere.target(0, 0, nullptr), m.v[0], m.v[1], m.v[2], m.area}, m.width, m.height) ||
      !TextureCoordinates<false>::fits_words(vertices, depth_offset, true)) {
    return false;
  }
  TexturedScan own{}, expected{};
  if constexpr (kHasThumb2) {
    own.scan.area = m.area, own.scan.anchor_x = m.box.left, own.scan.anchor_y = m.box.top;
    set_up_medium_thumb(own.scan, m.v[0], m.v[1], m.v[2]);
    set_up_texture_thumb(own, vertices, depth_offset);
  } else {
    ThumbPlanes(m.v[0], m.v[1], m.v[2], m.area, m.box.left, m.box.top).set_texture(own, vertices, depth_offset);
  }
  const PlaneSetup setup(m.raster[0], m.raster[1], m.raster[2], m.area, m.box.left, m.box.top);
  TextureCoordinates<false>(setup, vertices, depth_offset).start_rows(expected);
  bool same = own.base_u == expected.base_u && own.base_v == expected.base_v && own.right_shift == expected.right_shift;
  for (int i = 0; i < 3; ++i) {
    same = same && own.start[i] == expected.start[i] && own.step_x[i] == expected.step_x[i] &&
           own.step_y[i] == expected.step_y[i];
  }
  ++outcome.compared;
  return !same && outcome.differs("the planes of texture coordinates", number);
}

bool any_textured_differ(Random& random, std::uint32_t number, Outcome& outcome) {
  switch (number % 6) {
    case 0: return textured_differ<TexelLight::none>(random, number, outcome);
    case 1: return textured_differ<TexelLight::flat>(random, number, outcome);
    case 2: return textured_differ<TexelLight::none, 0>(random, number, outcome);
    case 3: return textured_differ<TexelLight::flat, 0>(random, number, outcome);
    case 4: return textured_differ<TexelLight::smooth, 0>(random, number, outcome);
    default: return textured_differ<TexelLight::smooth>(random, number, outcome);
  }
}

}  // namespace

Outcome compare_medium_triangles(std::uint32_t cases) {
  Random random(8);
  Outcome outcome;
  for (std::uint32_t number = 0; number < cases; ++number) {
    switch (number % 4) {
      case 0:
      case 1:
        if (planes_differ(random, number, outcome)) return outcome;
        break;
      case 2:
        if (differ<Shade::gouraud>(random, number, outcome)) return outcome;
        break;
      default:
        if (differ<Shade::flat>(random, number, outcome)) return outcome;
    }
  }
  return outcome;
}

Outcome compare_medium_textured(std::uint32_t cases) {
  Random random(9);
  fill_texels(random);
  Outcome outcome;
  for (std::uint32_t number = 0; number < cases; ++number) {
    if (any_textured_differ(random, number, outcome)) break;
    if constexpr (kHasThumb) {
      if (texture_planes_differ(random, number, outcome)) break;
    }
  }
  return outcome;
}

}  // namespace zstrip::kernels_test
