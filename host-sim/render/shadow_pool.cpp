// Checks that a shadow's map fits into its pool in all frames that boards show.
#include "render/shadow_pool.hpp"

#include <fmt/format.h>

#include "render/render_frame.hpp"

namespace zstrip::sim {
namespace {

/// The number of frames that BakedMotion of firmware/boards has.
constexpr std::uint32_t kFramesOfBoards = 64;

}  // namespace

Result<Done> check_shadow_pool(Stage& stage, const View& view) {
  const bool moves = !stage.animation().tracks.empty() || stage.turn().what != Turning::nothing;
  const std::uint32_t frames = moves ? kFramesOfBoards : 1;
  FrameRenderer renderer(view, Budget{});
  for (std::uint32_t frame = 0; frame < frames; ++frame) {
    const Result<Staging> staging = stage.place(frame, frames);
    if (!staging) return staging.failure();
    const Shadow* const shadow = staging->scene.shadow;
    if (shadow == nullptr || shadow->pool == 0) return Done{};
    const Result<FrameReport> drawn = renderer.render(*staging);
    if (drawn) continue;
    return Failure{drawn.failure().status, fmt::format("frame {} of {}: {}", frame, frames, drawn.failure().message)};
  }
  return Done{};
}

}  // namespace zstrip::sim
