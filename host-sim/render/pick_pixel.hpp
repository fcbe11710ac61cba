// Finds what a pixel of a frame shows.
#pragma once

#include <cstdint>
#include <string>

#include "render/stage.hpp"
#include "result.hpp"
#include "zstrip/effects.hpp"
#include "zstrip/frame/picked.hpp"
#include "zstrip/view.hpp"

namespace zstrip::sim {

/// A pixel of the picture, from its upper left corner.
struct PixelPlace {
  std::uint16_t x = 0, y = 0;
};

struct PickedPixel {
  PixelPlace place;
  Picked picked;
  std::string material;  ///< its name, where the file has names; else empty
  std::string name;      ///< of the instance, likewise
};

/// Begins the frame again, in streamed strips, and picks in it. `added`: effects that neither scene nor view needs.
/// Fails with ExitStatus::usage outside of the picture, and where pick refuses the scene.
Result<PickedPixel> pick_pixel(const Staging& staging, const Origins& origins, const View& view, Effects added,
                               PixelPlace place);

/// Returns "instance 2 (wheel), triangle 31, material gold, texture 0.250,0.500", or "background".
std::string words_of(const PickedPixel& pixel);

}  // namespace zstrip::sim
