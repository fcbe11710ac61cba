// Compares a box's corners with the limits of project_narrow; only renderers with effect::unclipped link it.
#include "zstrip/effects/unclipped/unclipped_stage.hpp"

namespace zstrip::detail::unclipped {
namespace {

/// A linear form rounds each of its three products down: an error below 3 for the corner, and below 3 for a vertex.
constexpr std::int64_t kRounding = 6;
/// 8 pixels less than project_narrow's limit, for the biases of the picture's centre, the rounding to 1/16 pixels, and
/// the error of a reciprocal from the table, 2^-9 of kNarrowLimit.
constexpr std::int64_t kLimit = kNarrowLimit - 8 * 16;

}  // namespace

template <bool orthographic>
bool is_box_narrow(const CompiledInstance& instance, const RasterOrigin& origin) {
  const NarrowProjection<orthographic> narrow(instance, origin);
  const std::int64_t nearest = std::int64_t{narrow.w_near} + kRounding;
  const std::int64_t farthest = std::int64_t{narrow.w_near} + narrow.w_range - kRounding;
  for (int corner = 0; corner < 8; ++corner) {
    const auto side = [corner](int axis) -> std::int16_t { return (corner >> axis & 1) != 0 ? INT16_MAX : INT16_MIN; };
    const Position p{side(0), side(1), side(2)};
    const std::int64_t w = instance.w.at(p);
    if (w < nearest || w > farthest) return false;
    // |x| * 2^(30 - shift) / w <= kLimit, orthographic |x| / 2^shift; shifts are 0 to 31, the product is below 2^46.
    const auto is_inside = [w](std::int64_t numerator, std::int32_t shift) {
      const std::int64_t reach = (numerator < 0 ? -numerator : numerator) + kRounding;
      if (orthographic) return reach <= kLimit << shift;
      const std::int64_t limit = kLimit * (w - kRounding);
      return shift <= 30 ? reach << (30 - shift) <= limit : reach <= limit << (shift - 30);
    };
    if (!is_inside(instance.x.at(p), instance.shift_x) || !is_inside(instance.y.at(p), instance.shift_y)) return false;
  }
  return true;
}

template bool is_box_narrow<false>(const CompiledInstance&, const RasterOrigin&);
template bool is_box_narrow<true>(const CompiledInstance&, const RasterOrigin&);

}  // namespace zstrip::detail::unclipped
