// The checks of requests that do not depend on effects.
#include "zstrip/state/checks.hpp"

#include <algorithm>
#include <utility>

#include "zstrip/camera.hpp"
#include "zstrip/resolve/convert.hpp"
#include "zstrip/resolve/resolve.hpp"
#include "zstrip/scene/validate.hpp"
#include "zstrip/visibility/traits.hpp"

namespace zstrip::detail {

Status check_request(const Scene& scene, const SceneCounts& counts, const Camera& camera, const View& view,
                     const Plan& plan, Effects called_for, Effects effects, std::span<std::byte> arena) {
  if (!valid_size_and_format(view)) return {.error = Error::view_size};
  if (plan.strip_rows < 1 || plan.strip_rows > view.height) {
    return {.error = Error::strip_rows, .needed = plan.strip_rows, .available = view.height};
  }
  if (plan.strip_columns < 1 || plan.strip_columns > view.width ||
      (plan.strip_columns != view.width && plan.strip_columns % kColumnStep != 0)) {
    return {.error = Error::strip_columns, .needed = plan.strip_columns, .available = view.width};
  }
  const std::uint32_t strips = plan.columns_of_strips(view) * plan.rows_of_strips(view);
  if (plan.strips != strips) return {.error = Error::strip_rows, .needed = strips, .available = plan.strips};
  if (!usable(camera)) return {.error = Error::camera};
  if (const Status status = validate_instances(scene); !status) return status;
  const bool binned = plan.mode == Mode::binned;
  if (binned) called_for = called_for | effect::bins;
  if (const Effects missing = missing_effects(called_for, effects); missing.bits != 0) return effects_missing(missing);
  // The plan must be for this scene: a smaller scene's plan would overrun its parts of the arena.
  if (plan.instance_bytes < instance_bytes(counts)) {
    return too_small(Purpose::instances, instance_bytes(counts), plan.instance_bytes);
  }
  if (const std::uint64_t extents = std::uint64_t{counts.meshlets} * kExtentBytes;
      (strips > 1 || binned) && plan.extent_bytes < extents) {
    return too_small(Purpose::extents, extents, plan.extent_bytes);
  }
  if (binned) {
    if (counts.meshlets > kMaxBatches || counts.longest_meshlet > kMaxListedTriangles) {
      return {.error = Error::unplannable};
    }
    const std::uint64_t lists = std::uint64_t{counts.meshlets} * kBatchBytes + std::uint64_t{strips} * kBinBytes;
    if (plan.bin_bytes < lists) return too_small(Purpose::bins, lists, plan.bin_bytes);
  }
  const std::uint64_t vertices =
      std::uint64_t{binned ? counts.vertices : counts.largest_meshlet} * coloured_bytes_per_vertex(called_for, counts);
  if (plan.vertex_bytes < vertices) return too_small(Purpose::vertices, vertices, plan.vertex_bytes);
  const std::uint64_t cells = std::uint64_t{plan.strip_rows} * plan.strip_columns;
  if (!methods::has_no_depth(effects) && plan.depth_bytes < cells * kDepthBytes)
    return too_small(Purpose::depth, cells * kDepthBytes, plan.depth_bytes);
  if (!drawn_in_place(view.format) && plan.colour_bytes < cells * kWorkingColourBytes) {
    return too_small(Purpose::colour, cells * kWorkingColourBytes, plan.colour_bytes);
  }
  for (const auto& [purpose, bytes] :
       {std::pair{Purpose::instances, plan.instance_bytes}, std::pair{Purpose::extents, plan.extent_bytes},
        std::pair{Purpose::vertices, plan.vertex_bytes}, std::pair{Purpose::depth, plan.depth_bytes},
        std::pair{Purpose::colour, plan.colour_bytes}, std::pair{Purpose::bins, plan.bin_bytes},
        std::pair{Purpose::effects, plan.effect_bytes},
        std::pair{visibility_purpose(effects), plan.visibility_bytes}}) {
    if (bytes % kArenaAlignment != 0) return too_small(purpose, rounded_up(bytes), bytes);
  }
  if (arena.size() < plan.wide_bytes() || reinterpret_cast<std::uintptr_t>(arena.data()) % kArenaAlignment != 0) {
    return too_small(largest_purpose(plan), plan.bytes(), static_cast<std::uint32_t>(arena.size()));
  }
  return {};
}

Status check_strip(const FrameState& frame, std::uint16_t strip, std::span<const std::byte> pixels) {
  if (const Status status = check_strip_number(frame, strip); !status) return status;
  return check_room(frame.plan.strip_area(strip, frame.view), frame.view.format, pixels);
}

Status check_area(const FrameState& frame, const Rect& area, std::size_t pixels, std::size_t depths) {
  if (area.empty() || area.left < 0 || area.top < 0 || area.right > frame.view.width ||
      area.bottom > frame.view.height) {
    return {.error = Error::view_size};
  }
  const auto cells = static_cast<std::uint32_t>(area.width() * area.height());
  if (pixels < cells || depths < cells) {
    return {.error = Error::pixels_too_small,
            .needed = 2 * cells,
            .available = static_cast<std::uint32_t>(2 * std::min(pixels, depths))};
  }
  return {};
}

Status refuse_samples(FrameState& frame) {
  abandon(frame);
  return effects_missing(effect::supersampled);
}

}  // namespace zstrip::detail
