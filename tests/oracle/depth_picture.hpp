// Whole pictures with their z-buffer, in any depth format.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "picture.hpp"

namespace picture {

/// Every way to keep depth, with the effect that selects it.
struct DepthKind {
  const char* name;
  Effects effect;
  bool orthographic;  ///< whether it draws orthographic cameras
};
inline constexpr DepthKind kDepthKinds[] = {
    {"z16", {}, true},
    {"float", effect::depth_float, false},
    {"z24", effect::depth_24, true},
    {"ranges", effect::depth_ranges, true},
};

struct DepthPicture : Picture {
  std::vector<std::uint32_t> depth;  ///< a code for each pixel of the view; 0 is cleared
};

/// Puts the codes of the strip that was drawn last where its pixels are in a picture of this width.
inline void read_depth(FrameWithDepthRanges frame, Effects effects, int width, std::vector<std::uint32_t>& depth) {
  const Rect& area = frame.depth_area();
  const bool wide = depth_bytes(depth_format(effects)) == 4;
  for (int y = area.top; y < area.bottom; ++y) {
    for (int x = area.left; x < area.right; ++x) {
      const int cell = (y - area.top) * area.width() + x - area.left;
      const std::uint32_t code = wide ? frame.wide_depth()[cell] : frame.depth()[cell];
      depth[static_cast<std::size_t>(y * width + x)] = code > frame.cleared_code() ? code - frame.cleared_code() : 0;
    }
  }
}

/// As draw() does, with the depth of each strip.
template <class AnyKind>
DepthPicture draw_with_depth(AnyKind& renderer, Effects effects, const Scene& scene, const Camera& camera,
                             const View& view, const Plan& plan, const Way& way = {}) {
  std::vector<std::uint32_t> depth(std::size_t{view.width} * view.height, 0);
  const auto keep = [&](std::uint16_t, std::span<const std::byte>) {
    read_depth(renderer.frame(), effects, view.width, depth);
  };
  Picture picture = draw(renderer, scene, camera, view, plan, way, keep);
  return {std::move(picture), std::move(depth)};
}

/// An RGB565 pixel.
inline int pixel_of(const DepthPicture& picture, int x, int y, int width) {
  const auto at = static_cast<std::size_t>(2 * (y * width + x));
  return std::to_integer<int>(picture.pixels[at]) | std::to_integer<int>(picture.pixels[at + 1]) << 8;
}

/// One renderer with its arena, frame after frame.
class DepthRenderer {
 public:
  /// `garbage` fills arena and pixels at the start.
  DepthRenderer(Effects effects, const View& view, std::uint16_t strip_rows, std::uint8_t garbage = 0xA5)
      : effects_(effects), view_(view), strip_rows_(strip_rows), garbage_(garbage), renderer_(effects) {}

  void set_view(const View& view, std::uint16_t strip_rows) {
    view_ = view;
    strip_rows_ = strip_rows;
  }

  /// `times`: how often each strip is drawn.
  DepthPicture draw(const Scene& scene, const Camera& camera, int times = 1) {
    const PlanResult planned = plan(count(scene), view_, effects_, {.strip_rows = strip_rows_});
    if (!planned.status) return {{planned.status, {}, {}, {}}, {}};
    if (arena_.size() < planned.plan.bytes()) arena_.resize(planned.plan.bytes(), std::byte{garbage_});
    return draw_with_depth(
        renderer_, effects_, scene, camera, view_, planned.plan,
        {.garbage = garbage_, .times = times, .arena = std::span(arena_).first(planned.plan.bytes())});
  }

 private:
  Effects effects_;
  View view_;
  std::uint16_t strip_rows_;
  std::uint8_t garbage_;
  AnyRenderer renderer_;
  std::vector<std::byte> arena_;
};

/// In the whole of one strip.
inline DepthPicture render_depth(const Scene& scene, const Camera& camera, const View& view, Effects more = {}) {
  return DepthRenderer(effects_of(scene, camera) | more, view, view.height).draw(scene, camera);
}

}  // namespace picture
