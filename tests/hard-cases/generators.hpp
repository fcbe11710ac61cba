// Random inputs of the hard cases; RapidCheck shrinks them towards small numbers.
#pragma once

#include <rapidcheck.h>

#include <algorithm>
#include <array>
#include <vector>

#include "lattice.hpp"
#include "raster_judge.hpp"

namespace hard_cases {

/// low..high, both included, all equally likely from the first sample on.
inline int between(int low, int high) { return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(low, high + 1)); }

/// Around the picture of kView, up to `beyond` sub-pixels outside.
inline oracle::Point any_point(int beyond = 0) {
  return {between(-beyond, kView.width * 16 + beyond), between(-beyond, kView.height * 16 + beyond)};
}

/// Within `extent` of a point.
inline oracle::Point point_near(const oracle::Point& p, int extent) {
  return {p.x + between(-extent, extent), p.y + between(-extent, extent)};
}

inline Corners2 any_triangle(int extent, int beyond = 0) {
  const oracle::Point centre = any_point(beyond);
  return {point_near(centre, extent), point_near(centre, extent), point_near(centre, extent)};
}

inline std::uint8_t any_byte() { return static_cast<std::uint8_t>(between(0, 255)); }

/// A depth as vertices have it: any code of the range, any of the four fractions.
inline std::uint32_t any_depth(int lowest = 1, int highest = 65534) {
  const auto code = static_cast<std::uint32_t>(between(lowest, highest));
  return snap_depth((code << 16) | static_cast<std::uint32_t>(between(0, 3)) << 14);
}

/// For the rasterisers: counter-clockwise, with depth and colour; the area may be zero.
inline raster_judge::Corners with_attributes(const Corners2& points, int lowest = 1, int highest = 65534) {
  raster_judge::Corners corners;
  for (std::size_t i = 0; i < 3; ++i) {
    corners[i] = {static_cast<std::int32_t>(points[i].x), static_cast<std::int32_t>(points[i].y),
                  any_depth(lowest, highest), Colour{any_byte(), any_byte(), any_byte(), 255}};
  }
  if (raster_judge::area_of(corners) < 0) std::swap(corners[1], corners[2]);
  return corners;
}

}  // namespace hard_cases
