// Shows frames of a moving scene on a display: memory for strips, and one call a frame.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "portable/failure.hpp"
#include "zstrip/fingerprints.hpp"
#include "zstrip/plan.hpp"
#include "zstrip/status.hpp"
#include "zstrip_hal/present.hpp"

namespace zstrip::board {

/// `Motion` is a scene with the renderer that draws it: see turntable_motion.hpp or baked_motion.hpp. With two strip
/// buffers drawing overlaps a transfer, which is useful only with DMA.
template <class Motion, unsigned strip_buffers = 1>
class ScenePlayer {
  static_assert(strip_buffers == 1 || strip_buffers == 2);

 public:
  static constexpr View kView = Motion::kView;
  static constexpr Plan kPlan = Motion::kPlan;
  static constexpr std::uint32_t kFrames = Motion::kFrames;
  static constexpr std::uint32_t kStripBytes = kPlan.strip_pixel_bytes(kView);

  /// Draws and sends frame `frame` of the motion.
  template <hal::Display Panel>
  static Failure show(Panel& panel, std::uint32_t frame) {
    if (static_cast<int>(panel.format()) != static_cast<int>(kView.format) || panel.width() != kView.width ||
        panel.height() != kView.height) {
      return {"display", "its size or format is not that of the plan"};
    }
    if (const Status moved = Motion::move_to(frame); !moved) return {"moving the scene", message(moved.error)};
    if (const Status begun = Motion::begin_frame(); !begun) return {"begin of the frame", message(begun.error)};
    Motion motion;
    if constexpr (hal::RemembersStrips<Panel> && requires { Motion::camera_of_frame(); }) {
      FingerprintedFrame<Motion, kPlan.strips> known(motion, Motion::camera_of_frame());
      return present(known, panel);
    } else {
      return present(motion, panel);
    }
  }

 private:
  template <class Frame, hal::Display Panel>
  static Failure present(Frame& frame, Panel& panel) {
    const auto shown = hal::present(frame, panel, {kPlan.strips, kPlan.strip_rows, kPlan.strip_columns}, buffers());
    if (!shown.draw) return {"drawing", message(shown.draw.error)};
    if (shown.display != hal::Error::none) return {"display", hal::message(shown.display)};
    return {};
  }
  static hal::StripBuffers buffers() {
    const std::span<std::byte> all = pixels;
    if constexpr (strip_buffers == 1) return {all, {}};
    return {all.first(kBufferBytes), all.subspan(kBufferBytes * (strip_buffers - 1))};
  }

  static constexpr std::uint32_t kBufferBytes = (kStripBytes + 3) & ~3U;
  alignas(
      4) static inline constinit std::array<std::byte, strip_buffers == 1 ? kStripBytes : 2 * kBufferBytes> pixels{};
};

}  // namespace zstrip::board
