// Chooses the depth format of a picture; see depth_advice.hpp.
#include "plan/depth_advice.hpp"

#include <algorithm>
#include <cmath>

namespace zstrip::sim {
namespace {

constexpr double kUnit = 4294967296.0;  // 1 in 32.32

/// Returns the width of a pixel at `distance`, in view units.
double pixel_at(double distance, const Camera& camera, const View& view) {
  const double at_one = 2.0 / (camera.focal / double{kFixedOne} * view.height);
  return camera.projection == Projection::orthographic ? at_one : at_one * distance;
}

}  // namespace

DepthAdvice advise_depth(const KeptFrames& kept, const Camera& camera, const View& view,
                         std::optional<double> separation) {
  const DepthRange& range = kept.codes;
  DepthAdvice advice{
      .nearest = kept.nearest / double{kFixedOne}, .farthest = kept.farthest / double{kFixedOne}, .formats = {}};
  advice.needed = separation ? *separation : pixel_at(advice.farthest, camera, view);
  for (const DepthFormat format : {DepthFormat::z16, DepthFormat::float16, DepthFormat::z24}) {
    if (!available(format, range.projection)) continue;
    const auto at = [&](Fixed distance) {
      return static_cast<double>(depth_separation(format, range, distance)) / kUnit;
    };
    advice.formats.push_back({format, at(kept.nearest), at(kept.farthest)});
  }
  const DepthNeed need = advice.need(kept);
  advice.advised = cheapest_depth_format(need.range, need.farthest, need.separation);
  return advice;
}

DepthNeed DepthAdvice::need(const KeptFrames& kept) const {
  const double largest = std::ldexp(1.0, 63) / kUnit;
  return {kept.codes, kept.farthest, static_cast<std::uint64_t>(std::min(needed, largest) * kUnit)};
}

const char* name(DepthFormat format) {
  switch (format) {
    case DepthFormat::z16: return "z16";
    case DepthFormat::float16: return "float";
    case DepthFormat::z24: return "z24";
  }
  return "unknown";
}

}  // namespace zstrip::sim
