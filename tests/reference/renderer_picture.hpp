// A frame drawn by the renderer under test, and which of its pixels it has drawn on.
#pragma once

#include <cstdint>
#include <vector>

#include "render/stage.hpp"
#include "result.hpp"
#include "zstrip/view.hpp"

namespace zstrip::reference {

/// Row-major, the first row on top.
struct RendererPicture {
  std::vector<std::uint16_t> pixels;  ///< RGB565
  std::vector<std::uint8_t> drawn;    ///< 0: the pixel is background
};

/// Draws the frame twice, on black and on white: background is what changes. `view` in PixelFormat::rgb565.
sim::Result<RendererPicture> draw(const sim::Staging& staging, const View& view);

}  // namespace zstrip::reference
