// Draws the scene of scene.hpp with zstrip::Player and writes the pixels, RGB565, to standard output.
#include <zstrip_hal/framebuffer.hpp>
#include <zstrip_player/player.hpp>

#include <cstdio>
#include <vector>

#include "scene.hpp"

int main() {
  namespace hal = zstrip::hal;
  static std::byte memory[64 * 1024];
  zstrip::Player player(memory, zstrip::drawn_with<baked::kEffects>);
  std::vector<std::byte> pixels(2U * baked::kView.width * baked::kView.height);
  hal::Framebuffer display(pixels, {baked::kView.width, baked::kView.height, hal::DisplayFormat::rgb565});
  if (!player.open({baked::kScene, baked::kCamera, baked::kAnimation, baked::kTurn}, baked::kView) ||
      !player.fit(display) || !player.draw(display)) {
    std::fprintf(stderr, "%s\n", player.error());
    return 1;
  }
  return std::fwrite(pixels.data(), 1, pixels.size(), stdout) == pixels.size() ? 0 : 1;
}
