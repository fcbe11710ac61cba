// Measures how far distant parts extend the size of a model.
#include "import/outlying.hpp"

#include <algorithm>
#include <vector>

namespace zstrip::sim {

double outlying_of(const SourceModel& model) {
  double whole = 0, middle = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::vector<double> places;  // of all corners
    const auto add = [&](const auto& part) {
      for (const std::uint32_t index : part.indices) places.push_back(double{part.vertices[index].position[axis]});
    };
    std::ranges::for_each(model.meshes, add);
    std::ranges::for_each(model.lines, add);
    if (places.empty()) return 1;
    const auto at = [&places](std::size_t quarter) {
      const auto nth = places.begin() + static_cast<std::ptrdiff_t>((places.size() - 1) * quarter / 4);
      std::nth_element(places.begin(), nth, places.end());
      return *nth;
    };
    whole = std::max(whole, at(4) - at(0));
    middle = std::max(middle, at(3) - at(1));
  }
  return middle > 0 ? whole / middle : 1;
}

}  // namespace zstrip::sim
