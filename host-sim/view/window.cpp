// A window of the desktop. The only place that knows SDL.
#include "view/window.hpp"

#include <SDL.h>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <string_view>
#include <utility>

namespace zstrip::sim {

struct Window::Parts {
  SDL_Window* window = nullptr;
  SDL_Renderer* renderer = nullptr;
  SDL_Texture* texture = nullptr;
  int width = 0, height = 0;  // of the texture
};

void Window::Close::operator()(Parts* parts) const {
  if (parts->texture != nullptr) SDL_DestroyTexture(parts->texture);
  if (parts->renderer != nullptr) SDL_DestroyRenderer(parts->renderer);
  if (parts->window != nullptr) SDL_DestroyWindow(parts->window);
  SDL_Quit();
  delete parts;
}

namespace {

Failure failed(const char* what) {
  return {ExitStatus::environment,
          fmt::format("{}: {}; SDL_VIDEODRIVER=dummy goes without a display", what, SDL_GetError())};
}

std::string key_name(SDL_Keycode code, bool shifted) {
  std::string name = SDL_GetKeyName(code);
  if (name.size() == 1 && !shifted) name[0] = static_cast<char>(std::tolower(name[0]));
  return name;
}

/// Nothing for what is of no interest.
std::optional<Input> input_of(const SDL_Event& event) {
  switch (event.type) {
    case SDL_QUIT: return Input{.kind = Input::Kind::closed};
    case SDL_KEYDOWN:
      return Input{.kind = Input::Kind::key,
                   .key = key_name(event.key.keysym.sym, (event.key.keysym.mod & KMOD_SHIFT) != 0)};
    case SDL_MOUSEMOTION:
      if ((event.motion.state & SDL_BUTTON_LMASK) == 0) return std::nullopt;
      return Input{.kind = Input::Kind::drag,
                   .x = static_cast<double>(event.motion.xrel),
                   .y = static_cast<double>(event.motion.yrel)};
    case SDL_MOUSEWHEEL: return Input{.kind = Input::Kind::wheel, .y = static_cast<double>(event.wheel.y)};
    case SDL_WINDOWEVENT:
      if (event.window.event != SDL_WINDOWEVENT_EXPOSED) return std::nullopt;
      return Input{.kind = Input::Kind::exposed};
    default: return std::nullopt;
  }
}

std::optional<int> number(std::string_view text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

}  // namespace

std::optional<Input> parse_input(const std::string& word) {
  const std::size_t equals = word.find('=');
  if (equals == std::string::npos || equals == 0) {
    const SDL_Keycode key = SDL_GetKeyFromName(word.c_str());
    if (key == SDLK_UNKNOWN) return std::nullopt;
    const bool shifted = word.size() == 1 && std::isupper(static_cast<unsigned char>(word[0])) != 0;
    return Input{.kind = Input::Kind::key, .key = key_name(key, shifted)};
  }
  const std::string_view what = std::string_view(word).substr(0, equals);
  const std::string_view value = std::string_view(word).substr(equals + 1);
  if (what == "wheel") {
    const std::optional<int> steps = number(value);
    if (!steps) return std::nullopt;
    return Input{.kind = Input::Kind::wheel, .y = static_cast<double>(*steps)};
  }
  const std::size_t colon = value.find(':');
  if (what != "drag" || colon == std::string_view::npos) return std::nullopt;
  const std::optional<int> x = number(value.substr(0, colon)), y = number(value.substr(colon + 1));
  if (!x || !y) return std::nullopt;
  return Input{.kind = Input::Kind::drag, .x = static_cast<double>(*x), .y = static_cast<double>(*y)};
}

Result<Window> Window::open(const std::string& title) {
  std::unique_ptr<Parts, Close> parts(new Parts);
  SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");  // Ctrl-C ends the program
  if (SDL_Init(SDL_INIT_VIDEO) != 0) return failed("no window can be opened");
  parts->window = SDL_CreateWindow(title.c_str(), SDL_WINDOWPOS_UNDEFINED, SDL_WINDOWPOS_UNDEFINED, 320, 240, 0);
  if (parts->window == nullptr) return failed("no window can be opened");
  // In software: pixels on the screen are those of the picture, with any driver.
  parts->renderer = SDL_CreateRenderer(parts->window, -1, SDL_RENDERER_SOFTWARE);
  if (parts->renderer == nullptr) return failed("the window cannot be drawn to");
  return Window(std::move(parts));
}

Result<Done> Window::show(const RgbImage& picture) {
  const int width = static_cast<int>(picture.width), height = static_cast<int>(picture.height);
  if (parts_->width != width || parts_->height != height) {
    SDL_SetWindowSize(parts_->window, width, height);
    if (parts_->texture != nullptr) SDL_DestroyTexture(parts_->texture);
    parts_->texture =
        SDL_CreateTexture(parts_->renderer, SDL_PIXELFORMAT_RGB24, SDL_TEXTUREACCESS_STREAMING, width, height);
    if (parts_->texture == nullptr) return failed("the window cannot be this large");
    parts_->width = width, parts_->height = height;
  }
  if (SDL_UpdateTexture(parts_->texture, nullptr, picture.rgb.data(), 3 * width) != 0 ||
      SDL_RenderCopy(parts_->renderer, parts_->texture, nullptr, nullptr) != 0) {
    return failed("the window cannot be drawn to");
  }
  SDL_RenderPresent(parts_->renderer);
  return Done{};
}

Result<RgbImage> Window::shown() const {
  RgbImage picture{.width = static_cast<std::uint32_t>(parts_->width),
                   .height = static_cast<std::uint32_t>(parts_->height),
                   .rgb = {}};
  picture.rgb.resize(std::size_t{3} * picture.width * picture.height);
  if (SDL_RenderReadPixels(parts_->renderer, nullptr, SDL_PIXELFORMAT_RGB24, picture.rgb.data(), 3 * parts_->width) !=
      0) {
    return failed("the window cannot be read");
  }
  return picture;
}

std::optional<Input> Window::wait(std::uint32_t milliseconds) {
  const std::uint64_t end = SDL_GetTicks64() + milliseconds;
  SDL_Event event;
  for (std::uint64_t now = end - milliseconds; SDL_WaitEventTimeout(&event, static_cast<int>(end - now)) != 0;
       now = std::min<std::uint64_t>(SDL_GetTicks64(), end)) {
    if (std::optional<Input> input = input_of(event)) return input;
  }
  return std::nullopt;
}

void Window::inject(const Input& input) {
  SDL_Event event{};
  switch (input.kind) {
    case Input::Kind::key:
      event.type = SDL_KEYDOWN;
      event.key.keysym.sym = SDL_GetKeyFromName(input.key.c_str());
      if (input.key.size() == 1 && std::isupper(static_cast<unsigned char>(input.key[0])) != 0) {
        event.key.keysym.mod = KMOD_LSHIFT;
      }
      break;
    case Input::Kind::drag:
      event.type = SDL_MOUSEMOTION;
      event.motion.state = SDL_BUTTON_LMASK;
      event.motion.xrel = static_cast<int>(input.x), event.motion.yrel = static_cast<int>(input.y);
      break;
    case Input::Kind::wheel:
      event.type = SDL_MOUSEWHEEL;
      event.wheel.y = static_cast<int>(input.y);
      break;
    case Input::Kind::exposed:
      event.type = SDL_WINDOWEVENT;
      event.window.event = SDL_WINDOWEVENT_EXPOSED;
      break;
    case Input::Kind::closed: event.type = SDL_QUIT; break;
  }
  SDL_PushEvent(&event);
}

void Window::set_title(const std::string& title) { SDL_SetWindowTitle(parts_->window, title.c_str()); }

}  // namespace zstrip::sim
