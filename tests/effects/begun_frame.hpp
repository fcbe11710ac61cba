// A frame in which tests pick pixels, and the divisions into strips that they try.
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "drawn.hpp"
#include "zstrip/pick.hpp"

namespace effects_test {

inline constexpr Budget kStreamed{.strip_rows = 7, .modes = Modes::streamed};
inline constexpr Budget kTiles{.strip_rows = 5, .strip_columns = 16, .modes = Modes::streamed};
inline constexpr Budget kBinned{.strip_rows = 9, .strip_columns = 24, .modes = Modes::binned};
inline constexpr Budget kWhole{.modes = Modes::streamed};

/// A frame that has begun, and its memory.
class BegunFrame {
 public:
  BegunFrame(const Scene& scene, const Camera& camera, const View& view, Effects effects, const Budget& budget)
      : effects_(budget.modes == Modes::binned ? effects | effect::bins : effects), renderer_(effects_) {
    const PlanResult planned = plan(count(scene), view, effects_, budget);
    EXPECT_TRUE(planned.status);
    arena_ = lent(planned.plan.bytes());
    const Status status = renderer_.begin_frame(scene, camera, view, planned.plan, arena_);
    EXPECT_TRUE(status) << message(status.error);
  }
  AnyRenderer& renderer() { return renderer_; }
  Frame frame() const { return renderer_.frame(); }
  Status pick(int x, int y, Picked& picked) const {
    return picker_for(effects_)(renderer_.frame(), static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y),
                                picked);
  }
  Picked picked(int x, int y) const {
    Picked picked{.index = 0xFFFF};
    const Status status = pick(x, y, picked);
    EXPECT_TRUE(status) << message(status.error);
    return picked;
  }

 private:
  Effects effects_;
  AnyRenderer renderer_;
  std::vector<std::byte> arena_;
};

}  // namespace effects_test
