// A window by SDL 2: strips go into a texture, which fills the window.
#include "zstrip_hal_linux/sdl_display.hpp"

#include <SDL.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <string_view>
#include <thread>
#include <vector>

#include "zstrip_hal_linux/video_memory.hpp"

namespace zstrip::hal {
namespace {

using Clock = std::chrono::steady_clock;

/// True if there is a desktop, or the user has named a video driver. Without a desktop SDL would choose a driver that
/// shows nothing, or the whole screen.
bool has_desktop() {
  const std::string_view driver = SDL_GetCurrentVideoDriver();
  return std::getenv("SDL_VIDEODRIVER") != nullptr || driver == "wayland" || driver == "x11";
}

/// Returns the refresh period of the screen; 60 Hz if the desktop does not report it.
Clock::duration refresh_of(SDL_Window* window) {
  SDL_DisplayMode mode{};
  const bool is_known = SDL_GetWindowDisplayMode(window, &mode) == 0 && mode.refresh_rate > 0;
  return std::chrono::nanoseconds(1'000'000'000) / (is_known ? mode.refresh_rate : 60);
}

}  // namespace

struct SdlDisplay::Parts {
  PixelWriter writer;
  std::vector<std::byte> strip;  ///< XRGB8888
  SDL_Window* window = nullptr;
  SDL_Renderer* renderer = nullptr;
  SDL_Texture* texture = nullptr;
  bool is_closed = false;
  Clock::duration refresh{};
  Clock::time_point next{};  ///< when a frame may be shown

  Error present() const {
    if (SDL_RenderCopy(renderer, texture, nullptr, nullptr) != 0) return Error::bus;
    SDL_RenderPresent(renderer);
    return Error::none;
  }
};

void SdlDisplay::Close::operator()(Parts* parts) const {
  if (parts->texture != nullptr) SDL_DestroyTexture(parts->texture);
  if (parts->renderer != nullptr) SDL_DestroyRenderer(parts->renderer);
  if (parts->window != nullptr) SDL_DestroyWindow(parts->window);
  SDL_QuitSubSystem(SDL_INIT_VIDEO);
  delete parts;
}

Outcome<SdlDisplay> SdlDisplay::open(const std::string& title, const ScreenSize& size, std::uint16_t scale) {
  const auto failed = [](const char* why = SDL_GetError()) {
    return Fault{std::string("no window can be opened: ") + why +
                 "; WAYLAND_DISPLAY or DISPLAY must name a desktop of this user"};
  };
  SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");  // the program handles signals
  if (SDL_InitSubSystem(SDL_INIT_VIDEO) != 0) return failed();
  std::unique_ptr<Parts, Close> parts(new Parts{.writer = *PixelWriter::create(kXrgb8888Layout), .strip = {}});
  if (!has_desktop()) return failed("no desktop answers");
  parts->window = SDL_CreateWindow(title.c_str(), SDL_WINDOWPOS_UNDEFINED, SDL_WINDOWPOS_UNDEFINED, size.width * scale,
                                   size.height * scale, 0);
  if (parts->window == nullptr) return failed();
  // The software renderer makes the pixels on the screen equal to those of the picture, with any driver.
  parts->renderer = SDL_CreateRenderer(parts->window, -1, SDL_RENDERER_SOFTWARE);
  if (parts->renderer == nullptr) return failed();
  parts->texture = SDL_CreateTexture(parts->renderer, SDL_PIXELFORMAT_XRGB8888, SDL_TEXTUREACCESS_STREAMING, size.width,
                                     size.height);
  if (parts->texture == nullptr || parts->present() != Error::none) return failed();
  parts->refresh = refresh_of(parts->window);
  return SdlDisplay(std::move(parts), size);
}

Error SdlDisplay::write(const Area& area, std::span<const std::byte> pixels) {
  if (!contains(size_.width, size_.height, area)) return Error::area;
  const std::uint32_t row_bytes = std::uint32_t{kXrgb8888Layout.bytes} * area.width;
  parts_->strip.resize(std::size_t{row_bytes} * area.height);
  const Error converted = parts_->writer.write({parts_->strip, area.width, area.height, row_bytes},
                                               {0, 0, area.width, area.height}, pixels);
  if (converted != Error::none) return converted;
  const SDL_Rect place{area.left, area.top, area.width, area.height};
  const bool taken = SDL_UpdateTexture(parts_->texture, &place, parts_->strip.data(), static_cast<int>(row_bytes)) == 0;
  return taken ? Error::none : Error::bus;
}

Error SdlDisplay::end_frame() {
  std::this_thread::sleep_until(parts_->next);
  parts_->next = std::max(parts_->next + parts_->refresh, Clock::now());
  return parts_->present();
}

bool SdlDisplay::is_closed() {
  for (SDL_Event event; SDL_PollEvent(&event) != 0;) {
    if (event.type == SDL_QUIT) parts_->is_closed = true;
    const bool is_uncovered = event.type == SDL_WINDOWEVENT && event.window.event == SDL_WINDOWEVENT_EXPOSED;
    // If this fails the next frame does, too.
    if (is_uncovered) static_cast<void>(parts_->present());
  }
  return parts_->is_closed;
}

}  // namespace zstrip::hal
