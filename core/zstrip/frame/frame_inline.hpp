// The stages in their order: begin_frame prepares instances and bounds, draw_strip draws and resolves.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

#include "zstrip/frame/bounds.hpp"
#include "zstrip/frame/frame.hpp"
#include "zstrip/raster/assemble.hpp"
#include "zstrip/resolve/resolve.hpp"
#include "zstrip/scene/validate.hpp"

namespace zstrip {

struct Frame::Access {
  /// Everything about the request that could harm; not the index arrays, which validate() has seen.
  static Status check(const Scene& scene, const Camera& camera, const View& view, const Plan& plan, Effects missing,
                      std::span<std::byte> arena);
  static void lay_out_arena(Frame& frame, std::span<std::byte> arena);
  static Status prepare(Frame& frame, const Scene& scene, const Camera& camera, const View& view);
  static detail::StripTarget target_of(Frame& frame, std::uint16_t strip, std::uint16_t* pixels);
  static void clear(const Frame& frame, std::uint16_t rows, std::uint16_t* pixels, const detail::StripTarget& target);
  static void resolve(const Frame& frame, std::uint16_t rows, std::uint16_t* drawn, std::byte* pixels);

  template <Effects effects>
  static void draw_instances(Frame& frame, const detail::StripTarget& target) {
    for (std::uint32_t i = 0; i < frame.scene_->instances.size(); ++i) {
      const detail::CompiledInstance& instance = frame.instances_[i];
      if (!instance.visible) continue;
      const Mesh& mesh = frame.scene_->meshes[instance.mesh];
      if (mesh.meshlets.empty()) {
        draw_meshlet<effects>(frame, target, instance, mesh, 0, static_cast<std::uint32_t>(mesh.positions.size()),
                              mesh.triangles);
      }
      for (const Meshlet& meshlet : mesh.meshlets) {
        draw_meshlet<effects>(frame, target, instance, mesh, meshlet.first_vertex, meshlet.vertex_count,
                              mesh.triangles.subspan(meshlet.first_triangle, meshlet.triangle_count));
      }
    }
  }

  template <Effects effects>
  static void draw_meshlet(Frame& frame, const detail::StripTarget& target, const detail::CompiledInstance& instance,
                           const Mesh& mesh, std::uint32_t first_vertex, std::uint32_t vertex_count,
                           std::span<const Triangle> triangles) {
    if constexpr (effects.has(effect::statistics)) frame.statistics_.vertices += vertex_count;
    const bool all_narrow =
        detail::transform_vertices<effects>(instance, mesh, frame.origin_, first_vertex, vertex_count, frame.vertices_);
    detail::Batch batch{
        &instance, &mesh, frame.vertices_, nullptr, first_vertex, frame.origin_, surface_of(frame, instance)};
    if constexpr (detail::has_vertex_colours(effects)) {
      if (instance.lit || instance.coloured) {
        detail::shade_vertices<effects>(instance, mesh, first_vertex, vertex_count, frame.colours_);
        batch.colours = frame.colours_;
      }
    }
    if constexpr (std::is_same_v<detail::TargetFor<detail::depth_mode(effects)>, detail::StripTarget>) {
      detail::Assembler<effects>::draw(target, batch, triangles, all_narrow);
    } else {
      const detail::StripTargetWithDepth with_depth{target, depth_settings<effects>(frame, instance)};
      detail::Assembler<effects>::draw(with_depth, batch, triangles, all_narrow);
    }
  }

  template <Effects effects>
  static detail::DepthSettings depth_settings(const Frame& frame, const detail::CompiledInstance& instance) {
    constexpr DepthFormat kFormat = depth_format(effects);
    const Material& material = frame.scene_->materials[instance.material];
    detail::DepthSettings settings;
    settings.test = material.depth_test;
    settings.write = material.depth_write;
    settings.bias = material.depth_bias;
    settings.slope_bias = material.depth_slope_bias;
    settings.bias_clamp = material.depth_bias_clamp;
    settings.largest = largest_depth_code(kFormat);
    if constexpr (kFormat == DepthFormat::w16) settings.linear = detail::linear_mapping(frame.fit_);
    if constexpr (effects.has(effect::depth_ranges)) {
      const std::uint32_t cleared = static_cast<const FrameWithDepthRanges&>(frame).cleared_code_;
      settings.smallest = cleared + 1;
      settings.largest = cleared + detail::kDepthRangeCodes - 2;
    }
    return settings;
  }

  static detail::Surface surface_of(const Frame& frame, const detail::CompiledInstance& instance) {
    detail::Surface surface{detail::rgb565(instance.base), {nullptr, 0, 0}, frame.fit_.offset};
    const std::uint16_t index = frame.scene_->materials[instance.material].texture;
    if (index != kNoTexture) {
      const Texture& texture = frame.scene_->textures[index];
      surface.texture = {texture.texels.data(), texture.log2_width, texture.log2_height};
    }
    return surface;
  }

  static constexpr bool has_own_mapping(Effects effects) {
    return effects.any(effect::depth_formats | effect::depth_ranges);
  }
  static constexpr bool has_own_clear(Effects effects) {
    return depth_bytes(depth_format(effects)) != kDepthBytes || effects.has(effect::depth_ranges);
  }

  /// From z16's, for which the frame has been prepared.
  template <Effects effects>
  static void change_mapping(Frame& frame, const Scene& scene) {
    if (frame.fit_.near == 0) return;  // nothing is visible
    const detail::DepthMapping mapping = effects.has(effect::depth_ranges)
                                             ? detail::depth_mapping_of_ranges(frame.fit_)
                                             : detail::depth_mapping(depth_format(effects), frame.fit_);
    detail::change_depth_mapping(mapping, effects.has(effect::orthographic), frame.fit_, frame.origin_,
                                 {frame.instances_, scene.instances.size()});
  }

  /// What clear() does not: cells of 32 bits, and sub-ranges, where the strip gets the next one and often no clear.
  template <Effects effects>
  static void clear_depth(Frame& frame, const detail::StripTarget& target) {
    const auto cells = static_cast<std::uint32_t>(target.area.width() * target.area.height());
    if constexpr (effects.has(effect::depth_ranges)) {
      if (cells == 0) return;
      auto& ranged = static_cast<FrameWithDepthRanges&>(frame);
      const std::uint32_t usable = ranged.ranges_.next(cells);
      __builtin_memset(frame.depth_ + usable, 0, std::size_t{cells - usable} * kDepthBytes);
      const std::int64_t up =
          (std::int64_t{ranged.ranges_.cleared_code()} - ranged.cleared_code_) * (1 << 16);  // 16.16 codes
      ranged.cleared_code_ = ranged.ranges_.cleared_code();
      if constexpr (effects.has(effect::orthographic)) {
        frame.origin_.depth_offset += static_cast<std::uint32_t>(up);
      } else {
        frame.fit_.offset -= up;
        frame.origin_.depth_offset = static_cast<std::uint32_t>(frame.fit_.offset);
      }
    } else {
      __builtin_memset(frame.depth_, 0, std::size_t{cells} * depth_bytes(depth_format(effects)));
    }
  }

  template <Effects effects>
  static Status begin_frame(Frame& frame, const Scene& scene, const Camera& camera, const View& view, const Plan& plan,
                            std::span<std::byte> arena) {
    frame.scene_ = nullptr;
    const Effects missing = without(effects_of(scene, camera), effects);
    // A pipeline has one projection: this is the effect that must not be there without being called for.
    if (effects.has(effect::orthographic) && camera.projection != Projection::orthographic) {
      return {.error = Error::effect_missing};
    }
    if (const Status status = check(scene, camera, view, plan, missing, arena); !status) return status;
    if constexpr (depth_bytes(depth_format(effects)) != kDepthBytes) {
      const std::uint64_t needed = std::uint64_t{plan.strip_rows} * view.width * depth_bytes(depth_format(effects));
      if (plan.depth_bytes < needed) {
        return {.error = Error::arena_too_small,
                .purpose = Purpose::depth,
                .needed = static_cast<std::uint32_t>(needed),
                .available = plan.depth_bytes};
      }
    }
    frame.view_ = view;
    frame.plan_ = plan;
    frame.statistics_ = {};
    lay_out_arena(frame, arena);
    if constexpr (effects.has(effect::depth_ranges)) {
      auto& ranged = static_cast<FrameWithDepthRanges&>(frame);
      ranged.ranges_.begin_frame(frame.depth_, plan.depth_bytes / kDepthBytes);
      ranged.cleared_code_ = 0;
    }
    if (const Status status = prepare(frame, scene, camera, view); !status) return status;
    if constexpr (has_own_mapping(effects)) change_mapping<effects>(frame, scene);
    if constexpr (effects.has(effect::statistics)) frame.statistics_.triangles = count(scene).triangles;
    frame.scene_ = &scene;
    return {};
  }

  template <Effects effects>
  static Status draw_strip(Frame& frame, std::uint16_t strip, std::span<std::byte> pixels) {
    if (frame.scene_ == nullptr) return {.error = Error::not_begun};
    if (strip >= frame.plan_.strips)
      return {.error = Error::strip_rows, .needed = strip, .available = frame.plan_.strips};
    const auto rows = static_cast<std::uint16_t>(
        std::min<std::int32_t>(frame.plan_.strip_rows, frame.view_.height - strip * frame.plan_.strip_rows));
    const std::uint32_t needed = rows * bytes_per_row(frame.view_.width, frame.view_.format);
    if (pixels.size() < needed) {
      return {
          .error = Error::pixels_too_small, .needed = needed, .available = static_cast<std::uint32_t>(pixels.size())};
    }
    if (detail::drawn_in_place(frame.view_.format) && reinterpret_cast<std::uintptr_t>(pixels.data()) % 2 != 0) {
      return {.error = Error::pixels_misaligned};
    }
    auto* const drawn = detail::drawn_in_place(frame.view_.format) ? reinterpret_cast<std::uint16_t*>(pixels.data())
                                                                   : frame.working_colour_;
    const detail::StripTarget target = target_of(frame, strip, drawn);
    if constexpr (has_own_clear(effects)) {
      detail::fill_pixels(drawn, std::uint32_t{rows} * frame.view_.width, detail::rgb565(frame.scene_->background));
      clear_depth<effects>(frame, target);
    } else {
      clear(frame, rows, drawn, target);
    }
    if (!target.area.empty()) draw_instances<effects>(frame, target);
    resolve(frame, rows, drawn, pixels.data());
    return {};
  }
};

namespace detail {

template <Effects effects>
Status begin_frame(Frame& frame, const Scene& scene, const Camera& camera, const View& view, const Plan& plan,
                   std::span<std::byte> arena) {
  return Frame::Access::begin_frame<effects>(frame, scene, camera, view, plan, arena);
}

template <Effects effects>
Status draw_strip(Frame& frame, std::uint16_t strip, std::span<std::byte> pixels) {
  return Frame::Access::draw_strip<effects>(frame, strip, pixels);
}

}  // namespace detail
}  // namespace zstrip
