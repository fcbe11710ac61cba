// Counts of the work of a frame. Only renderers built with effect::statistics count.
#pragma once

#include <cstdint>

namespace zstrip {

struct Statistics {
  std::uint32_t triangles = 0;  ///< sum over all instances, before any culling
  std::uint32_t drawn = 0;      ///< front-facing triangles that reach into the picture; counted in the first strip that
                                ///< they touch
  std::uint32_t clipped = 0;    ///< triangles that took the clipping path; counted once for each strip
  std::uint32_t covering = 0;   ///< drawn triangles that cover a pixel centre; counted in each strip where they do
  std::uint32_t vertices = 0;   ///< transformed vertices; in Mode::streamed counted again for each strip
  std::uint32_t fragments = 0;  ///< pixels covered by triangles, before the depth test
  std::uint32_t depth_passes = 0;  ///< fragments that were written
};

namespace detail {

template <bool statistics>
inline void count_pass(Statistics* counters) {
  if constexpr (statistics) ++counters->depth_passes;
}

}  // namespace detail

}  // namespace zstrip
