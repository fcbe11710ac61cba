// How tests draw a frame: begin_frame in memory that is full of garbage, then strip after strip into one picture.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include "zstrip/plan.hpp"
#include "zstrip/renderer.hpp"

namespace picture {

using namespace zstrip;

struct Picture {
  Status status;                  ///< of plan, begin_frame or the first strip that failed
  std::vector<std::byte> pixels;  ///< all rows without gaps; empty unless begin_frame succeeded
  Statistics statistics;
  Rect bounds;
};

/// What must not change a pixel.
struct Way {
  std::uint8_t garbage = 0xA5;      ///< what arena and strips hold beforehand
  bool last_strip_first = false;    ///< the order of the strips
  int times = 1;                    ///< how often each strip is drawn
  std::span<std::byte> arena = {};  ///< if empty, new memory
};

/// Memory of exactly this size, so that a sanitizer sees the first byte beyond it. It is aligned like any arena.
inline std::vector<std::byte> lent(std::size_t bytes, std::uint8_t garbage = 0xA5) {
  static_assert(kArenaAlignment <= __STDCPP_DEFAULT_NEW_ALIGNMENT__);
  return std::vector<std::byte>(bytes, std::byte{garbage});
}

/// Only begins a frame, with exactly the memory of `plan`: for what is refused.
template <class AnyKind>
Status begun(AnyKind&& renderer, const Scene& scene, const Camera& camera, const View& view, const Plan& plan) {
  std::vector<std::byte> arena = lent(plan.bytes());
  return renderer.begin_frame(scene, camera, view, plan, arena);
}

/// By a Renderer, an AnyRenderer or what checks one and has its functions. `after_strip` is called with the number of
/// each strip when it has been drawn, and with its pixels.
template <class AnyKind, class AfterStrip>
Picture draw(AnyKind& renderer, const Scene& scene, const Camera& camera, const View& view, const Plan& plan,
             const Way& way, AfterStrip&& after_strip) {
  std::vector<std::byte> own = lent(way.arena.empty() ? plan.bytes() : 0, way.garbage);
  Picture picture{};
  picture.status = renderer.begin_frame(scene, camera, view, plan, way.arena.empty() ? std::span(own) : way.arena);
  if (!picture.status) return picture;
  const std::size_t picture_row = bytes_per_row(view.width, view.format);
  picture.pixels.resize(picture_row * view.height);
  for (int i = 0; i < plan.strips; ++i) {
    const auto strip = static_cast<std::uint16_t>(way.last_strip_first ? plan.strips - 1 - i : i);
    const Rect area = plan.strip_area(strip, view);
    const std::size_t row = bytes_per_row(static_cast<std::uint16_t>(area.width()), view.format);
    std::vector<std::byte> pixels = lent(row * static_cast<std::size_t>(area.height()), way.garbage);
    for (int drawn = 0; picture.status && drawn < way.times; ++drawn) {
      picture.status = renderer.draw_strip(strip, pixels);
    }
    if (!picture.status) return picture;
    after_strip(strip, std::span<const std::byte>(pixels));
    std::byte* to = picture.pixels.data() + static_cast<std::size_t>(area.top) * picture_row +
                    bytes_per_row(static_cast<std::uint16_t>(area.left), view.format);
    for (std::size_t from = 0; from < pixels.size(); from += row, to += picture_row) {
      std::memcpy(to, pixels.data() + from, row);
    }
  }
  picture.statistics = renderer.frame().statistics();
  picture.bounds = renderer.frame().bounds();
  return picture;
}

template <class AnyKind>
Picture draw(AnyKind& renderer, const Scene& scene, const Camera& camera, const View& view, const Plan& plan,
             const Way& way = {}) {
  return draw(renderer, scene, camera, view, plan, way, [](std::uint16_t, std::span<const std::byte>) {});
}

/// Plans, and draws by the pipeline for `effects`.
inline Picture draw(Effects effects, const Scene& scene, const Camera& camera, const View& view,
                    const Budget& budget = {}, const Way& way = {}) {
  const PlanResult planned = plan(count(scene), view, effects, budget);
  if (!planned.status) return {planned.status, {}, {}, {}};
  AnyRenderer renderer(effects);
  return draw(renderer, scene, camera, view, planned.plan, way);
}

/// The pixels of a picture in RGB565.
inline std::vector<std::uint16_t> rgb565_of(const Picture& picture) {
  std::vector<std::uint16_t> pixels(picture.pixels.size() / 2);
  if (!pixels.empty()) std::memcpy(pixels.data(), picture.pixels.data(), 2 * pixels.size());
  return pixels;
}

}  // namespace picture
