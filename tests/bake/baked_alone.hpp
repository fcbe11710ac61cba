// A baked header's scene, and the firmware that draws it: what baked_header_alone.cpp makes of the header.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "zstrip/animation.hpp"
#include "zstrip/camera.hpp"
#include "zstrip/effects.hpp"
#include "zstrip/plan.hpp"
#include "zstrip/scene.hpp"
#include "zstrip/scene/turn.hpp"
#include "zstrip/status.hpp"
#include "zstrip/view.hpp"

namespace baked_alone {

/// What stands in the header, by the same names.
struct Header {
  const zstrip::Scene& scene;
  const zstrip::Animation& animation;
  const zstrip::Turn& turn;
  const zstrip::Camera& camera;
  const zstrip::View& view;
  zstrip::Effects effects;
  const zstrip::Budget& budget;
  const zstrip::Plan& plan;
  std::uint32_t moving_duration;  ///< of the animation of joints and weights; 0 without skins and morph targets
  zstrip::Status (*pose)(std::uint32_t milliseconds);  ///< moves skins and morph targets; does nothing without
};
extern const Header header;

using Send = void (*)(std::uint16_t strip, std::span<const std::byte> pixels);

/// Draws the header's picture; `send` gets each strip. `pixels`: Plan::strip_pixel_bytes, aligned to 4.
zstrip::Status draw(std::span<std::byte> pixels, Send send);
/// Draws one frame of the scene, moved, with the header's view and plan.
zstrip::Status draw_moved(const zstrip::Scene& scene, const zstrip::Camera& camera, std::span<std::byte> pixels,
                          Send send);

}  // namespace baked_alone
