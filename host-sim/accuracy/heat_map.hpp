// A picture of the renderer compared with the truth: the perceived difference of each pixel in colours, and its
// maximum.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "bake/effects_found.hpp"
#include "render/stage.hpp"
#include "result.hpp"
#include "zstrip/view.hpp"

namespace zstrip::sim {

/// Maps 0 to black, then over red and yellow to white at 20 units of CIELAB.
std::array<std::uint8_t, 3> heat_colour(float difference);

/// Differences as in perceived_difference, in units of CIELAB; 1 unit is just noticeable.
struct HeatFigures {
  double mean = 0;
  double worst = 0;
  std::uint32_t worst_x = 0, worst_y = 0;
  double seen_percent = 0;  ///< of all pixels, those with a difference of more than 1
};
/// "worst 24.3 at 100,57; 12.1 % of pixels are seen to differ; mean 0.61"
std::string in_words(const HeatFigures& figures);

struct HeatMap {
  std::vector<std::uint16_t> pixels;  ///< RGB565
  HeatFigures figures;
};

/// `pixels`: the pixels of `view`, as the renderer drew `staging` without an overlay, because the truth has none. Edges
/// are ignored: they bring the picture closer to the truth. `origins`: for messages. Failures: those of check_truth.
Result<HeatMap> draw_heat_map(const Staging& staging, const Origins& origins, const View& view,
                              std::span<const std::byte> pixels);

}  // namespace zstrip::sim
