// A desktop of X11 without a screen, perhaps with a window manager, and what its user sees and does.
#pragma once

#include <memory>
#include <string>

#include "colour_picture.hpp"

namespace zstrip::linux_window {

class X11Desktop {
 public:
  /// `size`: of the screen, WIDTHxHEIGHT. `manager`: the program that manages windows; none if empty. Throws
  /// std::runtime_error where it does not start, as the other functions when a thing is not there in 10 seconds.
  explicit X11Desktop(const std::string& size = "800x600", const std::string& manager = {});
  ~X11Desktop();

  /// DISPLAY=...
  std::string variable() const;
  /// What is seen of the window with this title; without one of all of the screen. The pointer goes to its corner, not
  /// to be seen on a picture.
  boards::ColourPicture seen(const std::string& title);
  /// Lays a window over that one, and takes it away.
  void cover_and_uncover(const std::string& title);
  struct Place {
    int left, top, right, bottom;  ///< pixels of the screen; right and bottom are one beyond
  };
  /// With the frame that the manager draws around it.
  Place place(const std::string& title);
  /// As if the user drags the corner of its frame.
  void resize(const std::string& title, int width, int height);
  /// As a click on its cross.
  void close(const std::string& title);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace zstrip::linux_window
