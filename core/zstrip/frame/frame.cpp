// The parts of a frame that no effect changes.
#include "zstrip/frame/frame_inline.hpp"

#include <utility>

namespace zstrip {

Status Frame::Access::check(const Scene& scene, const Camera& camera, const View& view, const Plan& plan,
                            Effects missing, std::span<std::byte> arena) {
  if (view.width < 1 || view.height < 1 || view.width > kMaxViewSize || view.height > kMaxViewSize) {
    return {.error = Error::view_size};
  }
  if (plan.strip_rows < 1 || plan.strip_rows > view.height ||
      plan.strips != (view.height + plan.strip_rows - 1) / plan.strip_rows) {
    return {.error = Error::strip_rows, .needed = plan.strip_rows, .available = view.height};
  }
  if (camera.focal <= 0 || camera.near_plane <= 0 || camera.far_plane <= camera.near_plane)
    return {.error = Error::camera};
  const auto unit = [](const Vec3& axis) {
    constexpr std::int32_t kLargest = (std::int32_t{1} << 30) + 64;  // 2.30: rounding of a unit vector
    const auto fits = [](std::int32_t c) { return c >= -kLargest && c <= kLargest; };
    return fits(axis.x) && fits(axis.y) && fits(axis.z);
  };
  if (!unit(camera.right) || !unit(camera.up) || !unit(camera.back)) return {.error = Error::camera};
  if (const Status status = validate_instances(scene); !status) return status;
  if (missing.bits != 0) return {.error = Error::effect_missing, .needed = missing.bits};
  // The plan must be one for this scene: a smaller one would overrun its parts of the arena.
  const SceneCounts counts = count(scene);
  const auto too_small = [](Purpose purpose, std::uint64_t needed, std::uint32_t available) {
    return Status{.error = Error::arena_too_small,
                  .purpose = purpose,
                  .needed = static_cast<std::uint32_t>(needed),
                  .available = available};
  };
  if (plan.instance_bytes < std::uint64_t{counts.instances} * kInstanceBytes) {
    return too_small(Purpose::instances, std::uint64_t{counts.instances} * kInstanceBytes, plan.instance_bytes);
  }
  const bool colours = detail::has_vertex_colours(effects_of(scene, camera));
  const std::uint64_t vertices =
      std::uint64_t{counts.largest_meshlet} * (kVertexBytes + (colours ? kVertexColourBytes : 0));
  if (plan.vertex_bytes < vertices) return too_small(Purpose::vertices, vertices, plan.vertex_bytes);
  const std::uint64_t cells = std::uint64_t{plan.strip_rows} * view.width;
  if (plan.depth_bytes < cells * kDepthBytes) return too_small(Purpose::depth, cells * kDepthBytes, plan.depth_bytes);
  if (!detail::drawn_in_place(view.format) && plan.colour_bytes < cells * kWorkingColourBytes) {
    return too_small(Purpose::colour, cells * kWorkingColourBytes, plan.colour_bytes);
  }
  for (const auto& [purpose, bytes] :
       {std::pair{Purpose::instances, plan.instance_bytes}, std::pair{Purpose::vertices, plan.vertex_bytes},
        std::pair{Purpose::depth, plan.depth_bytes}, std::pair{Purpose::colour, plan.colour_bytes},
        std::pair{Purpose::bins, plan.bin_bytes}}) {
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
  std::byte* const vertices = take(frame.plan_.vertex_bytes);
  frame.vertices_ = reinterpret_cast<detail::SnappedVertex*>(vertices);
  frame.depth_ = reinterpret_cast<std::uint16_t*>(take(frame.plan_.depth_bytes));
  frame.working_colour_ = reinterpret_cast<std::uint16_t*>(take(frame.plan_.colour_bytes));
}

Status Frame::Access::prepare(Frame& frame, const Scene& scene, const Camera& camera, const View& view) {
  const bool orthographic = camera.projection == Projection::orthographic;
  const SceneCounts counts = count(scene);
  frame.colours_ = reinterpret_cast<Colour*>(frame.vertices_ + counts.largest_meshlet);
  frame.bounds_ = {};
  frame.depth_area_ = {};
  frame.fit_ = detail::fit_to_scene(scene, camera);
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
    const Rect& all = frame.bounds_;
    frame.bounds_ = all.empty() ? box
                                : Rect{std::min(all.left, box.left), std::min(all.top, box.top),
                                       std::max(all.right, box.right), std::max(all.bottom, box.bottom)};
  }
  return {};
}

detail::StripTarget Frame::Access::target_of(Frame& frame, std::uint16_t strip, std::uint16_t* pixels) {
  const std::int32_t top = strip * frame.plan_.strip_rows;
  const std::int32_t bottom = std::min<std::int32_t>(top + frame.plan_.strip_rows, frame.view_.height);
  const Rect& bounds = frame.bounds_;
  Rect area{bounds.left, std::max(bounds.top, top), bounds.right, std::min(bounds.bottom, bottom)};
  if (area.empty()) area = {};
  frame.depth_area_ = area;
  const std::int32_t centre_x = frame.view_.width >> 1;
  const std::int32_t centre_y = frame.view_.height >> 1;
  const std::int32_t first_pixel = area.empty() ? 0 : (area.top - top) * frame.view_.width + area.left;
  return {.area = {area.left - centre_x, area.top - centre_y, area.right - centre_x, area.bottom - centre_y},
          .view_left = -centre_x,
          .view_top = -centre_y,
          .first_row = bounds.top - centre_y,
          .depth = frame.depth_,
          .colour = pixels + first_pixel,
          .depth_stride = area.width(),
          .colour_stride = frame.view_.width,
          .statistics = &frame.statistics_};
}

void Frame::Access::clear(const Frame& frame, std::uint16_t rows, std::uint16_t* pixels,
                          const detail::StripTarget& target) {
  __builtin_memset(frame.depth_, 0, static_cast<std::size_t>(target.area.width() * target.area.height()) * kDepthBytes);
  detail::fill_pixels(pixels, std::uint32_t{rows} * frame.view_.width, detail::rgb565(frame.scene_->background));
}

void Frame::Access::resolve(const Frame& frame, std::uint16_t rows, std::uint16_t* drawn, std::byte* pixels) {
  const View& view = frame.view_;
  if (view.format == PixelFormat::rgb565) return;
  if (view.format == PixelFormat::rgb565_swapped) {
    detail::swap_bytes(drawn, std::uint32_t{rows} * view.width);
    return;
  }
  for (std::uint32_t y = 0; y < rows; ++y) {
    const std::uint16_t* const row = drawn + y * view.width;
    std::byte* const out = pixels + y * bytes_per_row(view.width, view.format);
    if (view.format == PixelFormat::gray4) {
      detail::resolve_gray4(row, view.width, out);
    } else {
      detail::resolve_mono(row, view.width, out);
    }
  }
}

}  // namespace zstrip
