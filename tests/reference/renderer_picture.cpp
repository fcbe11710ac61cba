// See renderer_picture.hpp.
#include "renderer_picture.hpp"

#include <cstring>

#include "render/render_frame.hpp"

namespace zstrip::reference {
namespace {

sim::Result<std::vector<std::uint16_t>> drawn_on(const Colour& background, sim::Staging staging, const View& view) {
  staging.scene.background = background;
  sim::FrameRenderer renderer(view, Budget{});
  const sim::Result<sim::FrameReport> report = renderer.render(staging);
  if (!report) return report.failure();
  std::vector<std::uint16_t> pixels(std::size_t{view.width} * view.height);
  std::memcpy(pixels.data(), renderer.pixels().data(), renderer.pixels().size());
  return pixels;
}

}  // namespace

sim::Result<RendererPicture> draw(const sim::Staging& staging, const View& view) {
  sim::Result<std::vector<std::uint16_t>> on_black = drawn_on({0, 0, 0, 255}, staging, view);
  if (!on_black) return on_black.failure();
  const sim::Result<std::vector<std::uint16_t>> on_white = drawn_on({255, 255, 255, 255}, staging, view);
  if (!on_white) return on_white.failure();
  RendererPicture picture{std::move(*on_black), {}};
  for (std::size_t i = 0; i < picture.pixels.size(); ++i) picture.drawn.push_back(picture.pixels[i] == (*on_white)[i]);
  return picture;
}

}  // namespace zstrip::reference
