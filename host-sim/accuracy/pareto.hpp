// Finds the points that no other point beats: none is better in one respect and at least as good in the others.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace zstrip::sim {

/// Less is better in each.
using Respects = std::array<double, 3>;

/// True if `a` is at least as good as `b` in all respects, and better in one.
bool dominates(const Respects& a, const Respects& b);

/// Returns true for each point that no other point dominates. Of equal points only the first gets true.
std::vector<bool> pareto_front(std::span<const Respects> points);

}  // namespace zstrip::sim
