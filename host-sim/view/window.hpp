// A desktop window. Only window.cpp uses SDL.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "image/rgb_image.hpp"
#include "result.hpp"
#include "view/window_picture.hpp"

namespace zstrip::sim {

/// An input event of the user.
struct Input {
  enum class Kind : std::uint8_t { key, drag, click, wheel, exposed, closed };
  Kind kind = Kind::exposed;
  std::string key{};  ///< name as in SDL, letters lower case, or upper case with the shift key: "w", "S", "Right",
                      ///< "Space"
  double x = 0;       ///< for a drag: pixels to the right; for a click without a drag: the window's pixel
  double y = 0;       ///< the same downwards; for the wheel: steps away from the user
};

/// Parses "w", "right", "drag=40:-10", "click=120:80", "wheel=2", as in --press. Returns nothing for other words.
std::optional<Input> parse_input(const std::string& word);

/// To be used only by the thread that opened it.
class Window {
 public:
  /// Connects to the desktop; nothing is shown yet. ExitStatus::environment without a desktop; if the desktop does not
  /// answer, the program ends with that status after some seconds.
  static Result<Window> open(const std::string& title);

  /// Returns the size of the largest window with a frame that fits on the screen without covering the desktop's bars.
  WindowSize room() const;
  /// Requests this size from the desktop, which may choose another one; the first call shows the window. Each change is
  /// reported by Input::Kind::exposed.
  Result<Done> resize(const WindowSize& size);
  /// Returns the current size.
  WindowSize size() const;
  /// Shows pixels without scaling: made for size(), or else centred.
  Result<Done> show(const RgbImage& pixels);
  /// Waits for at most so long; returns nothing if there was no input.
  std::optional<Input> wait(std::uint32_t milliseconds);
  /// Adds an input event as if the user had caused it; wait() returns it after earlier events.
  void inject(const Input& input);
  void set_title(const std::string& title);

 private:
  struct Parts;
  struct Close {
    void operator()(Parts* parts) const;
  };
  explicit Window(std::unique_ptr<Parts, Close> parts) : parts_(std::move(parts)) {}
  std::unique_ptr<Parts, Close> parts_;
};

}  // namespace zstrip::sim
