// Everything about the caller's requests that could harm, before any stage runs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "zstrip/frame/depth_stage.hpp"

namespace zstrip {

struct Frame::Access::Checks {
  /// Of begin_frame; not the index arrays, which validate() has seen.
  template <Effects effects>
  static Status frame(const Scene& scene, const Camera& camera, const View& view, const Plan& plan, Effects called_for,
                      std::span<std::byte> arena) {
    // A pipeline has one projection: this is the effect that must not be there without being called for.
    if (effects.has(effect::orthographic) && camera.projection != Projection::orthographic) {
      return {.error = Error::effect_missing};
    }
    if (plan.mode == Mode::binned && !effects.has(effect::bins)) {
      return {.error = Error::effect_missing, .needed = low_bits(effect::bins)};
    }
    // Binned vertices keep the depth of the sub-range in which they were transformed.
    if (plan.mode == Mode::binned && effects.has(effect::depth_ranges)) return {.error = Error::depth_effects};
    if (const Status status = every_frame(scene, camera, view, plan, called_for, effects, arena); !status) {
      return status;
    }
    if constexpr (effects.has(effect::shadows)) {
      if (const Status status = shadows(scene, plan, called_for); !status) return status;
    } else if constexpr (detail::effect_bytes(effects, 1) != 0) {
      auto instances = static_cast<std::uint32_t>(scene.instances.size());
      if constexpr (effects.has(effect::outlines)) instances = count(scene).instances;
      const std::uint64_t needed = detail::effect_bytes(called_for, instances);
      if (plan.effect_bytes < needed) return too_small(Purpose::effects, needed, plan.effect_bytes);
    }
    if constexpr (effects.has(effect::csg)) {
      if (const Status status = csg(scene, plan, called_for, detail::depth_cell_bytes(effects)); !status) return status;
    }
    if constexpr (effects.has(effect::edges)) {
      if (const Status status = edges(scene, view, plan, called_for); !status) return status;
    }
    if constexpr (effects.has(effect::environment)) {
      const SceneCounts counts = count(scene);
      const std::uint64_t needed = std::uint64_t{plan.mode == Mode::binned ? counts.vertices : counts.largest_meshlet} *
                                   detail::bytes_per_vertex(called_for);
      if (plan.vertex_bytes < needed) return too_small(Purpose::vertices, needed, plan.vertex_bytes);
    }
    if constexpr (depth_bytes(depth_format(effects)) != kDepthBytes) {
      const std::uint64_t needed =
          std::uint64_t{plan.strip_rows} * plan.strip_columns * depth_bytes(depth_format(effects));
      if (plan.depth_bytes < needed) return too_small(Purpose::depth, needed, plan.depth_bytes);
    }
    return {};
  }
  /// Of renderers with effect::shadows, whose other effects' bytes are among them.
  static Status shadows(const Scene& scene, const Plan& plan, Effects called_for);
  /// Of renderers with effect::csg.
  static Status csg(const Scene& scene, const Plan& plan, Effects called_for, std::uint32_t cell_bytes);
  /// Of renderers with effect::edges.
  static Status edges(const Scene& scene, const View& view, const Plan& plan, Effects called_for);
  static Status every_frame(const Scene& scene, const Camera& camera, const View& view, const Plan& plan,
                            Effects called_for, Effects effects, std::span<std::byte> arena);

  /// Of draw_strip.
  static Status strip(const Frame& frame, std::uint16_t strip, std::span<const std::byte> pixels);
  static Status strip_number(const Frame& frame, std::uint16_t strip) {
    if (frame.scene_ == nullptr) return {.error = Error::not_begun};
    if (strip >= frame.plan_.strips) {
      return {.error = Error::strip_rows, .needed = strip, .available = frame.plan_.strips};
    }
    return {};
  }
  /// Whether `pixels` has room for `area` of the picture.
  static Status room(const Rect& area, PixelFormat format, std::span<const std::byte> pixels) {
    const auto rows = static_cast<std::uint32_t>(area.height());
    const std::uint32_t needed = rows * bytes_per_row(static_cast<std::uint16_t>(area.width()), format);
    if (pixels.size() < needed) {
      const auto available = static_cast<std::uint32_t>(pixels.size());
      return {.error = Error::pixels_too_small, .needed = needed, .available = available};
    }
    if (detail::drawn_in_place(format) && reinterpret_cast<std::uintptr_t>(pixels.data()) % 2 != 0) {
      return {.error = Error::pixels_misaligned};
    }
    return {};
  }

  /// Of draw_over.
  template <Effects effects>
  static Status area(const Frame& frame, const Rect& area, std::size_t pixels, std::size_t depths) {
    if (frame.scene_ == nullptr) return {.error = Error::not_begun};
    if constexpr (effects.has(effect::supersampled)) {
      if (frame.view_.samples != 1) return {.error = Error::samples, .needed = frame.view_.samples};
    }
    if (effects.methods != 0) return {.error = Error::visibility, .needed = effects.methods};
    if (DepthStage::has_own_clear(effects)) return {.error = Error::depth_effects};
    if constexpr (effects.has(effect::shadows)) {
      if (frame.scene_->shadow != nullptr) return {.error = Error::shadow};
    }
    if constexpr (effects.has(effect::csg)) {
      const auto operands = static_cast<std::uint32_t>(frame.scene_->csg.size());
      if (operands != 0) return {.error = Error::csg, .needed = operands, .available = 0};
    }
    if constexpr (effects.has(effect::edges)) {
      if (effect_block(frame).has(effect::edges)) return {.error = Error::edges};
    }
    return every_area(frame, area, pixels, depths);
  }
  static Status every_area(const Frame& frame, const Rect& area, std::size_t pixels, std::size_t depths);

  static Status too_small(Purpose purpose, std::uint64_t needed, std::uint32_t available) {
    return {.error = Error::arena_too_small,
            .purpose = purpose,
            .needed = static_cast<std::uint32_t>(needed),
            .available = available};
  }
};

}  // namespace zstrip
