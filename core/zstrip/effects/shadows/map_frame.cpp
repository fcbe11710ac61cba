// Prepares the shadow of a frame and keeps the strips of its map; only renderers with effect::shadows link it.
#include "zstrip/effects/shadows/map_frame.hpp"

#include <algorithm>
#include <new>

#include "zstrip/state/bounds.hpp"

namespace zstrip::detail {

DecodedTiles::Tile& ShadowState::decode(DecodedTiles::Tile& tile, std::uint32_t tx, std::uint32_t ty, Status& status) {
  tile.column = static_cast<std::uint16_t>(tx);
  tile.row = static_cast<std::uint16_t>(ty);
  const Status read = store.read_tile(tx, ty, tile.cells, kTileSide);
  if (!read && status) status = {.error = read.error, .purpose = Purpose::effects, .needed = read.needed};
  return tile;
}

bool ShadowState::hidden_beside(std::int32_t across, std::int32_t down, const MapDepth& point, Status& status) {
  const auto beside = [this](std::int32_t texels) {
    return (texels >> place.texel_bits) + ((texels >> (place.texel_bits - 1) & 1) != 0 ? 1 : -1);
  };
  const auto hidden_at = [&](std::int32_t column, std::int32_t row) {
    const std::uint32_t caster = caster_at(column, row, status);
    return caster != 0 && distance_to(caster, point) > 0;
  };
  const std::int32_t column = across >> place.texel_bits, row = down >> place.texel_bits;
  return hidden_at(beside(across), row) && hidden_at(column, beside(down)) && hidden_at(beside(across), beside(down));
}

}  // namespace zstrip::detail

namespace zstrip::detail::shadows {

Status check_memory(const FrameRequest& request) {
  const Plan& plan = request.plan;
  const SceneCounts& counts = request.counts;
  const std::uint64_t extents = std::uint64_t{counts.meshlets} * kExtentBytes;
  if (plan.extent_bytes < extents) return too_small(Purpose::extents, extents, plan.extent_bytes);
  const std::uint32_t strip = shadow_strip_bytes(counts);
  if (plan.depth_bytes < strip) return too_small(Purpose::depth, strip, plan.depth_bytes);
  const std::uint64_t vertices = std::uint64_t{counts.vertices} * retained_bytes_per_vertex(request.called_for, counts);
  if (plan.mode == Mode::binned && plan.vertex_bytes < vertices) {
    return too_small(Purpose::vertices, vertices, plan.vertex_bytes);
  }
  return {};
}

ShadowState& begin_state(FrameState& frame, const Scene& scene) {
  auto* const state = ::new (&state_of(frame)) ShadowState;
  state->scene = scene;
  const std::size_t lights = scene.lights.size(), shadowing = scene.shadow->light;
  std::size_t next = 0;
  for (std::size_t i = 0; i < lights; ++i) {
    if (i != shadowing) state->lights[next++] = scene.lights[i];
  }
  state->lights[next] = scene.lights[shadowing];
  state->scene.lights = {state->lights, lights};
  auto* const memory = reinterpret_cast<std::byte*>(state) + Effect::kStateBytes;
  state->pool = {memory, effect_block(frame).end()};
  state->decoded.forget();
  return *state;
}

Status prepare_map(FrameState& light, const FrameState& frame, const Scene& casters, const LightReach& reach,
                   ShadowState& state) {
  const std::uint32_t side = std::uint32_t{1} << casters.shadow->log2_size;
  if (Status status = state.store.reset(state.pool, side, side); !status) {
    status.purpose = Purpose::effects;
    return status;
  }
  if (const Status status = light_camera(state.camera, reach, side); !status) return status;
  // The map takes the rows of tiles that fit into the picture's z-buffer, next to one row of pixels.
  const std::uint32_t room = frame.plan.depth_bytes / (side * kDepthBytes) - 1;
  const std::uint32_t rows = std::min(room / kTileSide * kTileSide, side);
  light.view = {static_cast<std::uint16_t>(side), static_cast<std::uint16_t>(side)};
  light.plan.mode = light.mode = Mode::streamed;
  light.plan.strip_rows = static_cast<std::uint16_t>(rows);
  light.plan.strip_columns = static_cast<std::uint16_t>(side);
  light.plan.strips = static_cast<std::uint16_t>((side + rows - 1) / rows);
  light.instances = frame.instances;
  auto* const extents = reinterpret_cast<std::byte*>(frame.instances) + frame.plan.instance_bytes;
  light.extents = light.plan.strips > 1 ? reinterpret_cast<Extent*>(extents) : nullptr;
  light.vertices = frame.vertices;
  light.depth = frame.depth;
  light.working_colour = frame.depth + std::size_t{rows} * side;
  state.fit = light.fit = fit_to({0, 0}, state.camera);
  light.origin = raster_origin(light.view, light.fit, true);
  for (std::uint32_t i = 0; i < casters.instances.size(); ++i) {
    CompiledInstance& instance = light.instances[i];
    instance.visible = false;
    if (!casts(casters, casters.instances[i])) continue;
    if (const Status status =
            compile_instance(instance, casters, casters.instances[i], state.camera, light.view, light.fit);
        !status) {
      return {.error = status.error, .needed = i};
    }
    instance.double_sided = true;
    const Rect box = instance.visible ? bounds_of(instance, light.origin, light.view, true) : Rect{};
    instance.visible = !box.empty();
    if (instance.visible) extend_bounds(light, box);
  }
  return {};
}

StripTarget map_strip(FrameState& light, std::uint16_t strip) {
  const Rect cut = light.plan.strip_area(strip, light.view);
  Rect area = light.bounds.cut_to(cut);
  if (area.empty()) area = {};
  const std::size_t cells = static_cast<std::size_t>(cut.width()) * static_cast<std::size_t>(cut.height());
  __builtin_memset(light.depth, 0, cells * kDepthBytes);
  StripTarget target = target_at(light, area);
  target.depth = light.depth + (area.empty() ? 0 : (area.top - cut.top) * cut.width() + area.left);
  target.depth_stride = cut.width();
  target.colour = light.working_colour;  // all rows share one row of pixels
  return target;
}

Status keep_strip(const FrameState& light, std::uint16_t strip, ShadowState& state) {
  const Rect cut = light.plan.strip_area(strip, light.view);
  Status status =
      state.store.write_rows({light.depth, static_cast<std::uint32_t>(cut.width()), static_cast<std::uint32_t>(cut.top),
                              static_cast<std::uint32_t>(cut.height())});
  if (!status) status.purpose = Purpose::effects;
  return status;
}

Status prepare_place(FrameState& frame, const Camera& camera, Effects called_for, std::uint32_t least) {
  ShadowState& state = state_of(frame);
  if (frame.fit.near == 0) state.empty = true;
  if (state.empty) return {};
  if (frame.mode == Mode::binned) {
    // The colours lie after all other data of vertices.
    const SceneCounts counts = count(*frame.scene);
    const std::size_t others = std::size_t{counts.vertices} * bytes_per_vertex(called_for, counts);
    state.colours_in_shadow = reinterpret_cast<Colour*>(reinterpret_cast<std::byte*>(frame.vertices) + others);
  }
  return shadow_place(state.place, {state.camera, state.fit, state.store.grid().width}, camera, frame.view, frame.fit,
                      frame.origin, least);
}

}  // namespace zstrip::detail::shadows
