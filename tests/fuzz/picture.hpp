// Draws whole pictures through the public interface, with every buffer as small as the plan allows and full of garbage.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "../oracle/draw.hpp"

namespace fuzz {

/// How one picture is drawn; none of it may change a pixel.
struct Request {
  zstrip::Effects effects;  ///< those of the pipeline, at least what the scene calls for
  zstrip::Budget budget;
  std::uint8_t garbage = 0;       ///< what arena and strips hold beforehand
  bool last_strip_first = false;  ///< the order of the strips
  /// Added, modulo 2^32, to the plan's bytes for instances, vertices, depth, colour and bins: a plan that nobody
  /// planned. If it is not refused, it must do no harm.
  std::array<std::uint32_t, 5> surplus{};
};

using picture::Picture;

/// The scene must have passed validate(). Aborts where the renderer breaks a promise about a single picture: that
/// strips are drawn after begin_frame succeeded and never after it failed; bounds inside the view, depth codes in
/// range, background where nothing was drawn.
Picture draw(const zstrip::Scene& scene, const zstrip::Camera& camera, const zstrip::View& view,
             const Request& request);

}  // namespace fuzz
