// What a frame did. Counted only by renderers built with effect::statistics.
#pragma once

#include <cstdint>

namespace zstrip {

struct Statistics {
  std::uint32_t triangles = 0;  ///< of all instances, before any culling
  std::uint32_t drawn = 0;      ///< front-facing and reaching into the picture; counted in the first strip they touch
  std::uint32_t clipped = 0;    ///< that took the clipping path; counted once for each strip
  std::uint32_t covering = 0;   ///< of these, the ones that cover a pixel centre; counted in each strip where they do
  std::uint32_t vertices = 0;   ///< transformed, again for each strip when streamed
  std::uint32_t fragments = 0;  ///< pixels covered by triangles, before the depth test
  std::uint32_t depth_passes = 0;  ///< of these, the ones that were written
};

namespace detail {

template <bool statistics>
inline void count_pass(Statistics* counters) {
  if constexpr (statistics) ++counters->depth_passes;
}

}  // namespace detail

}  // namespace zstrip
