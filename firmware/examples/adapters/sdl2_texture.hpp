// zstrip in a window of SDL 2, on hosts: strips are rows of a texture. They are copied, without DMA.
// Needs a renderer of the program (SDL_CreateRenderer()); the picture fills what the renderer draws to.
// Format: rgb565, words of the processor (rgb565_swapped where it has the high byte first).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include <SDL.h>
#include <zstrip_hal/display.hpp>

namespace adapters {

class Sdl2Texture {
 public:
  using Error = zstrip::hal::Error;
  static constexpr auto kFormat =
      SDL_BYTEORDER == SDL_LIL_ENDIAN ? zstrip::hal::DisplayFormat::rgb565 : zstrip::hal::DisplayFormat::rgb565_swapped;

  /// `renderer` must outlive it.
  Sdl2Texture(SDL_Renderer* renderer, std::uint16_t width, std::uint16_t height)
      : renderer_(renderer), width_(width), height_(height) {}
  Sdl2Texture(const Sdl2Texture&) = delete;
  Sdl2Texture& operator=(const Sdl2Texture&) = delete;
  ~Sdl2Texture() {
    if (texture_ != nullptr) SDL_DestroyTexture(texture_);
  }

  /// Once, before the first frame. Error::configuration: the renderer has no such texture; SDL_GetError() says why.
  Error start() {
    texture_ = SDL_CreateTexture(renderer_, SDL_PIXELFORMAT_RGB565, SDL_TEXTUREACCESS_STREAMING, width_, height_);
    return texture_ != nullptr ? Error::none : Error::configuration;
  }

  std::uint16_t width() const { return width_; }
  std::uint16_t height() const { return height_; }
  zstrip::hal::DisplayFormat format() const { return kFormat; }

  Error begin_frame() { return texture_ != nullptr ? Error::none : Error::configuration; }
  Error write(const zstrip::hal::Area& area, std::span<const std::byte> pixels) {
    if (!contains(width_, height_, area)) return Error::area;
    const std::uint32_t row_bytes = bytes_per_row(area.width, kFormat);
    if (pixels.size() < row_bytes * area.height) return Error::pixels_too_small;
    const SDL_Rect rows{area.left, area.top, area.width, area.height};
    return told(SDL_UpdateTexture(texture_, &rows, pixels.data(), static_cast<int>(row_bytes)));
  }
  Error wait() { return Error::none; }
  Error end_frame() {
    const Error error = told(SDL_RenderCopy(renderer_, texture_, nullptr, nullptr));
    if (error == Error::none) SDL_RenderPresent(renderer_);
    return error;
  }

 private:
  static Error told(int status) { return status == 0 ? Error::none : Error::bus; }

  SDL_Renderer* renderer_;
  std::uint16_t width_, height_;
  SDL_Texture* texture_ = nullptr;
};
static_assert(zstrip::hal::Display<Sdl2Texture>);

}  // namespace adapters
