// A desktop window. Only this file uses SDL.
#include "view/window.hpp"

#include <SDL.h>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <chrono>
#include <cstdlib>
#include <string_view>
#include <utility>

#include "view/time_limit.hpp"

namespace zstrip::sim {

struct Window::Parts {
  std::string title;
  SDL_Window* window = nullptr;  // created when the first size is known
  int moved = 0;                 // pixels of drags since the button was pressed
};

void Window::Close::operator()(Parts* parts) const {
  if (parts->window != nullptr) SDL_DestroyWindow(parts->window);
  SDL_Quit();
  delete parts;
}

namespace {

constexpr int kSteady = 3;                     // pixels by which a hand moves in a click
constexpr std::chrono::seconds kPatience{10};  // SDL and Xlib wait without limit for a desktop that does not answer

Failure no_window(std::string_view why) {
  return {ExitStatus::environment,
          fmt::format("no window can be opened: {}; over ssh connect with 'ssh -X', or draw to a file: "
                      "'zstrip render SCENE -o FILE.png'",
                      why)};
}

Failure silent_desktop() {
  const char* const display = std::getenv("DISPLAY");
  return no_window(fmt::format("the desktop{} does not answer within {} seconds",
                               display == nullptr ? std::string() : fmt::format(" DISPLAY={}", display),
                               kPatience.count()));
}

/// Without a desktop SDL selects a driver that shows nothing, or the whole screen. A driver named by the user is
/// accepted.
bool has_desktop() {
  const std::string_view driver = SDL_GetCurrentVideoDriver();
  return std::getenv("SDL_VIDEODRIVER") != nullptr || driver == "wayland" || driver == "x11";
}

bool has_screen() { return std::string_view(SDL_GetCurrentVideoDriver()) != "dummy"; }

SDL_Rect usable_area() {
  SDL_Rect area{0, 0, 640, 480};
  SDL_GetDisplayUsableBounds(0, &area);
  return area;
}

std::string key_name(SDL_Keycode code, bool shifted) {
  std::string name = SDL_GetKeyName(code);
  if (name.size() == 1 && !shifted) name[0] = static_cast<char>(std::tolower(name[0]));
  return name;
}

/// Returns nothing for events that are not used. `moved`: see Window::Parts.
std::optional<Input> input_of(const SDL_Event& event, int& moved) {
  switch (event.type) {
    case SDL_QUIT: return Input{.kind = Input::Kind::closed};
    case SDL_KEYDOWN:
      return Input{.kind = Input::Kind::key,
                   .key = key_name(event.key.keysym.sym, (event.key.keysym.mod & KMOD_SHIFT) != 0)};
    case SDL_MOUSEMOTION:
      if ((event.motion.state & SDL_BUTTON_LMASK) == 0) return std::nullopt;
      moved += std::abs(event.motion.xrel) + std::abs(event.motion.yrel);
      return Input{.kind = Input::Kind::drag,
                   .x = static_cast<double>(event.motion.xrel),
                   .y = static_cast<double>(event.motion.yrel)};
    case SDL_MOUSEBUTTONDOWN:
      if (event.button.button == SDL_BUTTON_LEFT) moved = 0;
      return std::nullopt;
    case SDL_MOUSEBUTTONUP:
      if (event.button.button != SDL_BUTTON_LEFT || moved > kSteady) return std::nullopt;
      return Input{.kind = Input::Kind::click,
                   .x = static_cast<double>(event.button.x),
                   .y = static_cast<double>(event.button.y)};
    case SDL_MOUSEWHEEL: return Input{.kind = Input::Kind::wheel, .y = static_cast<double>(event.wheel.y)};
    case SDL_WINDOWEVENT:
      if (event.window.event != SDL_WINDOWEVENT_EXPOSED && event.window.event != SDL_WINDOWEVENT_SIZE_CHANGED) {
        return std::nullopt;
      }
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
  if ((what != "drag" && what != "click") || colon == std::string_view::npos) return std::nullopt;
  const std::optional<int> x = number(value.substr(0, colon)), y = number(value.substr(colon + 1));
  if (!x || !y) return std::nullopt;
  return Input{.kind = what == "drag" ? Input::Kind::drag : Input::Kind::click,
               .x = static_cast<double>(*x),
               .y = static_cast<double>(*y)};
}

Result<Window> Window::open(const std::string& title) {
  const TimeLimit limit(kPatience, silent_desktop());
  std::unique_ptr<Parts, Close> parts(new Parts{.title = title});
  SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");  // Ctrl-C ends the program
  if (SDL_Init(SDL_INIT_VIDEO) != 0) return no_window(SDL_GetError());
  if (!has_desktop()) return no_window("DISPLAY and WAYLAND_DISPLAY name no desktop");
  // X11 gets the pixels themselves: OpenGL is slow over ssh, and its picture moves while the window's size changes.
  if (std::string_view(SDL_GetCurrentVideoDriver()) == "x11") SDL_SetHint(SDL_HINT_FRAMEBUFFER_ACCELERATION, "0");
  return Window(std::move(parts));
}

WindowSize Window::room() const {
  constexpr std::uint32_t kMaxSide = 4096;
  if (!has_screen()) return {kMaxSide, kMaxSide};
  // The size of the window's frame is known only when the window is shown; a title bar takes about a twentieth of a
  // screen's height.
  const SDL_Rect area = usable_area();
  const auto side = [](int all, int frame) { return static_cast<std::uint32_t>(std::max(all - frame, 1)); };
  return {std::min(side(area.w, 16), kMaxSide), std::min(side(area.h, 24 + area.h / 30), kMaxSide)};
}

Result<Done> Window::resize(const WindowSize& size) {
  const int width = static_cast<int>(size.width), height = static_cast<int>(size.height);
  if (parts_->window != nullptr) {
    SDL_SetWindowSize(parts_->window, width, height);
    return Done{};
  }
  const TimeLimit limit(kPatience, silent_desktop());
  const SDL_Rect area = usable_area();
  const WindowSize most = room();
  const auto middle = [](int begin, int all, std::uint32_t room, int length) {
    return begin + std::max(std::min(static_cast<int>(room), all) - length, 0) / 2;
  };
  parts_->window = SDL_CreateWindow(parts_->title.c_str(), middle(area.x, area.w, most.width, width),
                                    middle(area.y, area.h, most.height, height), width, height, SDL_WINDOW_RESIZABLE);
  if (parts_->window == nullptr) return no_window(SDL_GetError());
  return Done{};
}

WindowSize Window::size() const {
  int width = 0, height = 0;
  SDL_GetWindowSize(parts_->window, &width, &height);
  return {static_cast<std::uint32_t>(std::max(width, 1)), static_cast<std::uint32_t>(std::max(height, 1))};
}

Result<Done> Window::show(const RgbImage& pixels) {
  const int width = static_cast<int>(pixels.width), height = static_cast<int>(pixels.height);
  const auto failed = [] {
    return Failure{ExitStatus::environment, fmt::format("the window cannot be drawn to: {}", SDL_GetError())};
  };
  SDL_Surface* const window = SDL_GetWindowSurface(parts_->window);
  if (window == nullptr) return failed();
  // SDL does not write to the pixels.
  auto* const bytes = const_cast<std::uint8_t*>(pixels.rgb.data());
  SDL_Surface* const image =
      SDL_CreateRGBSurfaceWithFormatFrom(bytes, width, height, 24, 3 * width, SDL_PIXELFORMAT_RGB24);
  if (image == nullptr) return failed();
  SDL_Rect place{(window->w - width) / 2, (window->h - height) / 2, width, height};
  const bool drawn = SDL_FillRect(window, nullptr, 0) == 0 && SDL_BlitSurface(image, nullptr, window, &place) == 0;
  SDL_FreeSurface(image);
  if (!drawn || SDL_UpdateWindowSurface(parts_->window) != 0) return failed();
  return Done{};
}

std::optional<Input> Window::wait(std::uint32_t milliseconds) {
  // SDL_WaitEventTimeout sends X11 events to a window that may no longer exist, which ends the program.
  constexpr std::uint64_t kNap = 3;
  const std::uint64_t end = SDL_GetTicks64() + milliseconds;
  for (;;) {
    for (SDL_Event event; SDL_PollEvent(&event) != 0;) {
      if (std::optional<Input> input = input_of(event, parts_->moved)) return input;
    }
    const std::uint64_t now = SDL_GetTicks64();
    if (now >= end) return std::nullopt;
    SDL_Delay(static_cast<std::uint32_t>(std::min(kNap, end - now)));
  }
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
    case Input::Kind::click:
      event.button.button = SDL_BUTTON_LEFT;
      event.button.x = static_cast<int>(input.x), event.button.y = static_cast<int>(input.y);
      event.type = SDL_MOUSEBUTTONDOWN;
      SDL_PushEvent(&event);
      event.type = SDL_MOUSEBUTTONUP;
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
