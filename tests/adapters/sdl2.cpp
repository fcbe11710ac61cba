// The real SDL 2, with a renderer that draws to memory instead of a window.
#include "libraries.hpp"
#include "sdl2_texture.hpp"

namespace {

using namespace zstrip::adapters_test;

struct Sdl2Parts {
  SDL_Surface* surface = SDL_CreateRGBSurfaceWithFormat(0, kWidth, kHeight, 16, SDL_PIXELFORMAT_RGB565);
  SDL_Renderer* renderer = screen().fault == Fault::start ? nullptr : SDL_CreateSoftwareRenderer(surface);
  // Last, so that it ends first.
  struct Ends {
    Sdl2Parts& parts;
    ~Ends() {
      screen().look = [] {};
      if (parts.renderer != nullptr) SDL_DestroyRenderer(parts.renderer);
      SDL_FreeSurface(parts.surface);
    }
  } ends{*this};
  adapters::Sdl2Texture adapter{renderer, kWidth, kHeight};

  Sdl2Parts() {
    screen().look = [this] {
      for (int row = 0; row < kHeight; ++row) {
        const auto* first = static_cast<const std::uint8_t*>(surface->pixels) + row * surface->pitch;
        screen().draw(area_of(0, row, kWidth, 1), first, SDL_BYTEORDER == SDL_LIL_ENDIAN ? First::low : First::high);
      }
    };
  }
};

}  // namespace

namespace zstrip::adapters_test {
std::unique_ptr<panel::AnyDisplay> open_sdl2() { return std::make_unique<Opened<Sdl2Parts>>(); }
}  // namespace zstrip::adapters_test
