// Runs the stages in order: begin_frame prepares, draw_strip draws and resolves. Effects take part through the hooks of
// their stages (effects/stage.hpp); this file names none.
#pragma once

#include <cstddef>
#include <span>

#include "zstrip/effects/stages.hpp"
#include "zstrip/resolve/convert.hpp"
#include "zstrip/stages/own_checks.hpp"
#include "zstrip/stages/raster_stage.hpp"

namespace zstrip::detail {

template <Effects effects>
Status check_frame(const FrameRequest& request, std::span<std::byte> arena) {
  if (const Status status = check_request(request.scene, request.counts, request.camera, request.view, request.plan,
                                          request.called_for, effects, arena);
      !status) {
    return status;
  }
  if (const Status status = check_own_request<effects>(request); !status) return status;
  return Stages::until_error<effects>([&](const auto& stage) { return stage.template check<effects>(request); });
}

/// `scene`: the scene to draw; its arena is laid out. `counts`: the counts of `scene`.
template <Effects effects>
Status prepare_frame(FrameState& frame, const Scene& scene, const SceneCounts& counts, const FrameRequest& request,
                     std::span<std::byte> arena) {
  DepthStage::begin<effects>(frame);
  DistanceRange reach = reach_of(scene, request.camera);
  Stages::for_each<effects>(
      [&](const auto& stage) { stage.template extend_reach<effects>(frame, scene, request, reach); });
  const DepthFit fit = fit_to(reach, request.camera);
  if (const Status status = prepare_instances<effects>(frame, scene, counts, request.camera, request.view, fit);
      !status) {
    return status;
  }
  if (const Status status = Stages::until_error<effects>(
          [&](const auto& stage) { return stage.template prepare_geometry<effects>(frame, scene, request); });
      !status) {
    return status;
  }
  DepthStage::change_mapping<effects>(frame, scene, [&](const DepthMapping& mapping) {
    Stages::for_each<effects>(
        [&](const auto& stage) { stage.template change_mapping<effects>(frame, scene, mapping); });
  });
  if (const Status status = Stages::until_error<effects>(
          [&](const auto& stage) { return stage.template prepare_surfaces<effects>(frame, scene, request); });
      !status) {
    return status;
  }
  divide(frame, counts, request.view);
  if (const Status status = MethodStage::begin<effects>(frame, request.called_for, scene, arena); !status)
    return status;
  frame.scene = &scene;
  if (const Status status = Stages::until_error<effects>(
          [&](const auto& stage) { return stage.template prepare<effects>(frame, request); });
      !status) {
    abandon(frame);
    return status;
  }
  return RasterStage::assign_to_strips<effects>(frame, request.camera);
}

template <Effects effects>
Status begin_checked_frame(FrameState& frame, const FrameRequest& request, [[maybe_unused]] const Camera& facing,
                           std::span<std::byte> arena) {
  start(frame, request.view, request.plan, arena);
  frame.has_special_depth = DepthStage::has_own_clear(effects);
  lay_out_effects<effects>(frame, request.scene, request.called_for);
  if constexpr (!Stages::any_changes_scene<effects>()) {
    return prepare_frame<effects>(frame, request.scene, request.counts, request, arena);
  } else {
    Scene drawn = request.scene;
    if (const Status status = Stages::until_error<effects>(
            [&](const auto& stage) { return stage.template change_scene<effects>(frame, drawn, request, facing); });
        !status) {
      return status;
    }
    const Status status = prepare_frame<effects>(frame, drawn, count(drawn), request, arena);
    // `drawn` is about to end, so the frame must not refer to it.
    const bool has_begun = frame.scene != nullptr;
    frame.scene = has_begun ? &request.scene : nullptr;
    if (has_begun) {
      Stages::for_each<effects>([&](const auto& stage) { stage.template keep_scene<effects>(frame, request); });
    }
    return status;
  }
}

template <Effects effects>
void draw_scene(FrameState& frame, const StripTarget& target, std::uint16_t strip) {
  Stages::for_each<effects>([&](const auto& stage) { stage.template draw_surfaces<effects>(frame, target, strip); });
  RasterStage::draw_triangles<effects>(frame, target, strip);
}

/// Not inlined into the only caller: GCC saves more registers around both than the call takes (0.8 KB of flash).
template <Effects effects>
[[gnu::noinline]] Status begin_whole_frame(FrameState& frame, const Scene& scene, const Camera& camera,
                                           const View& view, const Plan& plan, std::span<std::byte> arena) {
  abandon(frame);
  const FrameRequest request{scene, camera, view, plan, count(scene), effects_of(scene, camera)};
  if (const Status status = check_frame<effects>(request, arena); !status) return status;
  return begin_checked_frame<effects>(frame, request, camera, arena);
}

/// `pixels` has room for the strip. `convert` converts from RGB565 to the format of the view, as convert_pixels does.
template <Effects effects, class Convert>
Status draw_checked_strip(FrameState& frame, std::uint16_t strip, std::byte* pixels, const Convert& convert) {
  Rect area = frame.plan.strip_area(strip, frame.view);
  bool in_place = drawn_in_place(frame.view.format);
  Stages::for_each<effects>([&](const auto& stage) {
    area = stage.template drawn_area<effects>(frame, area);
    if (stage.template needs_working_strip<effects>(frame)) in_place = false;
  });
  StripImage image{area, in_place ? reinterpret_cast<std::uint16_t*>(pixels) : frame.working_colour, pixels, strip};
  StripTarget target = target_of(frame, area, image.pixels);
  DepthStage::clear<effects>(frame, target, area, image.pixels);
  Stages::for_each<effects>(
      [&](const auto& stage) { stage.template draw_background<effects>(frame, area, image.pixels); });
  MethodStage::begin_strip<effects>(frame, target);
  if (!target.area.empty()) draw_scene<effects>(frame, target, strip);
  if (const Status status = Stages::until_error<effects>(
          [&](const auto& stage) { return stage.template finish<effects>(frame, target, image); });
      !status) {
    return status;
  }
  Stages::for_each<effects>([&](const auto& stage) { stage.template resolve<effects>(frame, target, image); });
  convert(frame.view.format, static_cast<std::uint16_t>(image.area.width()),
          static_cast<std::uint16_t>(image.area.height()), image.pixels, image.out);
  frame.next_to_last_strip = strip + 1U;
  return {};
}

template <Effects effects>
Status draw_strip(FrameState& frame, std::uint16_t strip, std::span<std::byte> pixels) {
  if (const Status status = check_strip<effects>(frame, strip, pixels); !status) return status;
  // The lambda avoids a call through a function pointer, whose stack bound would be unknown.
  return draw_checked_strip<effects>(
      frame, strip, pixels.data(),
      [](PixelFormat format, std::uint16_t width, std::uint16_t rows, std::uint16_t* drawn, std::byte* out) {
        convert_pixels(format, width, rows, drawn, out);
      });
}

template <Effects effects>
Status draw_over(FrameState& frame, const Rect& area, std::span<std::uint16_t> pixels, std::span<std::uint16_t> depth) {
  if (frame.scene == nullptr) return {.error = Error::not_begun};
  if (const Status status =
          Stages::until_error<effects>([&](const auto& stage) { return stage.template check_over<effects>(frame); });
      !status) {
    return status;
  }
  if (const Status status = check_area<effects>(frame, area, pixels.size(), depth.size()); !status) return status;
  if constexpr (can_draw_over(effects)) {
    RasterStage::for_each_part(
        frame, area, pixels.data(), depth.data(),
        [&](const StripTarget& target, std::uint16_t strip) { draw_scene<effects>(frame, target, strip); });
  }
  return {};
}

}  // namespace zstrip::detail
