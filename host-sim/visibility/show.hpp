// Pictures of the work of a visibility method instead of its result.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "result.hpp"
#include "visibility/drawing.hpp"

namespace zstrip::sim {

enum class Show : std::uint8_t {
  colour,    ///< the visible picture
  depth,     ///< the z-buffer as a grey picture: near is light, no surface is black
  overdraw,  ///< number of writes to each pixel: black, blue, green, yellow, red, white for 0 to 5 and more
  tiles,     ///< the method's farthest depth of each 8x8 tile, in the greys of `depth`
  error,     ///< the picture in grey; red where another surface is nearer, or where the background should be visible
  accuracy,  ///< the perceived difference of each pixel from the truth: accuracy/heat_map.hpp
};

/// True if the picture itself is inspected: then it has its own format, samples and edges.
constexpr bool shows_the_picture(Show show) { return show == Show::colour || show == Show::accuracy; }

/// Parses "depth", "overdraw", "tiles", "error" or "accuracy".
Result<Show> parse_show(const std::string& name);

struct ShownFrame {
  LookedAtFrame frame;
  std::vector<std::uint16_t> pixels;  ///< RGB565
  std::uint32_t wrong = 0;            ///< pixels; only for Show::error
};

/// Draws and shows everything except Show::accuracy. Usage errors: depth of the painter, tiles of a method without
/// tiles, the error of a scene that is too large for the judge.
Result<ShownFrame> draw_shown(const Staging& staging, const MethodRequest& request, Show show);

}  // namespace zstrip::sim
