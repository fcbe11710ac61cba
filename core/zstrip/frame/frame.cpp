// The parts of a frame that no effect changes.
#include <utility>

#include "zstrip/frame/frame_inline.hpp"
#include "zstrip/scene/camera.hpp"

namespace zstrip {

Status Frame::Access::check(const Scene& scene, const Camera& camera, const View& view, const Plan& plan,
                            Effects called_for, Effects effects, std::span<std::byte> arena) {
  if (view.width < 1 || view.height < 1 || view.width > kMaxViewSize || view.height > kMaxViewSize) {
    return {.error = Error::view_size};
  }
  if (plan.strip_rows < 1 || plan.strip_rows > view.height) {
    return {.error = Error::strip_rows, .needed = plan.strip_rows, .available = view.height};
  }
  if (plan.strip_columns < 1 || plan.strip_columns > view.width ||
      (plan.strip_columns != view.width && plan.strip_columns % detail::kColumnStep != 0)) {
    return {.error = Error::strip_columns, .needed = plan.strip_columns, .available = view.width};
  }
  const std::uint32_t strips = plan.columns_of_strips(view) * plan.rows_of_strips(view);
  if (plan.strips != strips) return {.error = Error::strip_rows, .needed = strips, .available = plan.strips};
  if (!usable(camera)) return {.error = Error::camera};
  if (const Status status = validate_instances(scene); !status) return status;
  if (const Effects missing = without(called_for, effects); missing.bits != 0)
    return {.error = Error::effect_missing, .needed = low_bits(missing)};
  // The plan must be one for this scene: a smaller one would overrun its parts of the arena.
  const SceneCounts counts = count(scene);
  const auto too_small = [](Purpose purpose, std::uint64_t needed, std::uint32_t available) {
    return Status{.error = Error::arena_too_small,
                  .purpose = purpose,
                  .needed = static_cast<std::uint32_t>(needed),
                  .available = available};
  };
  if (plan.instance_bytes < detail::instance_bytes(counts)) {
    return too_small(Purpose::instances, detail::instance_bytes(counts), plan.instance_bytes);
  }
  const bool colours = detail::has_vertex_colours(called_for);
  const bool binned = plan.mode == Mode::binned;
  if (const std::uint64_t extents = std::uint64_t{counts.meshlets} * kExtentBytes;
      (strips > 1 || binned) && plan.extent_bytes < extents) {
    return too_small(Purpose::extents, extents, plan.extent_bytes);
  }
  if (binned) {
    if (counts.meshlets > kMostBatches || counts.longest_meshlet > kMostBatches) return {.error = Error::unplannable};
    const std::uint64_t lists = std::uint64_t{counts.meshlets} * kBatchBytes + std::uint64_t{strips} * kBinBytes;
    if (plan.bin_bytes < lists) return too_small(Purpose::bins, lists, plan.bin_bytes);
  }
  const std::uint64_t vertices = std::uint64_t{binned ? counts.vertices : counts.largest_meshlet} *
                                 (kVertexBytes + (colours ? kVertexColourBytes : 0));
  if (plan.vertex_bytes < vertices) return too_small(Purpose::vertices, vertices, plan.vertex_bytes);
  const std::uint64_t cells = std::uint64_t{plan.strip_rows} * plan.strip_columns;
  if (!effects.has(method::painter) && plan.depth_bytes < cells * kDepthBytes)
    return too_small(Purpose::depth, cells * kDepthBytes, plan.depth_bytes);
  if (!detail::drawn_in_place(view.format) && plan.colour_bytes < cells * kWorkingColourBytes) {
    return too_small(Purpose::colour, cells * kWorkingColourBytes, plan.colour_bytes);
  }
  for (const auto& [purpose, bytes] :
       {std::pair{Purpose::instances, plan.instance_bytes}, std::pair{Purpose::extents, plan.extent_bytes},
        std::pair{Purpose::vertices, plan.vertex_bytes}, std::pair{Purpose::depth, plan.depth_bytes},
        std::pair{Purpose::colour, plan.colour_bytes}, std::pair{Purpose::bins, plan.bin_bytes},
        std::pair{Purpose::effects, plan.effect_bytes},
        std::pair{detail::visibility_purpose(effects), plan.visibility_bytes}}) {
    if (bytes % kArenaAlignment != 0) return too_small(purpose, detail::rounded_up(bytes), bytes);
  }
  if (arena.size() < plan.wide_bytes() || reinterpret_cast<std::uintptr_t>(arena.data()) % kArenaAlignment != 0) {
    return too_small(detail::largest_purpose(plan), plan.bytes(), static_cast<std::uint32_t>(arena.size()));
  }
  return {};
}

void Frame::Access::lay_out_arena(Frame& frame, std::span<std::byte> arena) {
  std::byte* next = arena.data();
  const auto take = [&next](std::uint32_t bytes) {
    std::byte* const part = next;
    next += bytes;
    return part;
  };
  frame.instances_ = reinterpret_cast<detail::CompiledInstance*>(take(frame.plan_.instance_bytes));
  std::byte* const extents = take(frame.plan_.extent_bytes);
  const bool surveyed = frame.plan_.strips > 1 || frame.plan_.mode == Mode::binned;
  frame.extents_ = surveyed ? reinterpret_cast<detail::Extent*>(extents) : nullptr;
  frame.vertices_ = reinterpret_cast<detail::SnappedVertex*>(take(frame.plan_.vertex_bytes));
  frame.depth_ = reinterpret_cast<std::uint16_t*>(take(frame.plan_.depth_bytes));
  frame.working_colour_ = reinterpret_cast<std::uint16_t*>(take(frame.plan_.colour_bytes));
  frame.batches_ = reinterpret_cast<detail::RetainedBatch*>(take(frame.plan_.bin_bytes));
}

Status Frame::Access::begin_method(FrameWithMethod& frame, Effects effects, const SceneCounts& counts,
                                   std::span<std::byte> arena) {
  const Plan& plan = frame.plan_;
  const std::uint64_t needed = detail::visibility_bytes(effects, counts.triangles, plan.strip_columns, plan.strip_rows);
  if (plan.visibility_bytes < needed) {
    return {.error = Error::arena_too_small,
            .purpose = detail::visibility_purpose(effects),
            .needed = static_cast<std::uint32_t>(needed),
            .available = plan.visibility_bytes};
  }
  if (sorts_triangles(effects) && (counts.longest_meshlet > kMostSortedIndex || counts.meshlets > kMostSortedIndex ||
                                   counts.instances > kMostSortedIndex)) {
    return {.error = Error::unplannable};
  }
  std::byte* const memory = arena.data() + (plan.bytes() - plan.visibility_bytes);
  const std::uint32_t sorted = sorts_triangles(effects) ? counts.triangles * kSortedTriangleBytes : 0;
  frame.sorted_ = reinterpret_cast<detail::SortedTriangle*>(memory);
  frame.sorted_count_ = 0;
  frame.depth_bounds_ = memory + sorted;
  frame.counts_ = {};
  frame.state_ = {};
  frame.state_.counts = effects.has(effect::statistics) ? &frame.counts_ : nullptr;
  frame.state_.iterations = std::min(frame.options_.iterations, kMostIterations);
  frame.state_.cull_small = frame.options_.cull_small;
  if (effects.has(method::culling) && !frame.options_.cull_back_faces) {
    for (std::uint32_t i = 0; i < counts.instances; ++i) frame.instances_[i].double_sided = true;
  }
  return {};
}

void Frame::Access::begin_strip_of_method(FrameWithMethod& frame, Effects effects, detail::StripTarget& target) {
  // Without depth memory the pixel's own address says which one it is; nothing is read or written through it.
  if (effects.has(method::painter)) target.depth = target.colour;
  const auto cells = static_cast<std::uint32_t>(target.area.width() * target.area.height());
  frame.state_.first_cell = target.depth;
  frame.state_.overdraw = effects.has(effect::statistics) ? frame.options_.overdraw : nullptr;
  if (frame.state_.overdraw != nullptr) __builtin_memset(frame.state_.overdraw, 0, cells);
  if (effects.any(method::bounded) && cells != 0)
    frame.state_.bounds.begin(frame.depth_bounds_, target.area, target.depth);
}

Status Frame::Access::prepare(Frame& frame, const Scene& scene, const Camera& camera, const View& view,
                              const DepthFit& fit) {
  const bool orthographic = camera.projection == Projection::orthographic;
  const SceneCounts counts = count(scene);
  const bool binned = frame.plan_.mode == Mode::binned;
  frame.colours_ = reinterpret_cast<Colour*>(frame.vertices_ + (binned ? counts.vertices : counts.largest_meshlet));
  frame.bounds_ = {};
  frame.depth_area_ = {};
  frame.fit_ = fit;
  frame.origin_ = detail::raster_origin(view, frame.fit_, orthographic);
  const bool nothing = frame.fit_.near == 0;
  for (std::uint32_t i = 0; i < counts.instances; ++i) {
    detail::CompiledInstance& instance = frame.instances_[i];
    if (nothing) {
      instance.visible = false;
      continue;
    }
    if (const Status status = detail::compile_instance(instance, scene, scene.instances[i], camera, view, frame.fit_);
        !status) {
      return {.error = status.error, .needed = i};
    }
    if (!instance.visible) continue;
    const Rect box = detail::bounds_of(instance, frame.origin_, view, orthographic);
    if (box.empty()) {
      instance.visible = false;
      continue;
    }
    extend_bounds(frame, box);
  }
  return {};
}

void Frame::Access::extend_bounds(Frame& frame, const Rect& box) {
  const Rect& all = frame.bounds_;
  frame.bounds_ = all.empty() ? box
                              : Rect{std::min(all.left, box.left), std::min(all.top, box.top),
                                     std::max(all.right, box.right), std::max(all.bottom, box.bottom)};
}

void Frame::Access::divide(Frame& frame, const Scene& scene, const View& view) {
  frame.grid_ = detail::StripGrid(frame.plan_, view, frame.bounds_);
  if (frame.plan_.mode == Mode::binned) {
    const SceneCounts counts = count(scene);
    const std::uint32_t batch_bytes = counts.meshlets * kBatchBytes;
    frame.bins_ = detail::Bins(reinterpret_cast<std::byte*>(frame.batches_) + batch_bytes,
                               frame.plan_.bin_bytes - batch_bytes, frame.plan_.strips);
  }
}

detail::StripTarget Frame::Access::target_of(Frame& frame, const Rect& strip, std::uint16_t* pixels) {
  const Rect& bounds = frame.bounds_;
  Rect area{std::max(bounds.left, strip.left), std::max(bounds.top, strip.top), std::min(bounds.right, strip.right),
            std::min(bounds.bottom, strip.bottom)};
  if (area.empty()) area = {};
  frame.depth_area_ = area;
  const std::int32_t first_pixel = area.empty() ? 0 : (area.top - strip.top) * strip.width() + (area.left - strip.left);
  detail::StripTarget target = target_at(frame, area);
  target.depth = frame.depth_;
  target.depth_stride = area.width();
  target.colour = pixels + first_pixel;
  target.colour_stride = strip.width();
  return target;
}

detail::StripTarget Frame::Access::target_at(Frame& frame, const Rect& area) {
  const std::int32_t centre_x = frame.view_.width >> 1;
  const std::int32_t centre_y = frame.view_.height >> 1;
  return {.area = {area.left - centre_x, area.top - centre_y, area.right - centre_x, area.bottom - centre_y},
          .view_left = -centre_x,
          .view_top = -centre_y,
          .first_column = frame.bounds_.left - centre_x,
          .first_row = frame.bounds_.top - centre_y,
          .depth = nullptr,
          .colour = nullptr,
          .depth_stride = 0,
          .colour_stride = 0,
          .statistics = &frame.statistics_};
}

void Frame::Access::clear(const Frame& frame, std::uint16_t width, std::uint16_t rows, std::uint16_t* pixels,
                          const detail::StripTarget& target) {
  __builtin_memset(frame.depth_, 0, static_cast<std::size_t>(target.area.width() * target.area.height()) * kDepthBytes);
  detail::fill_pixels(pixels, std::uint32_t{rows} * width, detail::rgb565(frame.scene_->background));
}

}  // namespace zstrip
