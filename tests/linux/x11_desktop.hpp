// A desktop of X11 without a screen, and what its user sees and does.
#pragma once

#include <memory>
#include <string>

#include "colour_picture.hpp"

namespace zstrip::linux_window {

class X11Desktop {
 public:
  /// Throws std::runtime_error where it does not start, as the other functions when a thing is not there in 10 seconds.
  X11Desktop();
  ~X11Desktop();

  /// DISPLAY=...
  std::string variable() const;
  /// What is seen of the window with this title; without one of all of the screen. The pointer goes to its corner, not
  /// to be seen on a picture.
  boards::ColourPicture seen(const std::string& title);
  /// Lays a window over that one, and takes it away.
  void cover_and_uncover(const std::string& title);
  /// As a click on its cross.
  void close(const std::string& title);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace zstrip::linux_window
