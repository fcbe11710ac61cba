// Pictures of how visibility was found instead of what is visible.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "result.hpp"
#include "visibility/drawing.hpp"

namespace zstrip::sim {

enum class Show : std::uint8_t {
  colour,    ///< what is visible
  depth,     ///< the z-buffer as a grey picture: near is light, nothing is black
  overdraw,  ///< how often each pixel was written: black, blue, green, yellow, red, white for 0 to 5 and more
  tiles,     ///< the method's farthest depth of each 8x8 tile, as depth is shown
  error,     ///< the picture in grey; red where another surface is nearer, or nothing should be
  accuracy,  ///< how different each pixel looks from the truth: accuracy/heat_map.hpp
};

/// Whether pixels are looked at as they were drawn: the picture has its own format, samples and edges.
constexpr bool shows_the_picture(Show show) { return show == Show::colour || show == Show::accuracy; }

/// "depth", "overdraw", "tiles", "error" or "accuracy".
Result<Show> parse_show(const std::string& name);

struct ShownFrame {
  LookedAtFrame frame;
  std::vector<std::uint16_t> pixels;  ///< RGB565
  std::uint32_t wrong = 0;            ///< pixels; only of Show::error
};

/// Draws and shows anything but Show::accuracy. Usage errors: depth of the painter, tiles of a method without, the
/// error of a scene that is too large for the judge.
Result<ShownFrame> draw_shown(const Staging& staging, const MethodRequest& request, Show show);

}  // namespace zstrip::sim
