// Measures the memory of the scene's frames as static layers; see kept_frames.hpp.
#include "plan/kept_frames.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "render/frame_refused.hpp"
#include "zstrip/layer.hpp"
#include "zstrip/renderer.hpp"

namespace zstrip::sim {
namespace {

/// The memory of a layer that has room for every picture, and of a single strip.
class Keeper {
 public:
  Keeper(const View& view, DepthFormat format)
      : view_{view.width, view.height, PixelFormat::rgb565, dithers_colours(view)},
        format_(format),
        worst_(layer_bytes_worst(view_)),
        depth_(worst_.depth),
        colour_(worst_.colour),
        dirty_(worst_.dirty / sizeof(std::uint32_t)) {}

  const LayerBytes& worst() const { return worst_; }

  /// Extends the distances by those of this frame. Keeps nothing if the frame has no plain depth.
  Status keep(const Staging& staging, Fixed& nearest, Fixed& farthest) {
    const Effects effects = effects_of(staging.scene, staging.camera) | effects_of(view_) | depth_effect(format_);
    const PlanResult planned = zstrip::plan(count(staging.scene), view_, effects, {.strip_rows = view_.height});
    const Status& status = planned.status;
    const Plan& plan = planned.plan;
    if (!status) return status;
    arena_.resize((plan.bytes() + sizeof(std::uint64_t) - 1) / sizeof(std::uint64_t));
    pixels_.resize(plan.strip_pixel_bytes(view_) / sizeof(std::uint16_t));
    const auto pixels = std::as_writable_bytes(std::span(pixels_));
    renderer_ = AnyRenderer(effects);
    if (const Status reset = layer_.reset({depth_, colour_, dirty_}, view_); !reset) return reset;
    Camera fitted = staging.camera;
    fitted.fixed_depth_range = false;
    const auto begin = [&](const Camera& camera) {
      return renderer_.begin_frame(staging.scene, camera, view_, plan, std::as_writable_bytes(std::span(arena_)));
    };
    if (const Status begun = begin(fitted); !begun) return begun;
    if (const Frame frame = renderer_.frame(); frame.nearest() > 0 && frame.farthest() > frame.nearest()) {
      nearest = nearest == 0 ? frame.nearest() : std::min(nearest, frame.nearest());
      farthest = std::max(farthest, frame.farthest());
    }
    if (const Status begun = begin(staging.camera); !begun || !has_plain_depth()) return begun;
    if (const Status drawn = renderer_.draw_strip(0, pixels); !drawn) return drawn;
    return layer_.keep(renderer_.frame(), 0, pixels);
  }

  bool has_plain_depth() const { return renderer_.frame().has_plain_depth(); }
  const StaticLayer& layer() const { return layer_; }

 private:
  View view_;
  DepthFormat format_;
  LayerBytes worst_;
  std::vector<std::byte> depth_, colour_;
  std::vector<std::uint32_t> dirty_;
  std::vector<std::uint64_t> arena_;  // 8-byte words: kArenaAlignment
  std::vector<std::uint16_t> pixels_;
  AnyRenderer renderer_{Effects{}};
  StaticLayer layer_;
};

}  // namespace

Result<KeptFrames> keep_frames(Stage& stage, const View& view, DepthFormat format, std::uint32_t frames,
                               bool fixed_range) {
  Keeper keeper(view, format);
  KeptFrames kept{.frames = frames, .format = format, .depth = {}, .colour = {}, .dirty = keeper.worst().dirty};
  kept.depth.worst = keeper.worst().depth;
  kept.colour.worst = keeper.worst().colour;
  std::uint64_t depth_sum = 0, colour_sum = 0;
  for (std::uint32_t frame = 0; frame < frames; ++frame) {
    Result<Staging> staging = stage.place(frame, frames);
    if (!staging) return staging.failure();
    staging->camera.fixed_depth_range = fixed_range;
    if (const Status status = keeper.keep(*staging, kept.nearest, kept.farthest); !status)
      return frame_refused("a frame cannot be kept", status);
    if (!keeper.has_plain_depth()) kept.possible = false;
    const std::uint32_t depth = keeper.layer().depth_store().bytes_used();
    const std::uint32_t colour = keeper.layer().colour_store().bytes_used();
    depth_sum += depth;
    colour_sum += colour;
    kept.depth.largest = std::max(kept.depth.largest, depth);
    kept.colour.largest = std::max(kept.colour.largest, colour);
    kept.codes = {staging->camera.near_plane, staging->camera.far_plane, staging->camera.projection};
  }
  if (!fixed_range) kept.codes = {kept.nearest, kept.farthest, kept.codes.projection};
  kept.depth.average = static_cast<std::uint32_t>(depth_sum / frames);
  kept.colour.average = static_cast<std::uint32_t>(colour_sum / frames);
  return kept;
}

}  // namespace zstrip::sim
