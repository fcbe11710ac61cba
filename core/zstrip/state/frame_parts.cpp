// The parts of a frame that do not depend on effects.
#include "zstrip/state/frame_parts.hpp"

#include <algorithm>

#include "zstrip/camera.hpp"
#include "zstrip/pixels/colour.hpp"
#include "zstrip/resolve/resolve.hpp"
#include "zstrip/state/bounds.hpp"

namespace zstrip::detail {

void lay_out_arena(FrameState& frame, std::span<std::byte> arena) {
  std::byte* next = arena.data();
  const auto take = [&next](std::uint32_t bytes) {
    std::byte* const part = next;
    next += bytes;
    return part;
  };
  frame.instances = reinterpret_cast<CompiledInstance*>(take(frame.plan.instance_bytes));
  std::byte* const extents = take(frame.plan.extent_bytes);
  const bool surveyed = frame.plan.strips > 1 || frame.plan.mode == Mode::binned;
  frame.extents = surveyed ? reinterpret_cast<Extent*>(extents) : nullptr;
  frame.vertices = reinterpret_cast<SnappedVertex*>(take(frame.plan.vertex_bytes));
  frame.depth = reinterpret_cast<std::uint16_t*>(take(frame.plan.depth_bytes));
  frame.working_colour = reinterpret_cast<std::uint16_t*>(take(frame.plan.colour_bytes));
  frame.batches = reinterpret_cast<RetainedBatch*>(take(frame.plan.bin_bytes));
}

void begin_instances(FrameState& frame, const SceneCounts& counts, const Camera& camera, const View& view,
                     const DepthFit& fit) {
  const bool binned = frame.plan.mode == Mode::binned;
  frame.colours = reinterpret_cast<Colour*>(frame.vertices + (binned ? counts.vertices : counts.largest_meshlet));
  frame.bounds = {};
  frame.depth_area = {};
  frame.fit = fit;
  frame.origin = raster_origin(view, frame.fit, camera.projection == Projection::orthographic);
}

void bound_instance(FrameState& frame, CompiledInstance& instance, const Camera& camera, const View& view) {
  if (!instance.visible) return;
  const Rect box = bounds_of(instance, frame.origin, view, camera.projection == Projection::orthographic);
  if (box.empty()) {
    instance.visible = false;
  } else {
    extend_bounds(frame, box);
  }
}

void extend_bounds(FrameState& frame, const Rect& box) {
  const Rect& all = frame.bounds;
  frame.bounds = all.empty() ? box
                             : Rect{std::min(all.left, box.left), std::min(all.top, box.top),
                                    std::max(all.right, box.right), std::max(all.bottom, box.bottom)};
}

void divide(FrameState& frame, const SceneCounts& counts, const View& view) {
  frame.grid = StripGrid(frame.plan, view, frame.bounds);
  if (frame.plan.mode == Mode::binned) {
    const std::uint32_t batch_bytes = counts.meshlets * kBatchBytes;
    frame.bins = Bins(reinterpret_cast<std::byte*>(frame.batches) + batch_bytes, frame.plan.bin_bytes - batch_bytes,
                      frame.plan.strips);
  }
}

StripTarget target_of(FrameState& frame, Rect strip, std::uint16_t* pixels) {
  Rect area = frame.bounds.cut_to(strip);
  if (area.empty()) area = {};
  frame.depth_area = area;
  const std::int32_t first_pixel = area.empty() ? 0 : (area.top - strip.top) * strip.width() + (area.left - strip.left);
  StripTarget target = target_at(frame, area);
  target.depth = frame.depth;
  target.depth_stride = area.width();
  target.colour = pixels + first_pixel;
  target.colour_stride = strip.width();
  return target;
}

StripTarget target_at(FrameState& frame, const Rect& area) {
  const std::int32_t centre_x = frame.view.width >> 1;
  const std::int32_t centre_y = frame.view.height >> 1;
  return {.area = {area.left - centre_x, area.top - centre_y, area.right - centre_x, area.bottom - centre_y},
          .view_left = -centre_x,
          .view_top = -centre_y,
          .first_column = frame.bounds.left - centre_x,
          .first_row = frame.bounds.top - centre_y,
          .depth = nullptr,
          .colour = nullptr,
          .depth_stride = 0,
          .colour_stride = 0,
          .statistics = &frame.statistics};
}

void clear(const FrameState& frame, std::uint16_t width, std::uint16_t rows, std::uint16_t* pixels,
           const StripTarget& target) {
  __builtin_memset(frame.depth, 0, static_cast<std::size_t>(target.area.width() * target.area.height()) * kDepthBytes);
  fill_pixels(pixels, std::uint32_t{rows} * width, rgb565(frame.scene->background));
}

}  // namespace zstrip::detail
