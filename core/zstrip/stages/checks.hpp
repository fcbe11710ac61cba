// Everything about the caller's requests that could harm, before any stage runs: what no effect changes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "zstrip/effects/stage.hpp"
#include "zstrip/stages/depth_stage.hpp"

namespace zstrip::detail {

/// Of begin_frame, for a renderer with `effects`; not the index arrays, which validate() has seen.
Status check_request(const Scene& scene, const Camera& camera, const View& view, const Plan& plan, Effects called_for,
                     Effects effects, std::span<std::byte> arena);
/// What only some renderers need of a request.
template <Effects effects>
Status check_own_request(const FrameRequest& request) {
  [[maybe_unused]] const Plan& plan = request.plan;
  if constexpr (effects.has(effect::orthographic)) {
    // A pipeline has one projection: this is the effect that must not be there without being called for.
    if (request.camera.projection != Projection::orthographic) return {.error = Error::effect_missing};
  }
  if constexpr (effects.has(effect::depth_ranges)) {
    // Binned vertices keep the depth of the sub-range in which they were transformed.
    if (plan.mode == Mode::binned) return {.error = Error::depth_effects};
  }
  if constexpr (effect_bytes(effects, 1) != 0) {
    auto instances = static_cast<std::uint32_t>(request.scene.instances.size());
    if constexpr (effects.has(effect::outlines)) instances = count(request.scene).instances;
    const std::uint64_t needed = effect_bytes(request.called_for, instances);
    if (plan.effect_bytes < needed) return too_small(Purpose::effects, needed, plan.effect_bytes);
  }
  if constexpr (depth_bytes(depth_format(effects)) != kDepthBytes) {
    const std::uint64_t needed =
        std::uint64_t{plan.strip_rows} * plan.strip_columns * depth_bytes(depth_format(effects));
    if (plan.depth_bytes < needed) return too_small(Purpose::depth, needed, plan.depth_bytes);
  }
  return {};
}

/// Of draw_strip.
Status check_strip(const FrameState& frame, std::uint16_t strip, std::span<const std::byte> pixels);
/// Where the frame is one of samples, and `pixels` those of the display.
Status check_strip_of_samples(const FrameState& frame, std::uint16_t strip, std::span<const std::byte> pixels);
template <Effects effects>
Status check_strip(const FrameState& frame, std::uint16_t strip, std::span<const std::byte> pixels) {
  if constexpr (effects.has(effect::supersampled)) return check_strip_of_samples(frame, strip, pixels);
  return check_strip(frame, strip, pixels);
}
inline Status check_strip_number(const FrameState& frame, std::uint16_t strip) {
  if (frame.scene == nullptr) return {.error = Error::not_begun};
  if (strip >= frame.plan.strips) {
    return {.error = Error::strip_rows, .needed = strip, .available = frame.plan.strips};
  }
  return {};
}
/// Whether `pixels` has room for `area` of the picture.
inline Status check_room(const Rect& area, PixelFormat format, std::span<const std::byte> pixels) {
  const auto rows = static_cast<std::uint32_t>(area.height());
  const std::uint32_t needed = rows * bytes_per_row(static_cast<std::uint16_t>(area.width()), format);
  if (pixels.size() < needed) {
    const auto available = static_cast<std::uint32_t>(pixels.size());
    return {.error = Error::pixels_too_small, .needed = needed, .available = available};
  }
  if (drawn_in_place(format) && reinterpret_cast<std::uintptr_t>(pixels.data()) % 2 != 0) {
    return {.error = Error::pixels_misaligned};
  }
  return {};
}

/// Of draw_over: whether `area` lies in the picture, and has so many pixels and depths.
Status check_area(const FrameState& frame, const Rect& area, std::size_t pixels, std::size_t depths);
/// Other pixels have cells of 16 bits, and no method.
constexpr bool can_draw_over(Effects effects) { return effects.methods == 0 && !DepthStage::has_own_clear(effects); }
template <Effects effects>
Status check_area(const FrameState& frame, const Rect& area, std::size_t pixels, std::size_t depths) {
  if (effects.methods != 0) return {.error = Error::visibility, .needed = effects.methods};
  if (!can_draw_over(effects)) return {.error = Error::depth_effects};
  return check_area(frame, area, pixels, depths);
}

}  // namespace zstrip::detail
