// The stages in their order: begin_frame prepares instances and bounds, draw_strip draws and resolves.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

#include "zstrip/frame/bounds.hpp"
#include "zstrip/frame/effect_block.hpp"
#include "zstrip/frame/frame.hpp"
#include "zstrip/raster/assemble.hpp"
#include "zstrip/raster/quadric.hpp"
#include "zstrip/raster/quadric_shade.hpp"
#include "zstrip/resolve/convert.hpp"
#include "zstrip/resolve/resolve.hpp"
#include "zstrip/scene/validate.hpp"

namespace zstrip {

struct Frame::Access {
  /// Binning does not change how triangles are drawn.
  template <Effects effects>
  using Assembler = detail::Assembler<without(effects, effect::bins)>;

  /// Everything about the request that could harm; not the index arrays, which validate() has seen.
  static Status check(const Scene& scene, const Camera& camera, const View& view, const Plan& plan, Effects called_for,
                      Effects effects, std::span<std::byte> arena);
  /// Checks and lays out what a visibility method has; everything else of the frame has been prepared.
  static Status begin_method(FrameWithMethod& frame, Effects effects, const SceneCounts& counts,
                             std::span<std::byte> arena);
  static void begin_strip_of_method(FrameWithMethod& frame, Effects effects, detail::StripTarget& target);
  /// See visibility_stages.hpp, which renderers with a method include.
  template <Effects effects>
  static Status order_triangles(FrameWithMethod& frame, const Camera& camera);
  template <Effects effects>
  static void collect_triangles(FrameWithMethod& frame);
  template <Effects effects>
  static Status collect_from_tree(FrameWithMethod& frame, const Camera& camera);
  template <Effects effects>
  static void draw_sorted(FrameWithMethod& frame, const detail::StripTarget& target, std::uint16_t strip);
  template <Effects effects>
  static bool is_left_out(Frame& frame, std::uint32_t number, std::uint32_t instance, std::uint32_t meshlet);
  template <Effects effects>
  static bool is_hidden(FrameWithMethod& frame, const detail::StripTarget& target, std::uint32_t instance,
                        const Meshlet* meshlet);
  template <Effects effects, class Draw>
  static void draw_seen_first(FrameWithMethod& frame, const detail::StripTarget& target, const Draw& draw);
  template <Effects effects>
  static void count_culled(FrameWithMethod& frame);
  static void lay_out_arena(Frame& frame, std::span<std::byte> arena);
  /// Compiles the instances, finds the frame's bounds.
  static Status prepare(Frame& frame, const Scene& scene, const Camera& camera, const View& view, const DepthFit& fit);
  static void extend_bounds(Frame& frame, const Rect& box);
  /// Compiles the quadrics, for the depth mapping that the frame has now.
  static Status prepare_quadrics(Frame& frame, const Scene& scene, const Camera& camera);
  /// They lie behind the instances.
  static detail::CompiledQuadric* quadrics_of(const Frame& frame, const Scene& scene) {
    auto* const first = reinterpret_cast<std::byte*>(frame.instances_);
    return reinterpret_cast<detail::CompiledQuadric*>(first + scene.instances.size() * kInstanceBytes);
  }
  /// Into strips, of the bounds that are now known.
  static void divide(Frame& frame, const Scene& scene, const View& view);
  /// `strip`: its pixels in the picture.
  static detail::StripTarget target_of(Frame& frame, const Rect& strip, std::uint16_t* pixels);
  static void clear(const Frame& frame, std::uint16_t width, std::uint16_t rows, std::uint16_t* pixels,
                    const detail::StripTarget& target);
  /// `area`: pixels of the picture inside the frame's bounds. Where they and their depth lie is left to the caller.
  static detail::StripTarget target_at(Frame& frame, const Rect& area);

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
            surface_of(frame, compiled)};
  }

  /// False if some vertex needs the clipping path.
  template <Effects effects>
  static bool transform(Frame& frame, const detail::Batch& batch, const MeshletRange& range, std::uint32_t cache) {
    if constexpr (effects.has(effect::statistics)) frame.statistics_.vertices += range.vertex_count;
    return detail::transform_vertices<without(effects, effect::bins)>(
        *batch.instance, *batch.mesh, frame.origin_, range.first_vertex, range.vertex_count, frame.vertices_ + cache);
  }

  template <Effects effects>
  static void shade(Frame& frame, const detail::Batch& batch, const MeshletRange& range, std::uint32_t cache) {
    if constexpr (detail::has_vertex_colours(effects)) {
      if (batch.colours != nullptr) {
        if constexpr (effects.any(effect::vertex_light)) {
          if (shade_locally<effects>(frame, batch, range, cache)) return;
        }
        detail::shade_vertices<without(effects, effect::bins)>(*batch.instance, *batch.mesh, range.first_vertex,
                                                               range.vertex_count, frame.colours_ + cache);
      }
    }
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

  /// Which strips the front faces of each meshlet touch.
  template <Effects effects>
  static void survey(Frame& frame) {
    for_each_meshlet<effects>(frame, [&](std::uint32_t number, std::uint32_t instance, std::uint32_t meshlet) {
      if constexpr (effects.has(method::culling)) {
        frame.extents_[number] = detail::Extent::none();
        if (is_left_out<effects>(frame, number, instance, meshlet)) return;
      }
      const MeshletRange range = meshlet_range(frame.scene_->meshes[frame.instances_[instance].mesh], meshlet);
      const detail::Batch batch = batch_of(frame, instance, range.first_vertex, 0);
      const bool all_narrow = transform<effects>(frame, batch, range, 0);
      Rect box{INT32_MAX, INT32_MAX, INT32_MIN, INT32_MIN};
      Assembler<effects>::for_each_facing(batch, range.triangles, all_narrow, [&](std::uint32_t, const Rect& pixels) {
        box = {std::min(box.left, pixels.left), std::min(box.top, pixels.top), std::max(box.right, pixels.right),
               std::max(box.bottom, pixels.bottom)};
        return true;
      });
      frame.extents_[number] = frame.grid_.extent_of(box);
    });
  }

  /// Transforms everything once and writes each front face into the lists of its strips. False if they are too small.
  template <Effects effects>
  static bool fill_bins(Frame& frame) {
    std::uint32_t retained = 0;
    std::uint16_t batches = 0;
    bool room = true;
    for_each_meshlet<effects>(frame, [&]([[maybe_unused]] std::uint32_t number, std::uint32_t instance,
                                         std::uint32_t meshlet) {
      if (!room) return;
      if constexpr (effects.has(method::culling)) {
        if (is_left_out<effects>(frame, number, instance, meshlet)) return;
      }
      const MeshletRange range = meshlet_range(frame.scene_->meshes[frame.instances_[instance].mesh], meshlet);
      const detail::Batch batch = batch_of(frame, instance, range.first_vertex, retained);
      const bool all_narrow = transform<effects>(frame, batch, range, retained);
      bool listed = false;
      room = Assembler<effects>::for_each_facing(batch, range.triangles, all_narrow,
                                                 [&](std::uint32_t triangle, const Rect& pixels) {
                                                   listed = true;
                                                   return list(frame, pixels, batches, triangle);
                                                 });
      if (!listed) return;
      shade<effects>(frame, batch, range, retained);
      frame.batches_[batches++] = {static_cast<std::uint16_t>(instance), static_cast<std::uint16_t>(meshlet), retained};
      retained += range.vertex_count;
    });
    return room;
  }

  /// Into the lists of all strips of an extent.
  static bool list(Frame& frame, const detail::Extent& extent, std::uint16_t batch, std::uint16_t triangle) {
    const Rect strips = frame.grid_.strips_of_extent(extent);
    for (std::int32_t row = strips.top; row < strips.bottom; ++row) {
      for (std::int32_t column = strips.left; column < strips.right; ++column) {
        const auto strip = static_cast<std::uint32_t>(row * frame.grid_.across() + column);
        if (!frame.bins_.add(strip, batch, triangle)) return false;
      }
    }
    return true;
  }

  /// Into the lists of all strips that hold pixels of the box.
  static bool list(Frame& frame, const Rect& pixels, std::uint16_t batch, std::uint32_t triangle) {
    const auto index = static_cast<std::uint16_t>(triangle);
    if (frame.grid_.across() == 1) {
      const detail::StripGrid::Range rows = frame.grid_.rows_of(pixels.top, pixels.bottom);
      for (std::int32_t row = rows.first; row < rows.end; ++row) {
        if (!frame.bins_.add(static_cast<std::uint32_t>(row), batch, index)) return false;
      }
      return true;
    }
    const Rect strips = frame.grid_.strips_of(pixels);
    for (std::int32_t row = strips.top; row < strips.bottom; ++row) {
      for (std::int32_t column = strips.left; column < strips.right; ++column) {
        const auto strip = static_cast<std::uint32_t>(row * frame.grid_.across() + column);
        if (!frame.bins_.add(strip, batch, index)) return false;
      }
    }
    return true;
  }

  template <Effects effects>
  static void draw_streamed(Frame& frame, const detail::StripTarget& target, std::uint16_t strip) {
    const std::int32_t row = strip / frame.grid_.across();
    const std::int32_t column = strip % frame.grid_.across();
    const auto draw_meshlet = [&](std::uint32_t number, std::uint32_t instance, std::uint32_t meshlet) {
      if (frame.extents_ != nullptr && !frame.grid_.touches(frame.extents_[number], row, column)) return;
      if constexpr (effects.has(method::culling)) {
        if (is_left_out<effects>(frame, number, instance, meshlet)) return;
      }
      const MeshletRange range = meshlet_range(frame.scene_->meshes[frame.instances_[instance].mesh], meshlet);
      const detail::Batch batch = batch_of(frame, instance, range.first_vertex, 0);
      const bool all_narrow = transform<effects>(frame, batch, range, 0);
      shade<effects>(frame, batch, range, 0);
      with_settings<effects>(frame, target, *batch.instance, [&](const auto& complete) {
        Assembler<effects>::draw(complete, batch, range.triangles, all_narrow);
      });
    };
    if constexpr (effects.has(method::hierarchical_z)) {
      draw_seen_first<effects>(static_cast<FrameWithMethod&>(frame), target, draw_meshlet);
    } else {
      for_each_meshlet<effects>(frame, draw_meshlet);
    }
  }

  template <Effects effects>
  static void draw_binned(Frame& frame, const detail::StripTarget& target, std::uint16_t strip) {
    frame.bins_.for_each_run(strip, [&](std::uint16_t number, const std::uint16_t* triangles, std::uint32_t count) {
      const detail::RetainedBatch& retained = frame.batches_[number];
      const MeshletRange range =
          meshlet_range(frame.scene_->meshes[frame.instances_[retained.instance].mesh], retained.meshlet);
      const detail::Batch batch = batch_of(frame, retained.instance, range.first_vertex, retained.first_vertex);
      with_settings<effects>(frame, target, *batch.instance, [&](const auto& complete) {
        Assembler<effects>::draw_listed(complete, batch, range.triangles, {triangles, count});
      });
    });
  }

  template <Effects effects>
  static void draw_quadrics(const Frame& frame, const detail::StripTarget& target) {
    constexpr bool kOrthographic = effects.has(effect::orthographic);
    const std::int64_t offset = kOrthographic ? std::int64_t{frame.origin_.depth_offset} : -frame.fit_.offset;
    const detail::CompiledQuadric* const quadrics = quadrics_of(frame, *frame.scene_);
    for (std::size_t i = 0; i < frame.scene_->quadrics.size(); ++i) {
      const detail::CompiledQuadric& quadric = quadrics[i];
      if (!quadric.visible) continue;
      detail::QuadricShade<effects> shade{quadric, texture_of(frame, quadric.material)};
      if constexpr (effects.has(effect::fog)) {
        if (frame.scene_->fog != nullptr) shade.fog = &effect_block(frame).fog();
        shade.depth_offset = kOrthographic ? offset : -offset;
      }
      with_depth<effects>(frame, target, quadric.material, [&](const auto& complete) {
        detail::QuadricFill<effects>::draw(complete, quadric, offset, shade);
      });
    }
  }

  /// Calls draw(target), with what the depth effects of this material add to it.
  template <Effects effects, class Draw>
  static void with_depth(const Frame& frame, const detail::StripTarget& target, std::uint16_t material,
                         const Draw& draw) {
    if constexpr (std::is_same_v<detail::TargetFor<detail::depth_mode(effects)>, detail::StripTarget>) {
      draw(target);
    } else {
      draw(detail::StripTargetWithDepth{target, depth_settings<effects>(frame, material)});
    }
  }

  /// Calls draw(target), with what the depth effects of this instance's material and its fragments add to it.
  template <Effects effects, class Draw>
  static void with_settings(Frame& frame, const detail::StripTarget& target, const detail::CompiledInstance& instance,
                            const Draw& draw) {
    if constexpr (effects.methods != 0) {
      detail::MethodState& state = static_cast<FrameWithMethod&>(frame).state_;
      draw(detail::StripTargetWithMethod{{target, depth_settings<effects>(frame, instance.material)}, &state});
    } else {
      with_depth<effects>(frame, target, instance.material,
                          [&](const auto& complete) { with_fragments<effects>(frame, complete, instance, draw); });
    }
  }
  template <Effects effects, class Target, class Draw>
  static void with_fragments(const Frame& frame, const Target& target, const detail::CompiledInstance& instance,
                             const Draw& draw) {
    if constexpr (effects.any(effect::fragments)) {
      draw(detail::TargetOf<effects>{target, fragment_settings<effects>(frame, instance)});
    } else {
      draw(target);
    }
  }

  static detail::EffectBlock effect_block(const Frame& frame) {
    return {reinterpret_cast<std::byte*>(frame.batches_) + frame.plan_.bin_bytes, frame.plan_.effect_bytes,
            frame.scene_->instances.size()};
  }

  /// Opaque instances in the scene's order, then those that blend, from far to near.
  static void prepare_order(const Frame& frame, const Camera& camera) {
    const Scene& scene = *frame.scene_;
    const std::span<detail::DrawOrder> order = effect_block(frame).order();
    const auto blends = [&scene](const Instance& instance) {
      return finish_of(scene, scene.materials[instance.material]).alpha_mode == AlphaMode::blend;
    };
    std::size_t count = 0;
    for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
      if (!blends(scene.instances[i])) order[count++] = {0, i, 0};
    }
    const std::size_t first = count;
    for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
      const Instance& instance = scene.instances[i];
      if (!blends(instance)) continue;
      const detail::DistanceRange range =
          detail::distance_range(scene.meshes[instance.mesh], instance.transform, camera);
      const Distance middle = range.nearest / 2 + range.farthest / 2;
      std::size_t place = count++;
      for (; place > first && order[place - 1].distance < middle; --place) order[place] = order[place - 1];
      order[place] = {middle, i, 0};
    }
  }

  /// What effects need through the frame.
  template <Effects effects>
  static void prepare_effects(Frame& frame, const Camera& camera, [[maybe_unused]] Effects called_for) {
    [[maybe_unused]] const detail::EffectBlock block = effect_block(frame);
    if constexpr (detail::effect_bytes(effects, 1) != 0) block.lay_out(called_for);
    if constexpr (effects.has(effect::blending)) {
      if (block.has(effect::blending)) prepare_order(frame, camera);
    }
    if constexpr (effects.any(effect::local_light)) {
      if (block.has(effect::local_light)) prepare_local_light(frame, camera);
    }
    if constexpr (effects.any(effect::fragments)) prepare_fragments<effects>(frame);
  }

  static void prepare_local_light(const Frame& frame, const Camera& camera) {
    const Scene& scene = *frame.scene_;
    const detail::EffectBlock block = effect_block(frame);
    block.lights() = detail::frame_lights(scene, camera);
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
      const Instance& instance = scene.instances[i];
      block.shading(i) = detail::instance_shading(scene.meshes[instance.mesh], instance.transform, camera);
    }
  }

  /// Which instances are drawn by fill_fragments.
  template <Effects effects>
  static void prepare_fragments(Frame& frame) {
    const Scene& scene = *frame.scene_;
    constexpr bool kOrthographic = effects.has(effect::orthographic);
    if constexpr (effects.has(effect::fog)) {
      if (scene.fog != nullptr && frame.fit_.near != 0) {
        effect_block(frame).fog() = detail::fog_curve(
            *scene.fog, detail::distance_scale(frame.fit_, kOrthographic, detail::depth_span(effects)));
      }
    }
    for (detail::CompiledInstance& instance : std::span(frame.instances_, scene.instances.size())) {
      if (!instance.visible) continue;
      const Effects finish = effects_of_finish(scene, scene.materials[instance.material], instance.lit,
                                               instance.shade >= detail::Shade::textured);
      if (scene.fog != nullptr || finish.any(effect::fragments)) {
        instance.shade = detail::with_fragments(instance.shade);
      }
    }
  }

  template <Effects effects>
  static detail::FragmentSettings fragment_settings(const Frame& frame, const detail::CompiledInstance& instance) {
    detail::FragmentSettings settings;
    settings.textured = detail::without_fragments(instance.shade) >= detail::Shade::textured;
    const Material& material = frame.scene_->materials[instance.material];
    const Finish finish = finish_of(*frame.scene_, material);
    settings.alpha = material.colour.a;
    if (finish.alpha_mode == AlphaMode::mask) settings.cutoff = finish.alpha_cutoff;
    settings.blends = finish.alpha_mode == AlphaMode::blend;
    settings.bilinear = finish.filter == TextureFilter::bilinear;
    settings.has_texture_alpha = settings.textured && finish.alpha_mode != AlphaMode::opaque &&
                                 frame.scene_->textures[material.texture].format == TextureFormat::rgb565_alpha;
    if constexpr (effects.has(effect::fog)) {
      if (frame.scene_->fog != nullptr) settings.fog = &effect_block(frame).fog();
      settings.depth_offset =
          effects.has(effect::orthographic) ? std::int64_t{frame.origin_.depth_offset} : frame.fit_.offset;
    }
    return settings;
  }

  template <Effects effects>
  static detail::DepthSettings depth_settings(const Frame& frame, std::uint16_t index) {
    constexpr DepthFormat kFormat = depth_format(effects);
    const Material& material = frame.scene_->materials[index];
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
    return {detail::rgb565(instance.base), texture_of(frame, instance.material), frame.fit_.offset};
  }

  static detail::TextureView texture_of(const Frame& frame, std::uint16_t material) {
    const std::uint16_t index = frame.scene_->materials[material].texture;
    if (index == kNoTexture) return {nullptr, 0, 0};
    const Texture& texture = frame.scene_->textures[index];
    return {texture.texels.data(), texture.log2_width, texture.log2_height};
  }

  static constexpr bool has_own_mapping(Effects effects) {
    return effects.any(effect::depth_formats | effect::depth_ranges);
  }
  static constexpr bool has_own_clear(Effects effects) {
    return effects.has(method::painter) || depth_bytes(depth_format(effects)) != kDepthBytes ||
           effects.has(effect::depth_ranges);
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
      __builtin_memset(frame.depth_, 0, std::size_t{cells} * detail::depth_cell_bytes(effects));
    }
  }

  template <Effects effects>
  static Status begin_frame(Frame& frame, const Scene& scene, const Camera& camera, const View& view, const Plan& plan,
                            std::span<std::byte> arena) {
    frame.scene_ = nullptr;
    frame.next_to_last_strip_ = 0;
    const Effects called_for = effects_of(scene, camera);
    // A pipeline has one projection: this is the effect that must not be there without being called for.
    if (effects.has(effect::orthographic) && camera.projection != Projection::orthographic) {
      return {.error = Error::effect_missing};
    }
    if (plan.mode == Mode::binned && !effects.has(effect::bins)) {
      return {.error = Error::effect_missing, .needed = low_bits(effect::bins)};
    }
    // Binned vertices keep the depth of the sub-range in which they were transformed.
    if (plan.mode == Mode::binned && effects.has(effect::depth_ranges)) return {.error = Error::depth_effects};
    if (const Status status = check(scene, camera, view, plan, called_for, effects, arena); !status) {
      return status;
    }
    if constexpr (detail::effect_bytes(effects, 1) != 0) {
      const std::uint64_t needed = detail::effect_bytes(called_for, static_cast<std::uint32_t>(scene.instances.size()));
      if (plan.effect_bytes < needed) {
        return {.error = Error::arena_too_small,
                .purpose = Purpose::effects,
                .needed = static_cast<std::uint32_t>(needed),
                .available = plan.effect_bytes};
      }
    }
    if constexpr (depth_bytes(depth_format(effects)) != kDepthBytes) {
      const std::uint64_t needed =
          std::uint64_t{plan.strip_rows} * plan.strip_columns * depth_bytes(depth_format(effects));
      if (plan.depth_bytes < needed) {
        return {.error = Error::arena_too_small,
                .purpose = Purpose::depth,
                .needed = static_cast<std::uint32_t>(needed),
                .available = plan.depth_bytes};
      }
    }
    frame.view_ = view;
    frame.plan_ = plan;
    frame.mode_ = plan.mode;
    frame.has_special_depth_ = has_own_clear(effects);
    frame.statistics_ = {};
    lay_out_arena(frame, arena);
    if constexpr (effects.has(effect::depth_ranges)) {
      auto& ranged = static_cast<FrameWithDepthRanges&>(frame);
      ranged.ranges_.begin_frame(frame.depth_, plan.depth_bytes / kDepthBytes);
      ranged.cleared_code_ = 0;
    }
    detail::DistanceRange reach = detail::reach_of(scene, camera);
    if constexpr (effects.has(effect::quadrics)) detail::extend(reach, scene.quadrics, camera);
    if (const Status status = prepare(frame, scene, camera, view, detail::fit_to(reach, camera)); !status) {
      return status;
    }
    if constexpr (has_own_mapping(effects)) change_mapping<effects>(frame, scene);
    if constexpr (effects.has(effect::quadrics)) {
      if (const Status status = prepare_quadrics(frame, scene, camera); !status) return status;
    }
    divide(frame, scene, view);
    if constexpr (effects.has(effect::statistics)) frame.statistics_.triangles = count(scene).triangles;
    if constexpr (effects.methods != 0) {
      if (const Status status = begin_method(static_cast<FrameWithMethod&>(frame), effects, count(scene), arena);
          !status) {
        return status;
      }
    }
    frame.scene_ = &scene;
    prepare_effects<effects>(frame, camera, called_for);
    if constexpr (effects.has(method::culling | effect::statistics)) {
      count_culled<effects>(static_cast<FrameWithMethod&>(frame));
    }
    if constexpr (sorts_triangles(effects))
      return order_triangles<effects>(static_cast<FrameWithMethod&>(frame), camera);
    if (frame.extents_ == nullptr) return {};
    if constexpr (effects.has(effect::bins)) {
      if (frame.mode_ == Mode::binned) {
        if (fill_bins<effects>(frame)) return {};
        frame.mode_ = Mode::streamed;
        ++frame.bin_overflows_;
      }
    }
    survey<effects>(frame);
    return {};
  }

  template <Effects effects>
  static Status draw_strip(Frame& frame, std::uint16_t strip, std::span<std::byte> pixels) {
    if (frame.scene_ == nullptr) return {.error = Error::not_begun};
    if (strip >= frame.plan_.strips)
      return {.error = Error::strip_rows, .needed = strip, .available = frame.plan_.strips};
    const Rect area = frame.plan_.strip_area(strip, frame.view_);
    const auto width = static_cast<std::uint16_t>(area.width());
    const auto rows = static_cast<std::uint16_t>(area.height());
    const std::uint32_t needed = rows * bytes_per_row(width, frame.view_.format);
    if (pixels.size() < needed) {
      return {
          .error = Error::pixels_too_small, .needed = needed, .available = static_cast<std::uint32_t>(pixels.size())};
    }
    if (detail::drawn_in_place(frame.view_.format) && reinterpret_cast<std::uintptr_t>(pixels.data()) % 2 != 0) {
      return {.error = Error::pixels_misaligned};
    }
    auto* const drawn = detail::drawn_in_place(frame.view_.format) ? reinterpret_cast<std::uint16_t*>(pixels.data())
                                                                   : frame.working_colour_;
    detail::StripTarget target = target_of(frame, area, drawn);
    if constexpr (has_own_clear(effects)) {
      detail::fill_pixels(drawn, std::uint32_t{rows} * width, detail::rgb565(frame.scene_->background));
      clear_depth<effects>(frame, target);
    } else {
      clear(frame, width, rows, drawn, target);
    }
    if constexpr (effects.methods != 0) {
      begin_strip_of_method(static_cast<FrameWithMethod&>(frame), effects, target);
    }
    if (!target.area.empty()) draw_surfaces<effects>(frame, target, strip);
    convert_pixels(frame.view_.format, width, rows, drawn, pixels.data());
    frame.next_to_last_strip_ = strip + 1U;
    return {};
  }

  template <Effects effects>
  static Status draw_over(Frame& frame, const Rect& area, std::span<std::uint16_t> pixels,
                          std::span<std::uint16_t> depth) {
    if (frame.scene_ == nullptr) return {.error = Error::not_begun};
    if constexpr (effects.methods != 0) {
      return {.error = Error::visibility, .needed = effects.methods};
    } else if constexpr (has_own_clear(effects)) {
      return {.error = Error::depth_effects};
    } else {
      if (area.empty() || area.left < 0 || area.top < 0 || area.right > frame.view_.width ||
          area.bottom > frame.view_.height) {
        return {.error = Error::view_size};
      }
      const auto cells = static_cast<std::uint32_t>(area.width() * area.height());
      if (pixels.size() < cells || depth.size() < cells) {
        return {.error = Error::pixels_too_small,
                .needed = 2 * cells,
                .available = static_cast<std::uint32_t>(2 * std::min(pixels.size(), depth.size()))};
      }
      const Rect strips = frame.grid_.strips_of_picture(area);
      for (std::int32_t row = strips.top; row < strips.bottom; ++row) {
        for (std::int32_t column = strips.left; column < strips.right; ++column) {
          const auto strip = static_cast<std::uint16_t>(row * frame.grid_.across() + column);
          const Rect cut = frame.plan_.strip_area(strip, frame.view_);
          const Rect part{std::max({cut.left, area.left, frame.bounds_.left}),
                          std::max({cut.top, area.top, frame.bounds_.top}),
                          std::min({cut.right, area.right, frame.bounds_.right}),
                          std::min({cut.bottom, area.bottom, frame.bounds_.bottom})};
          detail::StripTarget target = target_at(frame, part);
          const std::int32_t first = (part.top - area.top) * area.width() + (part.left - area.left);
          target.depth = depth.data() + first;
          target.colour = pixels.data() + first;
          target.depth_stride = target.colour_stride = area.width();
          draw_surfaces<effects>(frame, target, strip);
        }
      }
      return {};
    }
  }

  template <Effects effects>
  static void draw_surfaces(Frame& frame, const detail::StripTarget& target, std::uint16_t strip) {
    // They are opaque: what blends comes after them.
    if constexpr (effects.has(effect::quadrics)) draw_quadrics<effects>(frame, target);
    draw_triangles<effects>(frame, target, strip);
  }

  template <Effects effects>
  static void draw_triangles(Frame& frame, const detail::StripTarget& target, std::uint16_t strip) {
    if constexpr (effects.has(effect::bins)) {
      if (frame.mode_ == Mode::binned) return draw_binned<effects>(frame, target, strip);
    }
    if constexpr (sorts_triangles(effects)) {
      return draw_sorted<effects>(static_cast<FrameWithMethod&>(frame), target, strip);
    }
    draw_streamed<effects>(frame, target, strip);
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

template <Effects effects>
Status draw_over(Frame& frame, const Rect& area, std::span<std::uint16_t> pixels, std::span<std::uint16_t> depth) {
  return Frame::Access::draw_over<effects>(frame, area, pixels, depth);
}

}  // namespace detail
}  // namespace zstrip
