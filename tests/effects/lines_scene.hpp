// The knot with the lines that join its first vertices, and with some of them as points.
#pragma once

#include <array>
#include <cstddef>

#include "zstrip_scenes/knot.hpp"

namespace zstrip::scenes {

inline constexpr auto kKnotSegments = [] {
  std::array<Segment, 300> segments{};
  for (std::uint16_t i = 0; i < segments.size(); ++i) {
    segments[i] = {i, static_cast<std::uint16_t>(i % 3 == 0 ? i : i + 7)};
  }
  return segments;
}();
inline constexpr LineSet kKnotLines[1] = {{.segments = kKnotSegments, .width = 2}};

inline constexpr BuiltIn lines = [] {
  BuiltIn scene = knot;
  scene.name = "lines";
  scene.scene.lines = kKnotLines;
  scene.counts.line_sets = 1;
  return scene;
}();

}  // namespace zstrip::scenes
