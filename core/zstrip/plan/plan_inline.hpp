// The bodies of plan.hpp.
#pragma once

#include <algorithm>

#include "zstrip/plan/estimate.hpp"
#include "zstrip/plan/plan.hpp"
#include "zstrip/plan/visibility_bytes.hpp"
#include "zstrip/store/tile_store.hpp"

namespace zstrip {

/// Bytes of the renderer's own records; the stages that define them assert these sizes on every target.
inline constexpr std::uint32_t kInstanceBytes = 160;
inline constexpr std::uint32_t kQuadricBytes = 384;
inline constexpr std::uint32_t kLineSetBytes = 176;
inline constexpr std::uint32_t kVertexBytes = 8;        // snapped x, y and depth
inline constexpr std::uint32_t kVertexColourBytes = 4;  // only with lighting or vertex colours
inline constexpr std::uint32_t kReflectionBytes = 4;    // where a vertex mirrors the surroundings, likewise
inline constexpr std::uint32_t kExtentBytes = 4;        // the strips that a meshlet touches
inline constexpr std::uint32_t kBatchBytes = 8;         // a transformed meshlet, binned only
inline constexpr std::uint32_t kBinBytes = 8;           // a strip's list
inline constexpr std::uint32_t kBinChunkBytes = 32;     // part of a list: kBinChunkEntries and a link
inline constexpr std::uint32_t kBinChunkEntries = 15;
inline constexpr std::uint32_t kEffectHeaderBytes = 16;  // which effects have a part, and of how many instances
inline constexpr std::uint32_t kFogBytes = 40;           // the frame's fog
inline constexpr std::uint32_t kWorldLightBytes = 44;
inline constexpr std::uint32_t kFrameLightsBytes = 192;     // lights that depend on where a vertex is, of the frame
inline constexpr std::uint32_t kInstanceShadingBytes = 68;  // and what they need of an instance
inline constexpr std::uint32_t kTurnedInstanceBytes = 52;   // an instance that may have been turned to the viewer
inline constexpr std::uint32_t kFrameReflectionsBytes = 8;  // where those of the frame lie
inline constexpr std::uint32_t kEyeFormsBytes = 68;         // what they need of an instance
inline constexpr std::uint32_t kOutlinedSceneBytes = 224;   // the scene with outlines as instances of their own
inline constexpr std::uint32_t kShadowStateBytes = 2656;    // the frame's shadow and tiles of its map, decoded
inline constexpr std::uint32_t kCsgStateBytes = 8;          // of products of solids
inline constexpr std::uint32_t kCsgOperandBytes = 16;       // and of each operand
inline constexpr std::uint32_t kEdgeStateBytes = 8;         // of edges that are anti-aliased
inline constexpr std::uint32_t kEdgeGroupBytes = 8;         // and of a group of them
inline constexpr std::uint32_t kDrawOrderBytes = 16;        // an instance's place in the order of blending
inline constexpr std::uint32_t kMostBinChunks = 0xFFFF;
inline constexpr std::uint32_t kMostBatches = 0x7FFF;  // that bins can name; likewise triangles of a meshlet
inline constexpr std::uint32_t kMostStrips = 0xFFFF;
inline constexpr std::uint32_t kDepthBytes = 2;          // a cell of the z-buffer, unless depth_bytes says 4
inline constexpr std::uint32_t kWorkingColourBytes = 2;  // RGB565

namespace detail {
/// Strips are split at whole bytes of every pixel format.
inline constexpr std::uint32_t kColumnStep = 8;

constexpr std::uint32_t rounded_up(std::uint64_t bytes) {
  const std::uint64_t aligned = (bytes + kArenaAlignment - 1) / kArenaAlignment * kArenaAlignment;
  return aligned > 0xFFFFFFFF ? 0xFFFFFFF8 : static_cast<std::uint32_t>(aligned);
}

/// Rows of a strip that a static layer can keep.
constexpr std::uint16_t whole_tiles(std::uint32_t rows, std::uint16_t height) {
  return static_cast<std::uint16_t>(std::min<std::uint32_t>((rows + kTileSide - 1) / kTileSide * kTileSide, height));
}

constexpr bool has_vertex_colours(Effects effects) { return effects.any(effect::lighting | effect::vertex_colours); }

/// Of a transformed vertex.
constexpr std::uint32_t bytes_per_vertex(Effects effects) {
  return kVertexBytes + (has_vertex_colours(effects) ? kVertexColourBytes : 0) +
         (effects.has(effect::environment) ? kReflectionBytes : 0);
}

/// Of one that bins keep: in shadow it has another colour.
constexpr std::uint32_t retained_bytes_per_vertex(Effects effects) {
  return bytes_per_vertex(effects) + (effects.has(effect::shadows) ? kVertexColourBytes : 0);
}

/// What effects keep through a frame of so many instances, outlines among them.
constexpr std::uint64_t effect_bytes(Effects effects, std::uint32_t instances) {
  std::uint64_t bytes = 0;
  if (effects.has(effect::fog)) bytes += kFogBytes;
  if (effects.has(effect::blending)) bytes += std::uint64_t{instances} * kDrawOrderBytes;
  if (effects.any(effect::local_light)) bytes += kFrameLightsBytes + std::uint64_t{instances} * kInstanceShadingBytes;
  if (effects.any(effect::billboards | effect::outlines)) bytes += std::uint64_t{instances} * kTurnedInstanceBytes;
  if (effects.has(effect::environment)) bytes += kFrameReflectionsBytes + std::uint64_t{instances} * kEyeFormsBytes;
  if (effects.has(effect::outlines)) bytes = (bytes + 7) / 8 * 8 + kOutlinedSceneBytes;
  if (effects.has(effect::shadows)) bytes = (bytes + 7) / 8 * 8 + kShadowStateBytes;
  if (effects.has(effect::csg)) bytes = (bytes + 7) / 8 * 8 + kCsgStateBytes;
  if (effects.has(effect::edges)) bytes = (bytes + 7) / 8 * 8 + kEdgeStateBytes;
  return bytes == 0 ? 0 : bytes + kEffectHeaderBytes;
}

/// What effects keep, and the map of shadows or the operands of products behind it: without what strips take.
constexpr std::uint64_t effect_bytes(Effects effects, const SceneCounts& counts) {
  std::uint64_t bytes = effect_bytes(effects, counts.instances);
  if (effects.has(effect::shadows)) bytes = rounded_up(bytes) + counts.shadow_pool;
  if (effects.has(effect::csg)) bytes += std::uint64_t{counts.csg_operands} * kCsgOperandBytes;
  if (effects.has(effect::edges)) bytes = rounded_up(bytes) + std::uint64_t{counts.edge_groups} * kEdgeGroupBytes;
  return bytes;
}

/// Whether strips are drawn with an apron, a pixel more on each side that lies in the picture: edges that are blended
/// ask their neighbours.
constexpr bool has_apron(Effects effects, const SceneCounts& counts) {
  return effects.has(effect::edges) && counts.edge_groups != 0;
}
/// Pixels of the largest strip with its apron.
constexpr std::uint64_t cells_with_apron(std::uint32_t rows, std::uint32_t columns, const View& view) {
  const auto wider = [](std::uint64_t side, std::uint64_t whole) { return side + 2 < whole ? side + 2 : whole; };
  return wider(rows, view.height) * wider(columns, view.width);
}

/// Of a strip with so many cells of `cell_bytes`: two layers of depth, a count and a mark each.
constexpr std::uint64_t csg_strip_bytes(std::uint64_t cells, std::uint32_t cell_bytes) {
  return cells * (2 * cell_bytes + 2);
}

/// The z-buffer of a strip of the shadow map, one row of tiles, and one row of pixels that nobody sees: begin_frame
/// draws it where the picture's z-buffer will be.
constexpr std::uint32_t shadow_strip_bytes(const SceneCounts& counts) {
  return (kTileSide * kDepthBytes + kWorkingColourBytes) * counts.shadow_side;
}

/// RGB565 is drawn straight into the caller's pixels; the other formats pass through a working strip.
constexpr bool drawn_in_place(PixelFormat format) {
  return format == PixelFormat::rgb565 || format == PixelFormat::rgb565_swapped;
}

/// A strip with its apron as it is before any edge is blended, and, where the caller's pixels are no RGB565, the
/// strip's pixels after that.
constexpr std::uint64_t colour_bytes_of_edges(std::uint32_t rows, std::uint32_t columns, const View& view) {
  const std::uint64_t resolved = drawn_in_place(view.format) ? 0 : std::uint64_t{rows} * columns;
  return (cells_with_apron(rows, columns, view) + resolved) * kWorkingColourBytes;
}

/// Samples are not: pixels are their means.
constexpr bool drawn_in_place(const View& view) { return drawn_in_place(view.format) && view.samples == 1; }

/// What begin_frame compiles.
constexpr std::uint64_t instance_bytes(const SceneCounts& counts) {
  return std::uint64_t{counts.instances} * kInstanceBytes + std::uint64_t{counts.quadrics} * kQuadricBytes +
         std::uint64_t{counts.line_sets} * kLineSetBytes;
}

constexpr Purpose largest_purpose(const Plan& plan, const LayerBytes& layer = {},
                                  Purpose of_visibility = Purpose::sorting) {
  Purpose purpose = Purpose::instances;
  std::uint64_t most = plan.instance_bytes;
  const auto consider = [&](Purpose candidate, std::uint64_t bytes) {
    if (bytes > most) purpose = candidate, most = bytes;
  };
  consider(Purpose::extents, plan.extent_bytes);
  consider(Purpose::vertices, plan.vertex_bytes);
  consider(Purpose::depth, plan.depth_bytes);
  consider(Purpose::colour, plan.colour_bytes);
  consider(Purpose::bins, plan.bin_bytes);
  consider(Purpose::layer, layer.sum());
  consider(Purpose::effects, plan.effect_bytes);
  consider(of_visibility, plan.visibility_bytes);
  return purpose;
}
}  // namespace detail

constexpr SceneCounts count(const Scene& scene) {
  SceneCounts counts{.instances = static_cast<std::uint32_t>(scene.instances.size()),
                     .quadrics = static_cast<std::uint32_t>(scene.quadrics.size()),
                     .line_sets = static_cast<std::uint32_t>(scene.lines.size())};
  const auto raise = [](std::uint32_t& largest, std::uint32_t value) { largest = largest < value ? value : largest; };
  // No sum wraps: what needs more than 32 bits is refused everywhere, not mistaken for something small.
  const auto add = [](std::uint32_t& sum, std::uint64_t value) {
    const std::uint64_t wide = sum + value;
    sum = wide < 0xFFFFFFFF && value < 0xFFFFFFFF ? static_cast<std::uint32_t>(wide) : 0xFFFFFFFF;
  };
  const auto add_mesh = [&](const Mesh& mesh) {
    const auto vertices = static_cast<std::uint32_t>(mesh.positions.size());
    const auto triangles = static_cast<std::uint32_t>(mesh.triangles.size());
    add(counts.triangles, triangles);
    if (mesh.meshlets.empty()) {
      add(counts.vertices, vertices);
      add(counts.meshlets, 1);
      raise(counts.largest_meshlet, vertices);
      raise(counts.longest_meshlet, triangles);
    }
    add(counts.meshlets, mesh.meshlets.size());
    for (const Meshlet& meshlet : mesh.meshlets) {
      add(counts.vertices, meshlet.vertex_count);
      raise(counts.largest_meshlet, meshlet.vertex_count);
      raise(counts.longest_meshlet, meshlet.triangle_count);
    }
  };
  for (const Instance& instance : scene.instances) {
    std::uint32_t index = instance.mesh;
    for (const Outline* outline = nullptr; index < scene.meshes.size();) {
      add_mesh(scene.meshes[index]);
      if (outline != nullptr || (outline = outline_of(scene, scene.meshes[index])) == nullptr) break;
      index = hull_of(*outline, instance);
      add(counts.instances, 1);
    }
  }
  if (scene.shadow != nullptr && scene.shadow->log2_size <= kMostShadowLog2) {
    counts.shadow_side = 1U << scene.shadow->log2_size;
    counts.shadow_pool =
        scene.shadow->pool != 0 ? scene.shadow->pool : store_bytes_worst(counts.shadow_side, counts.shadow_side);
  }
  counts.csg_operands = static_cast<std::uint32_t>(scene.csg.size());
  counts.edge_groups = edge_groups(scene);
  return counts;
}

namespace detail {

/// All plans for one request; finds the best that fits and the smallest.
class Planner {
 public:
  constexpr Planner(const SceneCounts& counts, const View& view, Effects effects, const Budget& budget)
      : counts_(counts),
        view_(view),
        per_vertex_(bytes_per_vertex(effects)),
        per_cell_(depth_cell_bytes(effects)),
        effects_(effects),
        effect_bytes_(rounded_up(effect_bytes(effects, counts))),
        strip_buffers_(budget.strip_buffers),
        layer_(budget.layer),
        limit_(budget.bytes == 0 || budget.bytes > kLargestArena ? kLargestArena : budget.bytes) {}

  constexpr void consider_mode(Mode mode, const Budget& budget) {
    if (budget.strip_columns != 0) {
      consider_columns(mode, budget.strip_columns, budget.strip_rows);
      return;
    }
    consider_columns(mode, view_.width, budget.strip_rows);
    if (!budget.split_columns) return;
    for (std::uint32_t across = 2; across <= view_.width / kColumnStep; ++across) {
      const std::uint32_t columns = (view_.width + across * kColumnStep - 1) / (across * kColumnStep) * kColumnStep;
      consider_columns(mode, static_cast<std::uint16_t>(columns), budget.strip_rows);
    }
  }

  constexpr PlanResult result() const {
    if (best_.strips != 0) return {.status = {}, .plan = best_};
    if (smallest_.strips == 0) return {.status = {.error = Error::unplannable}, .plan = {}};
    const std::uint64_t needed = all_bytes(smallest_);
    return {.status = {.error = Error::arena_too_small,
                       .purpose = largest_purpose(smallest_, layer_, visibility_purpose(effects_)),
                       .needed = needed > kLargestArena ? kLargestArena : static_cast<std::uint32_t>(needed),
                       .available = limit_},
            .plan = smallest_};
  }

 private:
  constexpr void consider_columns(Mode mode, std::uint16_t columns, std::uint16_t fixed_rows) {
    if (fixed_rows != 0) {
      consider(with(mode, columns, fixed_rows));
      return;
    }
    const std::uint32_t most_down = kMostStrips / Plan{.strip_columns = columns}.columns_of_strips(view_);
    const Plan lowest = with(mode, columns, static_cast<std::uint16_t>((view_.height + most_down - 1) / most_down));
    consider(lowest);
    consider(with(mode, columns, view_.height));
    // From the fewest strips whose pixels could fit on, with evenly filled rows, to the first that does: more strips
    // of the same columns cost more time.
    const std::uint64_t fixed =
        std::uint64_t{lowest.instance_bytes} + lowest.vertex_bytes + effect_bytes_ + layer_.sum();
    if (fixed >= limit_) return;
    const std::uint64_t whole_depth = std::uint64_t{per_cell_} * view_.samples * columns * view_.height;
    const std::uint64_t at_least = whole_depth / (limit_ - fixed);
    for (std::uint64_t down = at_least > 2 ? at_least : 2; down < view_.height; ++down) {
      const Plan plan = with(mode, columns, static_cast<std::uint16_t>((view_.height + down - 1) / down));
      consider(plan);
      if (fits(plan)) return;
    }
  }

  constexpr Plan with(Mode mode, std::uint16_t columns, std::uint16_t rows) const {
    if (layer_.sum() != 0) rows = whole_tiles(rows, view_.height);
    Plan plan{.mode = mode, .strip_rows = rows, .strip_columns = columns};
    const std::uint32_t strips = plan.columns_of_strips(view_) * plan.rows_of_strips(view_);
    if (strips > kMostStrips) return {};
    plan.strips = static_cast<std::uint16_t>(strips);
    const std::uint64_t cells = std::uint64_t{rows} * columns * view_.samples;
    if (sorts_triangles(effects_) && counts_.longest_meshlet > kMostSortedIndex) return {};
    const std::uint64_t meshlets = counts_.meshlets > counts_.instances ? counts_.meshlets : counts_.instances;
    const bool binned = mode == Mode::binned;
    plan.instance_bytes = rounded_up(detail::instance_bytes(counts_));
    const bool shadows = effects_.has(effect::shadows);
    plan.extent_bytes = strips > 1 || binned || shadows ? rounded_up(meshlets * kExtentBytes) : 0;
    plan.vertex_bytes = rounded_up(binned ? std::uint64_t{counts_.vertices} * retained_bytes_per_vertex(effects_)
                                          : std::uint64_t{counts_.largest_meshlet} * per_vertex_);
    plan.depth_bytes = rounded_up(cells * per_cell_);
    if (shadows) plan.depth_bytes = std::max(plan.depth_bytes, shadow_strip_bytes(counts_));
    plan.visibility_bytes = rounded_up(
        visibility_bytes(effects_, counts_.triangles, columns * sample_columns(view_), rows * sample_rows(view_)));
    plan.colour_bytes = drawn_in_place(view_) ? 0 : rounded_up(cells * kWorkingColourBytes);
    if (has_apron(effects_, counts_)) {
      plan.depth_bytes = std::max(plan.depth_bytes, rounded_up(cells_with_apron(rows, columns, view_) * per_cell_));
      plan.colour_bytes = rounded_up(colour_bytes_of_edges(rows, columns, view_));
    }
    plan.effect_bytes = effect_bytes_;
    if (effects_.has(effect::csg)) {
      const std::uint64_t effect_bytes = effect_bytes_ + csg_strip_bytes(cells, per_cell_);
      if (effect_bytes > kLargestArena) return {};
      plan.effect_bytes = rounded_up(effect_bytes);
    }
    if (binned) {
      if (meshlets > kMostBatches || counts_.longest_meshlet > kMostBatches) return {};
      const Visits visits = visits_of(counts_, view_, plan);
      const std::uint64_t chunks = (visits.triangles + visits.meshlets) / kBinChunkEntries + strips;
      plan.bin_bytes = rounded_up(meshlets * kBatchBytes + strips * kBinBytes +
                                  (chunks < kMostBinChunks ? chunks : kMostBinChunks) * kBinChunkBytes);
    }
    return plan;
  }

  constexpr std::uint64_t all_bytes(const Plan& plan) const {
    return plan.wide_bytes() + std::uint64_t{strip_buffers_} * plan.strip_pixel_bytes(view_) + layer_.sum();
  }
  constexpr bool fits(const Plan& plan) const { return plan.strips != 0 && all_bytes(plan) <= limit_; }

  constexpr void consider(const Plan& plan) {
    if (plan.strips == 0) return;
    if (smallest_.strips == 0 || all_bytes(plan) < all_bytes(smallest_)) smallest_ = plan;
    if (!fits(plan)) return;
    const std::uint64_t cost = estimated_cost(counts_, view_, plan);
    if (best_.strips == 0 || cost < best_cost_ || (cost == best_cost_ && all_bytes(plan) < all_bytes(best_))) {
      best_ = plan;
      best_cost_ = cost;
    }
  }

  const SceneCounts& counts_;
  const View& view_;
  std::uint32_t per_vertex_, per_cell_;
  Effects effects_;
  std::uint32_t effect_bytes_, strip_buffers_;
  LayerBytes layer_;
  std::uint32_t limit_;
  Plan best_{}, smallest_{};
  std::uint64_t best_cost_ = 0;
};

}  // namespace detail

constexpr PlanResult plan(const SceneCounts& counts, const View& view, Effects effects, const Budget& budget) {
  if (view.width < 1 || view.height < 1 || view.width > kMaxViewSize || view.height > kMaxViewSize) {
    return {.status = {.error = Error::view_size}, .plan = {}};
  }
  if (!valid_samples(view)) return {.status = {.error = Error::samples, .needed = view.samples}, .plan = {}};
  if (samples_a_side(view) > kMaxViewSize) {
    return {.status = {.error = Error::view_size, .needed = samples_a_side(view), .available = kMaxViewSize},
            .plan = {}};
  }
  if (view.samples != 1 && !effects.has(effect::supersampled)) {
    return {.status = {.error = Error::effect_missing, .needed = low_bits(effect::supersampled)}, .plan = {}};
  }
  if (budget.strip_rows > view.height) {
    return {.status = {.error = Error::strip_rows, .needed = budget.strip_rows, .available = view.height}, .plan = {}};
  }
  if (budget.strip_columns > view.width ||
      (budget.strip_columns != view.width && budget.strip_columns % detail::kColumnStep != 0)) {
    return {.status = {.error = Error::strip_columns, .needed = budget.strip_columns, .available = view.width},
            .plan = {}};
  }
  if (!methods_agree(effects)) return {.status = {.error = Error::visibility, .needed = effects.methods}, .plan = {}};
  if (detail::has_apron(effects, counts) &&
      (budget.layer.sum() != 0 || view.samples != 1 || !depth_effects_agree(effects))) {
    return {.status = {.error = Error::edges}, .plan = {}};
  }
  if (budget.layer.sum() != 0) {
    if (effects.methods != 0) return {.status = {.error = Error::visibility, .needed = effects.methods}, .plan = {}};
    if (view.format != PixelFormat::rgb565) return {.status = {.error = Error::store_range}, .plan = {}};
    if (view.samples != 1) return {.status = {.error = Error::samples, .needed = view.samples}, .plan = {}};
    if (effects.has(effect::shadows)) return {.status = {.error = Error::shadow}, .plan = {}};
    if (depth_bytes(depth_format(effects)) != kDepthBytes || effects.has(effect::depth_ranges)) {
      return {.status = {.error = Error::depth_effects}, .plan = {}};
    }
    if (const std::uint16_t rows = detail::whole_tiles(budget.strip_rows, view.height); rows != budget.strip_rows) {
      return {.status = {.error = Error::strip_rows, .needed = budget.strip_rows, .available = rows}, .plan = {}};
    }
  }
  if (budget.modes == Modes::binned && !effects.has(effect::bins)) {
    return {.status = {.error = Error::effect_missing, .needed = low_bits(effect::bins)}, .plan = {}};
  }
  const bool can_bin = effects.has(effect::bins) && !effects.has(effect::depth_ranges);
  if (budget.modes == Modes::binned && !can_bin) return {.status = {.error = Error::depth_effects}, .plan = {}};
  detail::Planner planner(counts, view, effects, budget);
  if (budget.modes != Modes::binned) planner.consider_mode(Mode::streamed, budget);
  if (budget.modes != Modes::streamed && can_bin) planner.consider_mode(Mode::binned, budget);
  return planner.result();
}

}  // namespace zstrip
