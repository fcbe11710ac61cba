// The stages in their order: begin_frame prepares instances and bounds, draw_strip draws and resolves.
#pragma once

#include <cstddef>
#include <span>

#include "zstrip/effects/dithering/dither.hpp"
#include "zstrip/effects/edges/edge_stage.hpp"
#include "zstrip/effects/outlines/outline_stage.hpp"
#include "zstrip/effects/samples/sample_stage.hpp"
#include "zstrip/effects/shadows/shadow_stage.hpp"
#include "zstrip/frame/bounds.hpp"
#include "zstrip/frame/checks.hpp"
#include "zstrip/frame/effect_stage.hpp"
#include "zstrip/frame/method_stage.hpp"
#include "zstrip/frame/raster_stage.hpp"
#include "zstrip/resolve/convert.hpp"
#include "zstrip/resolve/resolve.hpp"
#include "zstrip/scene/validate.hpp"

namespace zstrip {

template <Effects effects>
Status Frame::Access::begin_frame(Frame& frame, const Scene& scene, const Camera& camera, const View& view,
                                  const Plan& plan, std::span<std::byte> arena) {
  return begin_facing<effects>(frame, scene, camera, camera, view, plan, arena);
}

template <Effects effects>
inline Status Frame::Access::begin_facing(Frame& frame, const Scene& scene, const Camera& camera,
                                          [[maybe_unused]] const Camera& facing, const View& view, const Plan& plan,
                                          std::span<std::byte> arena) {
  abandon(frame);
  const Effects called_for = effects_of(scene, camera);
  if (const Status status = Checks::frame<effects>(scene, camera, view, plan, called_for, arena); !status) {
    return status;
  }
  frame.view_ = view;
  frame.plan_ = plan;
  frame.mode_ = plan.mode;
  frame.has_special_depth_ = DepthStage::has_own_clear(effects);
  frame.statistics_ = {};
  lay_out_arena(frame, arena);
  if constexpr (effects.any(effect::billboards | effect::outlines | effect::shadows)) {
    Scene drawn = scene;
    if constexpr (effects.has(effect::billboards)) {
      if (called_for.has(effect::billboards)) {
        if (const Status status = turn_billboards(frame, drawn, facing, called_for); !status) return status;
      }
    }
    if constexpr (effects.has(effect::shadows)) {
      if (const Status status = Shadows::begin_frame<effects>(frame, scene, drawn, called_for); !status) return status;
    }
    if constexpr (effects.has(effect::outlines)) {
      if (called_for.has(effect::outlines)) add_hulls(frame, drawn, called_for);
    }
    const Status status = prepare_frame<effects>(frame, drawn, camera, view, called_for, arena);
    if (frame.scene_ == nullptr) return status;
    const Scene* kept = &scene;
    if constexpr (effects.has(effect::shadows)) {
      // Found by the number of instances, too.
      if (called_for.has(effect::shadows)) kept = &effect_block(frame).shadows().scene;
    }
    if constexpr (effects.has(effect::outlines)) {
      // Found by the number of instances, hulls among them, of the scene that the frame still has.
      if (called_for.has(effect::outlines)) kept = keep_outlined(frame);
    }
    frame.scene_ = kept;
    return status;
  } else {
    return prepare_frame<effects>(frame, scene, camera, view, called_for, arena);
  }
}

template <Effects effects>
Status Frame::Access::prepare_frame(Frame& frame, const Scene& scene, const Camera& camera, const View& view,
                                    Effects called_for, [[maybe_unused]] std::span<std::byte> arena) {
  if constexpr (effects.has(effect::depth_ranges)) DepthStage::begin_ranges(frame);
  detail::DistanceRange reach = detail::reach_of(scene, camera);
  if constexpr (effects.has(effect::quadrics)) detail::extend(reach, scene.quadrics, camera);
  if constexpr (effects.has(effect::lines)) detail::extend_by_lines(reach, scene, camera);
  if constexpr (effects.has(effect::outlines)) {
    if (called_for.has(effect::outlines))
      detail::extend_by_outlines(reach, effect_block(frame, scene).outlined(), camera, view);
  }
  const auto fit = [&] {
    if constexpr (effects.has(effect::coarse_reciprocal)) {
      return detail::with_room(detail::fit_to(reach, camera), detail::kRoomForCoarse);
    } else if constexpr (effects.has(effect::table_reciprocal)) {
      return detail::with_room(detail::fit_to(reach, camera), detail::kRoomForTable);
    } else {
      return detail::fit_to(reach, camera);
    }
  };
  if (const Status status = prepare(frame, scene, camera, view, fit()); !status) return status;
  if constexpr (effects.has(effect::outlines)) {
    if (called_for.has(effect::outlines)) prepare_outlines(frame, scene, camera);
  }
  if constexpr (effects.has(effect::lines)) {
    if (const Status status = prepare_lines(frame, scene, camera); !status) return status;
  }
  if constexpr (DepthStage::has_own_mapping(effects)) DepthStage::change_mapping<effects>(frame, scene);
  if constexpr (effects.has(effect::quadrics)) {
    if (const Status status = prepare_quadrics(frame, scene, camera); !status) return status;
  }
  divide(frame, scene, view);
  if constexpr (effects.has(effect::statistics)) frame.statistics_.triangles = count(scene).triangles;
  if constexpr (effects.methods != 0) {
    if (const Status status =
            Methods::begin_frame(static_cast<FrameWithMethod&>(frame), effects, called_for, count(scene), arena);
        !status) {
      return status;
    }
  }
  frame.scene_ = &scene;
  EffectStage::prepare<effects>(frame, camera, called_for);
  if constexpr (effects.has(effect::shadows)) {
    if (const Status status = Shadows::prepare<effects>(frame, camera, called_for); !status) {
      abandon(frame);
      return status;
    }
  }
  if constexpr (effects.has(effect::csg)) {
    if (called_for.has(effect::csg)) Csg::prepare<effects>(frame, camera);
  }
  if constexpr (effects.has(effect::edges)) {
    if (called_for.has(effect::edges)) Edges::survey<effects>(frame);
  }
  if constexpr (effects.has(method::culling | effect::statistics)) {
    Methods::count_culled<effects>(static_cast<FrameWithMethod&>(frame));
  }
  if constexpr (sorts_triangles(effects)) {
    return Methods::order_triangles<effects>(static_cast<FrameWithMethod&>(frame), camera);
  }
  if (frame.extents_ == nullptr) return {};
  if constexpr (effects.has(effect::bins)) {
    if (frame.mode_ == Mode::binned) {
      if (Geometry::fill_bins<effects>(frame)) return {};
      frame.mode_ = Mode::streamed;
      ++frame.bin_overflows_;
    }
  }
  Geometry::survey<effects>(frame);
  return {};
}

template <Effects effects>
Status Frame::Access::draw_strip(Frame& frame, std::uint16_t strip, std::span<std::byte> pixels) {
  constexpr bool kSupersampled = effects.has(effect::supersampled);
  if constexpr (kSupersampled) {
    if (const Status status = Samples::strip(frame, strip, pixels); !status) return status;
  } else {
    if (const Status status = Checks::strip(frame, strip, pixels); !status) return status;
  }
  bool has_edges = false;
  if constexpr (effects.has(effect::edges)) has_edges = Edges::called_for(frame);
  Rect area = frame.plan_.strip_area(strip, frame.view_);
  if (has_edges) area = Edges::with_apron(area, frame.view_);
  const auto width = static_cast<std::uint16_t>(area.width());
  const auto rows = static_cast<std::uint16_t>(area.height());
  const bool has_samples = kSupersampled && frame.view_.samples != 1;
  auto* const drawn = detail::drawn_in_place(frame.view_.format) && !has_samples && !has_edges
                          ? reinterpret_cast<std::uint16_t*>(pixels.data())
                          : frame.working_colour_;
  detail::StripTarget target = target_of(frame, area, drawn);
  if constexpr (DepthStage::has_own_clear(effects)) {
    detail::fill_pixels(drawn, std::uint32_t{rows} * width, detail::rgb565(frame.scene_->background));
    DepthStage::clear<effects>(frame, target);
  } else {
    clear(frame, width, rows, drawn, target);
  }
  if constexpr (effects.has(effect::dithered_colours | effect::fog)) {
    // Fog is dithered and ends in the background's colour: without a seam only if that is dithered, too.
    if (frame.scene_->fog != nullptr && dithers_colours(frame.view_)) {
      detail::fill_dithered(area, frame.scene_->background, drawn);
    }
  }
  if constexpr (effects.methods != 0) {
    Methods::begin_strip(static_cast<FrameWithMethod&>(frame), effects, target);
  }
  if (!target.area.empty()) Raster::draw_surfaces<effects>(frame, target, strip);
  if constexpr (effects.has(effect::shadows)) {
    if (const Status status = Shadows::draw<effects>(frame, target, strip); !status) return status;
  }
  if constexpr (kSupersampled) {
    if (has_samples) {
      Samples::resolve<effects>(frame, area, drawn, pixels.data());
      frame.next_to_last_strip_ = strip + 1U;
      return {};
    }
  }
  if constexpr (effects.has(effect::edges)) {
    if (has_edges) {
      Edges::resolve<effects>(frame, strip, area, target, pixels.data());
      frame.next_to_last_strip_ = strip + 1U;
      return {};
    }
  }
  if constexpr (effects.has(effect::dithered_format)) {
    if (frame.view_.dither) dither_pixels(frame.view_.format, area, drawn);
  }
  convert_pixels(frame.view_.format, width, rows, drawn, pixels.data());
  frame.next_to_last_strip_ = strip + 1U;
  return {};
}

template <Effects effects>
Status Frame::Access::draw_over(Frame& frame, const Rect& area, std::span<std::uint16_t> pixels,
                                std::span<std::uint16_t> depth) {
  if (const Status status = Checks::area<effects>(frame, area, pixels.size(), depth.size()); !status) return status;
  if constexpr (effects.methods == 0 && !DepthStage::has_own_clear(effects)) {
    Raster::draw_over<effects>(frame, area, pixels.data(), depth.data());
  }
  return {};
}

namespace detail {

template <Effects effects>
Status begin_frame(Frame& frame, const Scene& scene, const Camera& camera, const View& view, const Plan& plan,
                   std::span<std::byte> arena) {
  if constexpr (effects.has(effect::supersampled)) {
    if (view.samples != 1) {
      return Frame::Access::Samples::begin_frame<effects>(frame, scene, camera, view, plan, arena);
    }
  }
  return Frame::Access::begin_frame<effects>(frame, scene, camera, view, plan, arena);
}

template <Effects effects>
Status draw_strip(Frame& frame, std::uint16_t strip, std::span<std::byte> pixels) {
  return Frame::Access::draw_strip<effects>(frame, strip, pixels);
}

template <Effects effects>
Status draw_over(Frame& frame, const Rect& area, std::span<std::uint16_t> pixels, std::span<std::uint16_t> depth) {
  return Frame::Access::draw_over<effects>(frame, area, pixels, depth);
}

}  // namespace detail
}  // namespace zstrip
