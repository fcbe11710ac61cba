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
    detail::Assembler<effects>::draw(target, batch, triangles, all_narrow);
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
    frame.view_ = view;
    frame.plan_ = plan;
    frame.statistics_ = {};
    lay_out_arena(frame, arena);
    if (const Status status = prepare(frame, scene, camera, view); !status) return status;
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
    clear(frame, rows, drawn, target);
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
