// A window of the desktop. The only place that knows SDL.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "image/rgb_image.hpp"
#include "result.hpp"

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
  /// ExitStatus::environment without a display.
  static Result<Window> open(const std::string& title);

  /// Resizes the window to the picture and shows it.
  Result<Done> show(const RgbImage& picture);
  /// What is shown, read back. ExitStatus::environment where that fails.
  Result<RgbImage> shown() const;
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
