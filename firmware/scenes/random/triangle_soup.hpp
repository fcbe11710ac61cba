// Makes the random triangles of the workloads, in integers.
#pragma once

#include "workload_random.hpp"
#include "zstrip_scenes/compile_time.hpp"
#include "zstrip_scenes/random.hpp"

namespace zstrip::scenes {

/// Returns the triangles. `size_thousandths`: the spread of the corners, in 1/1000 world units; even. For each triangle
/// the workload draws three random numbers for the centre within +-0.9, three for the colour, then for each corner
/// three within +-size, half of which is added to the centre, and two for texture coordinates. A number is the upper 24
/// bits of the generator, as a fraction.
template <std::size_t count>
consteval TriangleSoup<count> random_triangles(std::int32_t size_thousandths, Fixed half_extent) {
  WorkloadRandom random(12345);
  const auto within = [&random](std::int64_t limit) {  // +-limit thousandths, in 2^-24 thousandths: exact
    return 2 * limit * static_cast<std::int64_t>(random.next() >> 8) - (limit << 24);
  };
  const auto on_grid = [half_extent](std::int64_t length) {  // from 2^-24 thousandths to grid steps, halves up
    // length / (1000 * 2^24) * 32768 * 2^16 / half_extent, as a fraction with twice the divisor.
    const std::int64_t divisor = std::int64_t{1000} * half_extent;
    const std::int64_t dividend = 2 * 128 * length + divisor;
    const std::int64_t step = dividend / (2 * divisor) - (dividend % (2 * divisor) < 0 ? 1 : 0);
    return compile_time::grid_step(step);
  };

  TriangleSoup<count> soup{};
  for (std::size_t t = 0; t < count; ++t) {
    const std::int64_t centre_x = within(900), centre_y = within(900), centre_z = within(900);
    const auto red = static_cast<std::uint8_t>(random.next() >> 24);
    const auto green = static_cast<std::uint8_t>(random.next() >> 24);
    const auto blue = static_cast<std::uint8_t>(random.next() >> 24);
    for (std::size_t corner = 3 * t; corner < 3 * t + 3; ++corner) {
      const std::int64_t x = centre_x + within(size_thousandths) / 2;  // exact: the size is even
      const std::int64_t y = centre_y + within(size_thousandths) / 2;
      const std::int64_t z = centre_z + within(size_thousandths) / 2;
      soup.positions[corner] = {on_grid(x), on_grid(y), on_grid(z)};
      soup.colours[corner] = {red, green, blue, 255};
      random.next();
      random.next();
    }
    const auto first = static_cast<std::uint16_t>(3 * t);
    soup.triangles[t] = {first, static_cast<std::uint16_t>(first + 1), static_cast<std::uint16_t>(first + 2)};
  }
  return soup;
}

}  // namespace zstrip::scenes
