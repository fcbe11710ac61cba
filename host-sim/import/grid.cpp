// The box in which a mesh's positions are expressed.
#include "import/grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "import/quantise.hpp"
#include "import/quantised_morphs.hpp"
#include "import/quantised_skins.hpp"

namespace zstrip::sim {

Position Grid::position(const std::array<float, 3>& from) const {
  const std::array<Fixed, 3> centres{centre.x, centre.y, centre.z};
  const auto coordinate = [&](std::size_t axis, Fixed half) {
    if (half == 0) return std::int16_t{0};
    const double scene =
        (double{from[axis]} + (vertices_from[axis] - units.origin[axis])) * units.scale - from_fixed(centres[axis]);
    const double steps = std::round(scene * kFixedOne / half * 32768);  // 1.15 of the half extent
    return static_cast<std::int16_t>(std::clamp(steps, -32767.0, 32767.0));
  };
  return {coordinate(0, half_extent.x), coordinate(1, half_extent.y), coordinate(2, half_extent.z)};
}

double Grid::steps_of(double offset) const { return offset * units.scale * kFixedOne / half_extent.x * 32768; }

Grid fit_grid(const SourceModel& source) {
  std::array<double, 3> low{};
  std::array<double, 3> high{};
  low.fill(std::numeric_limits<double>::infinity());
  high.fill(-std::numeric_limits<double>::infinity());
  const auto include = [&](const SourceVertex& vertex) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], double{vertex.position[axis]});
      high[axis] = std::max(high[axis], double{vertex.position[axis]});
    }
  };
  for (const SourceMesh& mesh : source.meshes) std::ranges::for_each(mesh.vertices, include);
  // Vertices that no line uses may have any position, also one that is not finite.
  for (const SourceLines& lines : source.lines) {
    for (const std::uint32_t index : lines.indices) include(lines.vertices[index]);
  }
  Grid grid;
  grid.vertices_from = source.origin;
  double largest = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    grid.units.origin[axis] = source.origin[axis] + (low[axis] + high[axis]) / 2;
    largest = std::max(largest, (high[axis] - low[axis]) / 2);
  }
  grid.units.scale = largest > 0 ? 1 / largest : 1;  // a single point has no size
  // Rounded up, so that the outermost vertex stays within 32767 steps of 1/32768.
  const auto half_extent = [&](std::size_t axis) {
    const double half = (high[axis] - low[axis]) / 2 * grid.units.scale;
    return static_cast<Fixed>(std::ceil(half * 32768 / 32767 * kFixedOne));  // 16.16
  };
  grid.half_extent = {half_extent(0), half_extent(1), half_extent(2)};
  return grid;
}

Grid grid_of_own(const SourceMesh& mesh, const Grid& whole) {
  std::array<Fixed, 3> centres{}, halves{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const SourceVertex& vertex : mesh.vertices) {
      const double place =
          (double{vertex.position[axis]} + (whole.vertices_from[axis] - whole.units.origin[axis])) * whole.units.scale;
      low = std::min(low, place);
      high = std::max(high, place);
    }
    centres[axis] = to_fixed((low + high) / 2);
    // Rounded up, and a step more for the centre's rounding, so that the outermost vertex stays within 32767 steps.
    const double half = std::ceil((high - low) / 2 * 32768 / 32767 * kFixedOne);
    if (half > 0) halves[axis] = static_cast<Fixed>(half) + 1;  // 16.16
  }
  return {whole.units, whole.vertices_from, {centres[0], centres[1], centres[2]}, {halves[0], halves[1], halves[2]}};
}

Grid grid_of_moved(const SourceModel& source, const SourceMesh& mesh, const Grid& whole) {
  constexpr double kMargin = 1.02;
  const SourceBox box = mesh.has_skin ? box_of_poses(source, mesh) : box_of_morphs(source, mesh);
  Grid grid{whole.units, whole.vertices_from, {}, {}};
  double largest = 0;
  std::array<double, 3> centre{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    centre[axis] = ((box.low[axis] + box.high[axis]) / 2 - whole.units.origin[axis]) * whole.units.scale;
    largest = std::max(largest, (box.high[axis] - box.low[axis]) / 2 * whole.units.scale);
  }
  const auto fixed = [](double value) { return to_fixed(std::clamp(value, -4094.0, 4094.0)); };
  grid.centre = {fixed(centre[0]), fixed(centre[1]), fixed(centre[2])};
  largest *= kMargin;
  if (mesh.has_morphs) {
    // A keyframe of a weight may be off by the animation's tolerance; an offset may be as long as a half extent.
    constexpr double kTolerance = 1.0 / 1024;
    largest = std::max(largest + kTolerance, longest_offset(source, mesh) * whole.units.scale);
  }
  const Fixed half = fixed(largest);
  grid.half_extent = {half, half, half};
  return grid;
}

}  // namespace zstrip::sim
