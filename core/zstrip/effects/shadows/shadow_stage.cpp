// Prepares the shadow of a frame and keeps the strips of its map; only renderers with effect::shadows link it.
#include "zstrip/effects/shadows/shadow_stage.hpp"

#include <new>

#include "zstrip/frame/frame_inline.hpp"

namespace zstrip {

void detail::ShadowState::decode(DecodedTiles::Tile& tile, std::uint32_t tx, std::uint32_t ty, Status& status) {
  tile.column = static_cast<std::uint16_t>(tx);
  tile.row = static_cast<std::uint16_t>(ty);
  const Status read = store.read_tile(tx, ty, tile.cells, kTileSide);
  if (!read && status) status = {.error = read.error, .purpose = Purpose::effects, .needed = read.needed};
}

detail::ShadowState& Frame::Access::Shadows::begin(Frame& frame, const Scene& scene, Effects called_for) {
  // Hulls of outlines are not there yet, but the place counts them.
  const detail::EffectBlock block{reinterpret_cast<std::byte*>(frame.batches_) + frame.plan_.bin_bytes,
                                  frame.plan_.effect_bytes, count(scene).instances};
  block.lay_out(called_for);
  auto* const state = ::new (&block.shadows()) detail::ShadowState;
  state->scene = scene;
  const std::size_t lights = scene.lights.size(), shadowing = scene.shadow->light;
  std::size_t next = 0;
  for (std::size_t i = 0; i < lights; ++i) {
    if (i != shadowing) state->lights[next++] = scene.lights[i];
  }
  state->lights[next] = scene.lights[shadowing];
  state->scene.lights = {state->lights, lights};
  state->pool = block.shadow_pool();
  state->decoded.forget();
  return *state;
}

Status Frame::Access::Shadows::prepare_map(Frame& light, const Frame& frame, const Scene& casters,
                                           const detail::LightReach& reach, detail::ShadowState& state) {
  const std::uint32_t side = std::uint32_t{1} << casters.shadow->log2_size;
  if (Status status = state.store.reset(state.pool, side, side); !status) {
    status.purpose = Purpose::effects;
    return status;
  }
  if (const Status status = detail::light_camera(state.camera, reach, side); !status) return status;
  // As many rows of tiles as the picture's z-buffer has room for, beside a row of pixels.
  const std::uint32_t room = frame.plan_.depth_bytes / (side * kDepthBytes) - 1;
  const std::uint32_t rows = std::min(room / kTileSide * kTileSide, side);
  light.view_ = {static_cast<std::uint16_t>(side), static_cast<std::uint16_t>(side)};
  light.plan_.mode = light.mode_ = Mode::streamed;
  light.plan_.strip_rows = static_cast<std::uint16_t>(rows);
  light.plan_.strip_columns = static_cast<std::uint16_t>(side);
  light.plan_.strips = static_cast<std::uint16_t>((side + rows - 1) / rows);
  light.instances_ = frame.instances_;
  auto* const extents = reinterpret_cast<std::byte*>(frame.instances_) + frame.plan_.instance_bytes;
  light.extents_ = light.plan_.strips > 1 ? reinterpret_cast<detail::Extent*>(extents) : nullptr;
  light.vertices_ = frame.vertices_;
  light.depth_ = frame.depth_;
  light.working_colour_ = frame.depth_ + std::size_t{rows} * side;
  state.fit = light.fit_ = detail::fit_to({0, 0}, state.camera);
  light.origin_ = detail::raster_origin(light.view_, light.fit_, true);
  for (std::uint32_t i = 0; i < casters.instances.size(); ++i) {
    detail::CompiledInstance& instance = light.instances_[i];
    instance.visible = false;
    if (!casts(casters, casters.instances[i])) continue;
    if (const Status status =
            detail::compile_instance(instance, casters, casters.instances[i], state.camera, light.view_, light.fit_);
        !status) {
      return {.error = status.error, .needed = i};
    }
    instance.double_sided = true;
    const Rect box = instance.visible ? detail::bounds_of(instance, light.origin_, light.view_, true) : Rect{};
    instance.visible = !box.empty();
    if (instance.visible) extend_bounds(light, box);
  }
  return {};
}

detail::StripTarget Frame::Access::Shadows::map_strip(Frame& light, std::uint16_t strip) {
  const Rect cut = light.plan_.strip_area(strip, light.view_);
  const Rect& bounds = light.bounds_;
  Rect area{std::max(bounds.left, cut.left), std::max(bounds.top, cut.top), std::min(bounds.right, cut.right),
            std::min(bounds.bottom, cut.bottom)};
  if (area.empty()) area = {};
  const std::size_t cells = static_cast<std::size_t>(cut.width()) * static_cast<std::size_t>(cut.height());
  __builtin_memset(light.depth_, 0, cells * kDepthBytes);
  detail::StripTarget target = target_at(light, area);
  target.depth = light.depth_ + (area.empty() ? 0 : (area.top - cut.top) * cut.width() + area.left);
  target.depth_stride = cut.width();
  target.colour = light.working_colour_;  // all rows are one
  return target;
}

Status Frame::Access::Shadows::keep_strip(const Frame& light, std::uint16_t strip, detail::ShadowState& state) {
  const Rect cut = light.plan_.strip_area(strip, light.view_);
  Status status =
      state.store.write_rows({light.depth_, static_cast<std::uint32_t>(cut.width()),
                              static_cast<std::uint32_t>(cut.top), static_cast<std::uint32_t>(cut.height())});
  if (!status) status.purpose = Purpose::effects;
  return status;
}

Status Frame::Access::Shadows::prepare_place(Frame& frame, const Camera& camera, Effects called_for,
                                             std::uint32_t least) {
  detail::ShadowState& state = effect_block(frame).shadows();
  if (frame.fit_.near == 0) state.empty = true;
  if (state.empty) return {};
  if (frame.mode_ == Mode::binned) {
    // Behind everything else of the vertices.
    const std::size_t others = std::size_t{count(*frame.scene_).vertices} * detail::bytes_per_vertex(called_for);
    state.colours_in_shadow = reinterpret_cast<Colour*>(reinterpret_cast<std::byte*>(frame.vertices_) + others);
  }
  return detail::shadow_place(state.place, {state.camera, state.fit, state.store.grid().width}, camera, frame.view_,
                              frame.fit_, frame.origin_, least);
}

}  // namespace zstrip
