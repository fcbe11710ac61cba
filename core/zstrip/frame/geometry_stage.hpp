// The geometry stage: meshlets in drawing order, transformed, lit, and assigned to strips.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "zstrip/effects/outlines/outline.hpp"
#include "zstrip/frame/materials.hpp"
#include "zstrip/frame/method_stage.hpp"
#include "zstrip/raster/facing.hpp"

namespace zstrip {

struct Frame::Access::Geometry {
  /// The triangles of a meshlet and the vertices that they use; of the whole mesh where it has no meshlets.
  struct MeshletRange {
    std::uint32_t first_vertex, vertex_count;
    std::span<const Triangle> triangles;
  };

  static MeshletRange meshlet_range(const Mesh& mesh, std::uint32_t index) {
    if (mesh.meshlets.empty()) return {0, static_cast<std::uint32_t>(mesh.positions.size()), mesh.triangles};
    const Meshlet& meshlet = mesh.meshlets[index];
    return {meshlet.first_vertex, meshlet.vertex_count,
            mesh.triangles.subspan(meshlet.first_triangle, meshlet.triangle_count)};
  }

  /// Calls visit(number, instance index, meshlet index) in drawing order; numbers count the meshlets of all instances,
  /// invisible ones too, but are called only for visible ones.
  template <Effects effects, class Visit>
  static void for_each_meshlet(const Frame& frame, const Visit& visit) {
    std::uint32_t number = 0;
    for (std::uint32_t place = 0; place < frame.scene_->instances.size(); ++place) {
      std::uint32_t i = place;
      if constexpr (effects.has(effect::blending)) {
        if (const auto block = effect_block(frame); block.has(effect::blending)) i = block.order()[place].instance;
      }
      const Mesh& mesh = frame.scene_->meshes[frame.scene_->instances[i].mesh];
      const std::uint32_t meshlets = mesh.meshlets.empty() ? 1 : static_cast<std::uint32_t>(mesh.meshlets.size());
      if (frame.instances_[i].visible) {
        for (std::uint32_t m = 0; m < meshlets; ++m) visit(number + m, i, m);
      }
      number += meshlets;
    }
  }

  /// A meshlet with its vertices at vertices_[cache] on.
  static detail::Batch batch_of(const Frame& frame, std::uint32_t instance, std::uint32_t first_vertex,
                                std::uint32_t cache) {
    const detail::CompiledInstance& compiled = frame.instances_[instance];
    const bool has_colours = compiled.lit || compiled.coloured;
    return {&compiled,
            &frame.scene_->meshes[compiled.mesh],
            frame.vertices_ + cache,
            has_colours ? frame.colours_ + cache : nullptr,
            first_vertex,
            frame.origin_,
            Materials::surface_of(frame, compiled)};
  }

  /// The same, with what drawing it needs beside.
  template <Effects effects>
  static detail::BatchOf<effects> batch_for(const Frame& frame, std::uint32_t instance, std::uint32_t first_vertex,
                                            std::uint32_t cache) {
    if constexpr (effects.has(effect::environment)) {
      return {batch_of(frame, instance, first_vertex, cache), reflections_of(frame, instance, cache)};
    } else {
      return batch_of(frame, instance, first_vertex, cache);
    }
  }

  /// Null if the instance does not mirror the surroundings.
  static TexCoord* reflections_of(const Frame& frame, std::uint32_t instance, std::uint32_t cache) {
    const Scene& scene = *frame.scene_;
    const detail::CompiledInstance& compiled = frame.instances_[instance];
    if (detail::is_outline(compiled) ||
        !mirrors_surroundings(scene, scene.meshes[compiled.mesh], scene.materials[compiled.material])) {
      return nullptr;
    }
    auto* const vertices = reinterpret_cast<std::byte*>(frame.vertices_);
    return reinterpret_cast<TexCoord*>(vertices + effect_block(frame).reflections().first) + cache;
  }

  /// False if some vertex needs the clipping path.
  template <Effects effects>
  static bool transform(Frame& frame, const detail::Batch& batch, const MeshletRange& range, std::uint32_t cache) {
    if constexpr (effects.has(effect::statistics)) frame.statistics_.vertices += range.vertex_count;
    if constexpr (effects.has(effect::outlines)) {
      if (detail::is_outline(*batch.instance)) {
        return detail::transform_hull<effects.has(effect::orthographic), depth_format(effects)>(
            *batch.instance, *batch.mesh, frame.origin_, range.first_vertex, range.vertex_count,
            frame.vertices_ + cache);
      }
    }
    return detail::transform_vertices<detail::raster_effects(effects)>(
        *batch.instance, *batch.mesh, frame.origin_, range.first_vertex, range.vertex_count, frame.vertices_ + cache);
  }

  template <Effects effects>
  static void shade(Frame& frame, const detail::BatchOf<effects>& batch, const MeshletRange& range,
                    std::uint32_t cache) {
    if constexpr (effects.has(effect::environment)) {
      if (batch.reflections != nullptr) reflect<effects.has(effect::orthographic)>(frame, batch, range);
    }
    if constexpr (detail::has_vertex_colours(effects)) {
      if (batch.colours != nullptr) {
        if constexpr (effects.any(effect::vertex_light)) {
          if (shade_locally<effects>(frame, batch, range, cache)) return;
        }
        detail::shade_vertices<effects&(effect::lighting | effect::vertex_colours)>(
            *batch.instance, *batch.mesh, range.first_vertex, range.vertex_count, frame.colours_ + cache);
      }
    }
  }

  template <bool orthographic>
  static void reflect(const Frame& frame, const detail::ReflectingBatch& batch, const MeshletRange& range) {
    const detail::EyeForms& forms =
        effect_block(frame).eye_forms(static_cast<std::size_t>(batch.instance - frame.instances_));
    const detail::TextureView& texture = batch.surface.texture;
    for (std::uint32_t i = 0; i < range.vertex_count; ++i) {
      const std::uint32_t vertex = range.first_vertex + i;
      const detail::MirroredPoint point = detail::mirrored_point<orthographic>(
          forms, batch.mesh->positions[vertex], batch.mesh->normals[vertex], batch.instance->double_sided);
      batch.reflections[vertex - batch.first_vertex] =
          detail::texcoord_of(point, texture.log2_width, texture.log2_height);
    }
  }

  /// The colours of a retained meshlet in shadow, in their own part of the vertices.
  template <Effects effects>
  static void shade_in_shadow(Frame& frame, const detail::BatchOf<effects>& batch, const MeshletRange& range,
                              std::uint32_t cache) {
    const detail::EffectBlock block = effect_block(frame);
    if (!block.has(effect::shadows) || block.shadows().empty) return;
    const auto number = static_cast<std::size_t>(batch.instance - frame.instances_);
    Colour* const lit = frame.colours_;
    frame.colours_ = block.shadows().colours_in_shadow;
    detail::leave_shadowing_light(frame.instances_[number], frame.scene_->meshes[batch.instance->mesh], -1);
    shade<effects>(frame, batch, range, cache);
    detail::leave_shadowing_light(frame.instances_[number], frame.scene_->meshes[batch.instance->mesh], 1);
    frame.colours_ = lit;
  }

  /// False if the instance has no light beyond what all have.
  template <Effects effects>
  static bool shade_locally(Frame& frame, const detail::Batch& batch, const MeshletRange& range, std::uint32_t cache) {
    const Scene& scene = *frame.scene_;
    const detail::CompiledInstance& instance = *batch.instance;
    const Material& material = scene.materials[instance.material];
    if (!effects_of_finish(scene, material, instance.lit, false).any(effect::vertex_light)) return false;
    const Finish finish = finish_of(scene, material);
    const detail::EffectBlock block = effect_block(frame);
    const detail::FrameLights* lights = nullptr;
    const detail::InstanceShading* shading = nullptr;
    if (block.has(effect::local_light)) {
      lights = &block.lights();
      shading = &block.shading(static_cast<std::size_t>(batch.instance - frame.instances_));
    }
    for (std::uint32_t i = 0; i < range.vertex_count; ++i) {
      const std::uint32_t vertex = range.first_vertex + i;
      const Colour lit =
          detail::locally_lit_colour<effects>(instance, *batch.mesh, vertex, scene, lights, shading, finish);
      frame.colours_[cache + i] = detail::with_vertex_colour<effects>(lit, instance, *batch.mesh, vertex);
    }
    return true;
  }

  /// Strips with an apron are drawn with what lies in that, too.
  static Rect with_apron(const Rect& box) {
    return box.empty() ? box : Rect{box.left - 1, box.top - 1, box.right + 1, box.bottom + 1};
  }
  template <Effects effects>
  static bool has_apron(const Frame& frame) {
    if constexpr (effects.has(effect::edges)) return effect_block(frame).has(effect::edges);
    return false;
  }

  /// Which strips the front faces of each meshlet touch.
  template <Effects effects>
  static void survey(Frame& frame) {
    for_each_meshlet<effects>(frame, [&](std::uint32_t number, std::uint32_t instance, std::uint32_t meshlet) {
      if constexpr (effects.has(method::culling)) {
        frame.extents_[number] = detail::Extent::none();
        if (Methods::is_left_out<effects>(frame, number, instance, meshlet)) return;
      }
      const MeshletRange range = meshlet_range(frame.scene_->meshes[frame.instances_[instance].mesh], meshlet);
      const auto batch = batch_for<effects>(frame, instance, range.first_vertex, 0);
      const bool all_narrow = transform<effects>(frame, batch, range, 0);
      Rect box{INT32_MAX, INT32_MAX, INT32_MIN, INT32_MIN};
      detail::Facing<effects>::for_each(batch, range.triangles, all_narrow, [&](std::uint32_t, const auto& covered) {
        const Rect pixels = covered.box();
        box = {std::min(box.left, pixels.left), std::min(box.top, pixels.top), std::max(box.right, pixels.right),
               std::max(box.bottom, pixels.bottom)};
        return true;
      });
      if constexpr (effects.has(effect::edges)) {
        if (has_apron<effects>(frame)) box = with_apron(box);
      }
      frame.extents_[number] = frame.grid_.extent_of(box);
    });
  }

  /// Transforms everything once and writes each front face into the lists of its strips. False if they are too small.
  template <Effects effects>
  static bool fill_bins(Frame& frame) {
    std::uint32_t retained = 0;
    std::uint16_t batches = 0;
    bool room = true;
    for_each_meshlet<effects>(
        frame, [&]([[maybe_unused]] std::uint32_t number, std::uint32_t instance, std::uint32_t meshlet) {
          if (!room) return;
          if constexpr (effects.has(method::culling)) {
            if (Methods::is_left_out<effects>(frame, number, instance, meshlet)) return;
          }
          const MeshletRange range = meshlet_range(frame.scene_->meshes[frame.instances_[instance].mesh], meshlet);
          const auto batch = batch_for<effects>(frame, instance, range.first_vertex, retained);
          const bool all_narrow = transform<effects>(frame, batch, range, retained);
          bool listed = false;
          room = detail::Facing<effects>::for_each(
              batch, range.triangles, all_narrow, [&](std::uint32_t triangle, const auto& covered) {
                listed = true;
                if constexpr (effects.has(effect::edges)) {
                  if (has_apron<effects>(frame)) {
                    return list_with_apron(frame, covered.box(), batches, triangle);
                  }
                }
                return list(frame, covered, batches, triangle);
              });
          if (!listed) return;
          shade<effects>(frame, batch, range, retained);
          if constexpr (effects.has(effect::shadows)) shade_in_shadow<effects>(frame, batch, range, retained);
          frame.batches_[batches++] = detail::retained_batch(instance, meshlet, retained, all_narrow);
          retained += range.vertex_count;
        });
    return room;
  }

  /// Into the lists of all strips of an extent.
  static bool list(Frame& frame, const detail::Extent& extent, std::uint16_t batch, std::uint16_t triangle) {
    return list_in(frame, frame.grid_.strips_of_extent(extent), batch, triangle);
  }
  static bool list_with_apron(Frame& frame, const Rect& box, std::uint16_t batch, std::uint32_t triangle) {
    return list_in(frame, frame.grid_.strips_of(with_apron(box)), batch, static_cast<std::uint16_t>(triangle));
  }
  /// Into the lists of all strips that hold pixels which a front face can cover. Inlined wherever it is called: where
  /// many pipelines share a program, the compiler would make it a call for every triangle.
  template <class Pixels>
  [[gnu::always_inline]] static bool list(Frame& frame, const Pixels& covered, std::uint16_t batch,
                                          std::uint32_t triangle) {
    const auto index = static_cast<std::uint16_t>(triangle);
    if (frame.grid_.across() != 1) return list_in(frame, frame.grid_.strips_of(covered.box()), batch, index);
    const detail::StripGrid::Range rows = frame.grid_.rows_of(covered.top(), covered.bottom());
    for (std::int32_t row = rows.first; row < rows.end; ++row) {
      if (!frame.bins_.add(static_cast<std::uint32_t>(row), batch, index)) return false;
    }
    return true;
  }
  /// `strips`: columns and rows of strips.
  static bool list_in(Frame& frame, const Rect& strips, std::uint16_t batch, std::uint16_t triangle) {
    for (std::int32_t row = strips.top; row < strips.bottom; ++row) {
      for (std::int32_t column = strips.left; column < strips.right; ++column) {
        const auto strip = static_cast<std::uint32_t>(row * frame.grid_.across() + column);
        if (!frame.bins_.add(strip, batch, triangle)) return false;
      }
    }
    return true;
  }
};

}  // namespace zstrip
