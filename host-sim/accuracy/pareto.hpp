// Which of several points are worth having: no other is better in one respect and as good in the others.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace zstrip::sim {

/// Less is better in each.
using Respects = std::array<double, 3>;

/// Whether `a` is nowhere worse than `b` and somewhere better.
bool dominates(const Respects& a, const Respects& b);

/// Of each point whether none dominates it. Of equal ones the first alone.
std::vector<bool> pareto_front(std::span<const Respects> points);

}  // namespace zstrip::sim
