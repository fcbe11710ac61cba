// The bodies of plan.hpp.
#pragma once

#include "zstrip/plan/plan.hpp"

namespace zstrip {

/// Bytes of the renderer's own records; the stages that define them assert these sizes on every target.
inline constexpr std::uint32_t kInstanceBytes = 160;
inline constexpr std::uint32_t kVertexBytes = 8;         // snapped x, y and depth
inline constexpr std::uint32_t kVertexColourBytes = 4;   // only with lighting or vertex colours
inline constexpr std::uint32_t kDepthBytes = 2;          // a cell of the z-buffer, unless depth_bytes says 4
inline constexpr std::uint32_t kWorkingColourBytes = 2;  // RGB565

namespace detail {
constexpr std::uint32_t rounded_up(std::uint64_t bytes) {
  const std::uint64_t aligned = (bytes + kArenaAlignment - 1) / kArenaAlignment * kArenaAlignment;
  return aligned > 0xFFFFFFFF ? 0xFFFFFFF8 : static_cast<std::uint32_t>(aligned);
}

constexpr bool has_vertex_colours(Effects effects) { return effects.any(effect::lighting | effect::vertex_colours); }

/// RGB565 is drawn straight into the caller's pixels; the other formats pass through a working strip.
constexpr bool drawn_in_place(PixelFormat format) {
  return format == PixelFormat::rgb565 || format == PixelFormat::rgb565_swapped;
}

constexpr Purpose largest_purpose(const Plan& plan) {
  Purpose purpose = Purpose::instances;
  std::uint32_t most = plan.instance_bytes;
  const auto consider = [&](Purpose candidate, std::uint32_t bytes) {
    if (bytes > most) purpose = candidate, most = bytes;
  };
  consider(Purpose::vertices, plan.vertex_bytes);
  consider(Purpose::depth, plan.depth_bytes);
  consider(Purpose::colour, plan.colour_bytes);
  consider(Purpose::bins, plan.bin_bytes);
  return purpose;
}
}  // namespace detail

constexpr SceneCounts count(const Scene& scene) {
  SceneCounts counts{.instances = static_cast<std::uint32_t>(scene.instances.size())};
  for (const Instance& instance : scene.instances) {
    if (instance.mesh >= scene.meshes.size()) continue;
    const Mesh& mesh = scene.meshes[instance.mesh];
    const auto vertices = static_cast<std::uint32_t>(mesh.positions.size());
    counts.vertices += vertices;
    counts.triangles += static_cast<std::uint32_t>(mesh.triangles.size());
    std::uint32_t largest = mesh.meshlets.empty() ? vertices : 0;
    for (const Meshlet& meshlet : mesh.meshlets)
      largest = largest < meshlet.vertex_count ? meshlet.vertex_count : largest;
    counts.largest_meshlet = counts.largest_meshlet < largest ? largest : counts.largest_meshlet;
  }
  return counts;
}

constexpr PlanResult plan(const SceneCounts& counts, const View& view, Effects effects, const Budget& budget) {
  if (view.width < 1 || view.height < 1 || view.width > kMaxViewSize || view.height > kMaxViewSize) {
    return {.status = {.error = Error::view_size}, .plan = {}};
  }
  if (budget.strip_rows > view.height) {
    return {.status = {.error = Error::strip_rows, .needed = budget.strip_rows, .available = view.height}, .plan = {}};
  }
  const std::uint32_t per_vertex = kVertexBytes + (detail::has_vertex_colours(effects) ? kVertexColourBytes : 0);
  const std::uint32_t per_row_colour = detail::drawn_in_place(view.format) ? 0 : kWorkingColourBytes * view.width;
  const std::uint32_t per_row_depth = depth_bytes(depth_format(effects)) * view.width;

  const auto with_rows = [&](std::uint32_t rows) {
    Plan plan{.mode = Mode::streamed,
              .strip_rows = static_cast<std::uint16_t>(rows),
              .strips = static_cast<std::uint16_t>((view.height + rows - 1) / rows)};
    plan.instance_bytes = detail::rounded_up(std::uint64_t{counts.instances} * kInstanceBytes);
    plan.vertex_bytes = detail::rounded_up(std::uint64_t{counts.largest_meshlet} * per_vertex);
    plan.depth_bytes = detail::rounded_up(std::uint64_t{rows} * per_row_depth);
    plan.colour_bytes = detail::rounded_up(std::uint64_t{rows} * per_row_colour);
    return plan;
  };

  const Plan wanted = with_rows(budget.strip_rows != 0 ? budget.strip_rows : view.height);
  const std::uint32_t limit = budget.bytes == 0 || budget.bytes > kLargestArena ? kLargestArena : budget.bytes;
  if (wanted.wide_bytes() <= limit) return {.status = {}, .plan = wanted};
  if (budget.strip_rows == 0) {
    const Plan smallest = with_rows(1);
    if (smallest.wide_bytes() <= limit) {
      std::uint32_t rows = 1 + (limit - smallest.bytes()) / (per_row_colour + per_row_depth);
      rows = rows < view.height ? rows : view.height;
      while (with_rows(rows).wide_bytes() > limit) --rows;  // at most twice: alignment
      // The same number of strips with evenly filled rows needs less memory for the same time.
      const std::uint32_t strips = (view.height + rows - 1U) / rows;
      return {.status = {}, .plan = with_rows((view.height + strips - 1U) / strips)};
    }
    return {.status = {.error = Error::arena_too_small,
                       .purpose = detail::largest_purpose(smallest),
                       .needed = smallest.bytes(),
                       .available = limit},
            .plan = smallest};
  }
  return {.status = {.error = Error::arena_too_small,
                     .purpose = detail::largest_purpose(wanted),
                     .needed = wanted.bytes(),
                     .available = limit},
          .plan = wanted};
}

}  // namespace zstrip
