// Finds the best plan: tries all plans that can be best, and keeps the cheapest that fits and the smallest.
#pragma once

#include <algorithm>

#include "zstrip/effects/exclusions.hpp"
#include "zstrip/effects/memory.hpp"
#include "zstrip/plan.hpp"
#include "zstrip/plan/estimate.hpp"
#include "zstrip/plan/record_bytes.hpp"
#include "zstrip/visibility/memory.hpp"

namespace zstrip {

namespace detail {

/// Tries all plans for one request; finds the best one that fits and the smallest one.
class Planner {
 public:
  constexpr Planner(const SceneCounts& counts, const View& view, Effects effects, const Budget& budget)
      : counts_(counts),
        view_(view),
        per_vertex_(bytes_per_vertex(effects, counts)),
        per_cell_(depth_cell_bytes(effects)),
        effects_(effects),
        effect_bytes_(rounded_up(MemoryOfEffects::bytes(effects, counts))),
        strip_buffers_(budget.strip_buffers),
        layer_(budget.layer),
        limit_(budget.bytes == 0 || budget.bytes > kMaxArena ? kMaxArena : budget.bytes) {}

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
    return {.status = {.error = Error::arena_too_small,
                       .purpose = largest_purpose(smallest_, layer_, visibility_purpose(effects_)),
                       .needed = smallest_bytes_ > kMaxArena ? kMaxArena : static_cast<std::uint32_t>(smallest_bytes_),
                       .available = limit_},
            .plan = smallest_};
  }

 private:
  constexpr void consider_columns(Mode mode, std::uint16_t columns, std::uint16_t fixed_rows) {
    if (fixed_rows != 0) {
      consider(with(mode, columns, fixed_rows));
      return;
    }
    const std::uint32_t most_down = kMaxStrips / Plan{.strip_columns = columns}.columns_of_strips(view_);
    const Plan lowest = with(mode, columns, static_cast<std::uint16_t>((view_.height + most_down - 1) / most_down));
    consider(lowest);
    consider(with(mode, columns, view_.height));
    // Tries rows from the fewest strips whose pixels could fit, with evenly filled strips, to the first plan that fits:
    // with the same columns, more strips cost more time.
    const std::uint64_t fixed =
        std::uint64_t{lowest.instance_bytes} + lowest.vertex_bytes + effect_bytes_ + layer_.sum();
    if (fixed >= limit_) return;
    const std::uint64_t whole_depth = std::uint64_t{per_cell_} * view_.samples * columns * view_.height;
    const std::uint64_t at_least = whole_depth / (limit_ - fixed);
    for (std::uint64_t down = at_least > 2 ? at_least : 2; down < view_.height; ++down) {
      if (consider(with(mode, columns, static_cast<std::uint16_t>((view_.height + down - 1) / down)))) return;
    }
  }

  constexpr Plan with(Mode mode, std::uint16_t columns, std::uint16_t rows) const {
    if (layer_.sum() != 0) rows = whole_tiles(rows, view_.height);
    Plan plan{.strip_rows = rows, .strip_columns = columns};
    const std::uint32_t strips = plan.columns_of_strips(view_) * plan.rows_of_strips(view_);
    if (strips > kMaxStrips) return {};
    plan.strips = static_cast<std::uint16_t>(strips);
    if (strips > 1) plan.mode = mode;  // a single strip needs no lists
    const std::uint64_t cells = std::uint64_t{rows} * columns * view_.samples;
    if (sorts_triangles(effects_) && counts_.longest_meshlet > kMaxSortedIndex) return {};
    const std::uint64_t meshlets = counts_.meshlets > counts_.instances ? counts_.meshlets : counts_.instances;
    const bool binned = plan.mode == Mode::binned;
    plan.instance_bytes = rounded_up(detail::instance_bytes(counts_));
    const bool shadows = effects_.has(effect::shadows);
    plan.extent_bytes = strips > 1 || binned || shadows ? rounded_up(meshlets * kExtentBytes) : 0;
    plan.vertex_bytes =
        rounded_up(binned ? std::uint64_t{counts_.vertices} * retained_bytes_per_vertex(effects_, counts_)
                          : std::uint64_t{counts_.largest_meshlet} * per_vertex_);
    plan.depth_bytes = rounded_up(cells * per_cell_);
    if (shadows) plan.depth_bytes = std::max(plan.depth_bytes, shadow_strip_bytes(counts_));
    plan.visibility_bytes = rounded_up(
        visibility_bytes(effects_, counts_.triangles, columns * sample_columns(view_), rows * sample_rows(view_)));
    plan.colour_bytes = drawn_in_place(view_) ? 0 : rounded_up(cells * kWorkingColourBytes);
    if (has_apron(effects_, counts_)) {
      plan.depth_bytes = std::max(plan.depth_bytes, rounded_up(cells_with_apron(rows, columns, view_) * per_cell_));
      const std::uint64_t saved = saves_codes(effects_) ? saved_bytes_of_edges(rows, columns, view_) : 0;
      plan.colour_bytes = rounded_up(colour_bytes_of_edges(rows, columns, view_) + saved);
    }
    plan.effect_bytes = effect_bytes_;
    if (effects_.has(effect::csg)) {
      const std::uint64_t effect_bytes = effect_bytes_ + csg_strip_bytes(cells, per_cell_);
      if (effect_bytes > kMaxArena) return {};
      plan.effect_bytes = rounded_up(effect_bytes);
    }
    if (binned) {
      if (meshlets > kMaxBatches || counts_.longest_meshlet > kMaxListedTriangles) return {};
      const std::uint64_t entries = facing_triangles(counts_, effects_, view_, plan, kFacingAtMost).visits() +
                                    facing_meshlets(counts_, effects_, view_, plan, kFacingAtMost).visits();
      const std::uint64_t chunks = entries / kBinChunkEntries + strips;
      plan.bin_bytes = rounded_up(meshlets * kBatchBytes + strips * kBinBytes +
                                  (chunks < kMaxBinChunks ? chunks : kMaxBinChunks) * kBinChunkBytes);
    }
    return plan;
  }

  constexpr std::uint64_t all_bytes(const Plan& plan) const {
    return plan.wide_bytes() + std::uint64_t{strip_buffers_} * plan.strip_pixel_bytes(view_) + layer_.sum();
  }

  /// Returns true if the plan fits. Not inlined, because that would make four copies.
  [[gnu::noinline]] constexpr bool consider(const Plan& plan) {
    if (plan.strips == 0) return false;
    const std::uint64_t bytes = all_bytes(plan);
    if (bytes < smallest_bytes_) {
      smallest_ = plan;
      smallest_bytes_ = bytes;
    }
    if (bytes > limit_) return false;
    const std::uint64_t cost = estimated_cost(counts_, effects_, view_, plan);
    if (cost < best_cost_ || (cost == best_cost_ && bytes < best_bytes_)) {
      best_ = plan;
      best_bytes_ = bytes;
      best_cost_ = cost;
    }
    return true;
  }

  const SceneCounts& counts_;
  const View& view_;
  std::uint32_t per_vertex_, per_cell_;
  Effects effects_;
  std::uint32_t effect_bytes_, strip_buffers_;
  LayerBytes layer_;
  std::uint32_t limit_;
  Plan best_{}, smallest_{};
  std::uint64_t best_bytes_ = 0, best_cost_ = UINT64_MAX, smallest_bytes_ = UINT64_MAX;
};

}  // namespace detail

constexpr PlanResult plan(const SceneCounts& counts, const View& view, Effects effects, const Budget& budget) {
  if (!valid_size_and_format(view)) return {.status = {.error = Error::view_size}, .plan = {}};
  if (!valid_samples(view)) return {.status = {.error = Error::samples, .needed = view.samples}, .plan = {}};
  if (samples_a_side(view) > kMaxViewSize) {
    return {.status = {.error = Error::view_size, .needed = samples_a_side(view), .available = kMaxViewSize},
            .plan = {}};
  }
  if (view.samples != 1 && !effects.has(effect::supersampled)) {
    return {.status = effects_missing(effect::supersampled), .plan = {}};
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
  constexpr Effects kWithoutEdges = detail::excluded_by(effect::edges);
  if (detail::has_apron(effects, counts) &&
      (budget.layer.sum() != 0 || view.samples != 1 || effects.any(kWithoutEdges))) {
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
    return {.status = effects_missing(effect::bins), .plan = {}};
  }
  const bool can_bin = effects.has(effect::bins) && !effects.has(effect::depth_ranges);
  if (budget.modes == Modes::binned && !can_bin) return {.status = {.error = Error::depth_effects}, .plan = {}};
  detail::Planner planner(counts, view, effects, budget);
  if (budget.modes != Modes::binned) planner.consider_mode(Mode::streamed, budget);
  if (budget.modes != Modes::streamed && can_bin) planner.consider_mode(Mode::binned, budget);
  return planner.result();
}

}  // namespace zstrip
