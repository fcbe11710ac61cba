// Whole pictures with their z-buffer, in any depth format.
#pragma once

#include <algorithm>
#include <cstdint>
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
    {"w16", effect::depth_w16, false},
    {"z24", effect::depth_24, true},
    {"z32", effect::depth_32, true},
    {"ranges", effect::depth_ranges, true},
};

struct DepthPicture {
  Status status;
  std::vector<std::byte> pixels;
  std::vector<std::uint32_t> depth;  ///< a code for each pixel of the view; 0 is cleared
  Rect bounds;
  Statistics statistics;
};

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
    DepthPicture picture{planned.status, {}, {}, {}, {}};
    if (!picture.status) return picture;
    const std::size_t words = planned.plan.bytes() / 8 + 1;
    if (arena_.size() < words) arena_.resize(words, 0x0101010101010101ULL * garbage_);
    picture.status = renderer_.begin_frame(scene, camera, view_, planned.plan,
                                           std::as_writable_bytes(std::span(arena_)).first(planned.plan.bytes()));
    if (!picture.status) return picture;
    picture.bounds = renderer_.frame().bounds();
    picture.depth.resize(std::size_t{view_.width} * view_.height, 0);
    std::vector<std::uint64_t> strip(planned.plan.strip_pixel_bytes(view_) / 8 + 1, 0x0101010101010101ULL * garbage_);
    const auto bytes = std::as_writable_bytes(std::span(strip));
    for (std::uint16_t s = 0; s < planned.plan.strips; ++s) {
      for (int i = 0; i < times; ++i) {
        picture.status = renderer_.draw_strip(s, bytes);
        if (!picture.status) return picture;
      }
      const int rows = std::min<int>(planned.plan.strip_rows, view_.height - s * planned.plan.strip_rows);
      picture.pixels.insert(picture.pixels.end(), bytes.begin(),
                            bytes.begin() + rows * static_cast<int>(bytes_per_row(view_.width, view_.format)));
      read_depth(picture.depth);
    }
    picture.statistics = renderer_.frame().statistics();
    return picture;
  }

 private:
  void read_depth(std::vector<std::uint32_t>& depth) const {
    const FrameWithDepthRanges& frame = renderer_.frame();
    const Rect& area = frame.depth_area();
    const bool wide = depth_bytes(depth_format(effects_)) == 4;
    for (int y = area.top; y < area.bottom; ++y) {
      for (int x = area.left; x < area.right; ++x) {
        const int cell = (y - area.top) * area.width() + x - area.left;
        const std::uint32_t code = wide ? frame.wide_depth()[cell] : frame.depth()[cell];
        depth[static_cast<std::size_t>(y * view_.width + x)] =
            code > frame.cleared_code() ? code - frame.cleared_code() : 0;
      }
    }
  }

  Effects effects_;
  View view_;
  std::uint16_t strip_rows_;
  std::uint8_t garbage_;
  AnyRenderer renderer_;
  std::vector<std::uint64_t> arena_;
};

/// In the whole of one strip.
inline DepthPicture render_depth(const Scene& scene, const Camera& camera, const View& view, Effects more = {}) {
  return DepthRenderer(effects_of(scene, camera) | more, view, view.height).draw(scene, camera);
}

}  // namespace picture
