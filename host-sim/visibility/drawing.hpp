// A frame drawn with any visibility method, with all data for inspection: pixels, depth, overdraw, bounds of tiles,
// counts.
#pragma once

#include <chrono>
#include <cstdint>
#include <vector>

#include "render/stage.hpp"
#include "result.hpp"
#include "visibility/prepared_scene.hpp"
#include "zstrip/base/statistics.hpp"
#include "zstrip/effects.hpp"
#include "zstrip/plan.hpp"
#include "zstrip/visibility.hpp"

namespace zstrip::sim {

/// One value for each pixel of the view, row by row. Depth codes, also of tiles, are 0 where nothing was drawn or if
/// the method does not keep them.
struct LookedAtFrame {
  View view;
  Plan plan;
  Mode mode = Mode::streamed;
  std::vector<std::uint16_t> pixels;   ///< RGB565
  std::vector<std::uint32_t> depth;    ///< codes
  std::vector<std::uint8_t> overdraw;  ///< number of writes, up to 255
  std::vector<std::uint16_t> tiles;    ///< the farthest code that is known for the pixel's tile
  Statistics statistics{};
  VisibilityStatistics visibility{};
  std::size_t pieces_split = 0;     ///< triangles that the host split for the method
  Fixed nearest = 0, farthest = 0;  ///< as in Frame
  std::int64_t nanoseconds = 0;     ///< begin_frame and all strips
};

/// Selects the picture and the method. `effects`: in addition to the scene's own: method, depth format.
struct MethodRequest {
  View view;  ///< RGB565
  Budget budget;
  Effects effects;
  VisibilityOptions options;
};

/// Draws once, with counts. Failures: ExitStatus::budget and usage, with the messages of `zstrip render`.
Result<LookedAtFrame> draw_looked_at(const Staging& staging, const MethodRequest& request);

/// Draws repeatedly without counts, as a device would; for measurements of streamed plans.
class TimedDrawing {
 public:
  static Result<TimedDrawing> prepare(const Staging& staging, const MethodRequest& request);
  Status draw();
  const Plan& plan() const { return plan_; }

 private:
  TimedDrawing(PreparedScene scene, const MethodRequest& request, Effects effects, const Plan& plan);

  PreparedScene scene_;
  MethodRequest request_;
  Effects effects_;
  Plan plan_;
  std::vector<std::uint64_t> arena_, strip_;
};

}  // namespace zstrip::sim
