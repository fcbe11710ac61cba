// How many bytes a picture needs, for what, before anything is drawn. constexpr for baked scenes, so that
// firmware can size a static array with it.
#pragma once

#include <cstdint>

#include "zstrip/base/status.hpp"
#include "zstrip/scene/effects.hpp"
#include "zstrip/scene/scene.hpp"
#include "zstrip/scene/view.hpp"

namespace zstrip {

/// What a plan needs to know of a scene.
struct SceneCounts {
  std::uint32_t instances = 0;
  std::uint32_t triangles = 0;        ///< of all instances
  std::uint32_t vertices = 0;         ///< of all instances
  std::uint32_t largest_meshlet = 0;  ///< most vertices that one meshlet uses
};
constexpr SceneCounts count(const Scene& scene);

/// What the caller allows. Zero means: the planner decides.
struct Budget {
  std::uint32_t bytes = 0;       ///< arena size at most; 0 is kLargestArena
  std::uint16_t strip_rows = 0;  ///< rows of a strip; 0 is as many as fit
};

enum class Mode : std::uint8_t {
  streamed,  ///< geometry is transformed again for each strip, meshlet by meshlet: least memory
  binned,    ///< geometry is transformed once, triangles wait in a list for each strip: least time
};

inline constexpr std::uint32_t kArenaAlignment = 8;
inline constexpr std::uint32_t kLargestArena = 0xFFFFFFF0;  ///< bytes; needs beyond it are refused

struct Plan {
  Mode mode = Mode::streamed;
  std::uint16_t strip_rows = 0;
  std::uint16_t strips = 0;
  std::uint32_t instance_bytes = 0;
  std::uint32_t vertex_bytes = 0;
  std::uint32_t depth_bytes = 0;
  std::uint32_t colour_bytes = 0;  ///< RGB565 working strip; only for formats that are not drawn in place
  std::uint32_t bin_bytes = 0;
  /// The arena. It must be aligned to kArenaAlignment. Of a plan that `plan` returned never more than kLargestArena.
  constexpr std::uint32_t bytes() const {
    const std::uint64_t sum = wide_bytes();
    return sum > kLargestArena ? kLargestArena : static_cast<std::uint32_t>(sum);
  }
  /// The same without a limit, for plans from elsewhere.
  constexpr std::uint64_t wide_bytes() const {
    return std::uint64_t{instance_bytes} + vertex_bytes + depth_bytes + colour_bytes + bin_bytes;
  }
  /// The caller's pixel buffer for one strip.
  constexpr std::uint32_t strip_pixel_bytes(const View& view) const {
    return strip_rows * bytes_per_row(view.width, view.format);
  }
};

/// `status` says whether `plan` is valid; if not, what is missing (Error::arena_too_small with the bytes that the
/// smallest possible plan needs, the limit, and the purpose that takes the most of them).
struct PlanResult {
  Status status;
  Plan plan;
};
constexpr PlanResult plan(const SceneCounts& counts, const View& view, Effects effects, const Budget& budget = {});

}  // namespace zstrip

#include "zstrip/plan/plan_inline.hpp"
