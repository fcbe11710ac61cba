// A window of the desktop. The only place that knows SDL.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "image/rgb_image.hpp"
#include "result.hpp"
#include "view/window_picture.hpp"

namespace zstrip::sim {

/// What a person does.
struct Input {
  enum class Kind : std::uint8_t { key, drag, wheel, exposed, closed };
  Kind kind = Kind::exposed;
  std::string key{};  ///< as SDL names it, letters small, or large with the shift key: "w", "S", "Right", "Space"
  double x = 0;       ///< of a drag: pixels to the right
  double y = 0;       ///< of a drag: pixels downwards; of the wheel: steps away from the person
};

/// "w", "right", "drag=40:-10", "wheel=2": as in --press. Nothing if it is none.
std::optional<Input> parse_input(const std::string& word);

/// Used by one thread, the one that opened it.
class Window {
 public:
  /// Connects to the desktop; nothing is shown yet. ExitStatus::environment without one; where one does not answer, the
  /// program ends with that status after some seconds.
  static Result<Window> open(const std::string& title);

  /// The largest window that lies within the screen, beside the desktop's bars, with a frame around it.
  WindowSize room() const;
  /// Asks the desktop for this size, which may give another; the first call shows the window. Input::Kind::exposed
  /// tells of each change.
  Result<Done> resize(const WindowSize& size);
  /// The size that it has.
  WindowSize size() const;
  /// Pixel for pixel; made for size(), or else in the middle.
  Result<Done> show(const RgbImage& pixels);
  /// Waits for at most so long; nothing happened if it returns nothing.
  std::optional<Input> wait(std::uint32_t milliseconds);
  /// As if a person did it: wait() returns it after what has happened already.
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
