// Measures how far distant parts extend the size of a model.
#include "import/outlying.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace zstrip::sim {

double outlying_of(const SourceModel& model) {
  constexpr std::size_t kAxes = 3;
  std::array<std::vector<double>, kAxes> places;  // of all corners
  const auto add = [&](const auto& part) {
    for (const std::uint32_t index : part.indices) {
      for (std::size_t axis = 0; axis < kAxes; ++axis) {
        places[axis].push_back(double{part.vertices[index].position[axis]});
      }
    }
  };
  std::ranges::for_each(model.meshes, add);
  std::ranges::for_each(model.lines, add);
  const std::size_t count = places[0].size();
  if (count == 0) return 1;
  const auto nth = [count](std::vector<double> values, std::size_t quarter) {
    const auto at = values.begin() + static_cast<std::ptrdiff_t>((count - 1) * quarter / 4);
    std::nth_element(values.begin(), at, values.end());
    return *at;
  };
  double whole = 0;
  std::vector<double> away(count);  // distance from the middle corner, along the axis where it is largest
  for (const std::vector<double>& along : places) {
    const auto [low, high] = std::minmax_element(along.begin(), along.end());
    whole = std::max(whole, *high - *low);
    const double middle = nth(along, 2);
    for (std::size_t i = 0; i < count; ++i) away[i] = std::max(away[i], std::abs(along[i] - middle));
  }
  // A corner on each axis is at the middle of the others: one axis alone does not tell where most of a model lies.
  const double most = 2 * nth(std::move(away), 3);
  return most > 0 ? whole / most : 1;
}

}  // namespace zstrip::sim
