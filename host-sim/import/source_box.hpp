// A box around points in the file's units.
#pragma once

#include <algorithm>
#include <array>
#include <limits>

#include "motion/affine.hpp"

namespace zstrip::sim {

/// Empty at first.
struct SourceBox {
  static constexpr double kFar = std::numeric_limits<double>::infinity();
  Vector low{kFar, kFar, kFar}, high{-kFar, -kFar, -kFar};
};

inline bool is_empty(const SourceBox& box) { return box.low[0] > box.high[0]; }

/// Enlarges the box, so that the point lies in it.
inline void include(SourceBox& box, const Vector& point) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    box.low[axis] = std::min(box.low[axis], point[axis]);
    box.high[axis] = std::max(box.high[axis], point[axis]);
  }
}

template <class Visit>
void for_each_corner(const SourceBox& box, const Visit& visit) {
  for (unsigned corner = 0; corner < 8; ++corner) {
    const auto side = [&](std::size_t axis) { return (corner >> axis & 1) != 0 ? box.high[axis] : box.low[axis]; };
    visit(Vector{side(0), side(1), side(2)});
  }
}

}  // namespace zstrip::sim
