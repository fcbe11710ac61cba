// Compares every pair; there are some hundred points.
#include "accuracy/pareto.hpp"

namespace zstrip::sim {

bool dominates(const Respects& a, const Respects& b) {
  bool better = false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i] > b[i]) return false;
    better = better || a[i] < b[i];
  }
  return better;
}

std::vector<bool> pareto_front(std::span<const Respects> points) {
  std::vector<bool> on_front(points.size(), true);
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < points.size() && on_front[i]; ++j) {
      if (i == j) continue;
      on_front[i] = !dominates(points[j], points[i]) && !(j < i && points[j] == points[i]);
    }
  }
  return on_front;
}

}  // namespace zstrip::sim
