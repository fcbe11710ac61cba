// The entry points of a renderer whose scene, view and plan the compiler has checked.
#pragma once

#include <cstddef>
#include <span>

#include "zstrip/frame/frame_order.hpp"
#include "zstrip/resolve/resolve.hpp"

namespace zstrip::detail {

/// Checks only the camera of the request.
template <Effects effects>
Status begin_fixed_frame(FrameState& frame, const FrameRequest& request, std::span<std::byte> arena) {
  abandon(frame);
  constexpr auto kProjection = effects.has(effect::orthographic) ? Projection::orthographic : Projection::perspective;
  if (!usable(request.camera) || request.camera.projection != kProjection) return {.error = Error::camera};
  if (const Status status =
          Stages::until_error<effects>([&](const auto& stage) { return stage.template check<effects>(request); });
      !status) {
    return status;
  }
  return begin_checked_frame<effects>(frame, request, request.camera, arena);
}

/// `pixels` has room for a strip of the plan, which has `strips` strips.
template <Effects effects, PixelFormat format>
Status draw_fixed_strip(FrameState& frame, std::uint16_t strip, std::uint16_t strips, std::byte* pixels) {
  if (frame.scene == nullptr) return {.error = Error::not_begun};
  if (strip >= strips) return {.error = Error::strip_rows, .needed = strip, .available = strips};
  if (drawn_in_place(format) && reinterpret_cast<std::uintptr_t>(pixels) % 2 != 0) {
    return {.error = Error::pixels_misaligned};
  }
  return draw_checked_strip<effects>(frame, strip, pixels,
                                     [](PixelFormat, std::uint16_t width, std::uint16_t rows, std::uint16_t* drawn,
                                        std::byte* out) { convert_rows(format, width, rows, drawn, out); });
}

}  // namespace zstrip::detail
