// The parts of a frame that no effect changes.
#include <utility>

#include "zstrip/frame/frame_inline.hpp"
#include "zstrip/scene/camera.hpp"

namespace zstrip {

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
