// A machine in the emulator with a real Debian kernel and zstrip-panel on it, as guest.sh made it; commands go over its
// console.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "colour_picture.hpp"
#include "qemu.hpp"

namespace zstrip::linux_guest {

enum class Machine : std::uint8_t { amd64, armhf, arm64, sabrelite };  // sabrelite: with the kernel for armhf

/// Why there is no such machine, for a test to be skipped; empty if there is one.
std::string missing(Machine machine);
/// Why the machine for armhf has no zstrip-panel-gpiod2; empty if it has.
std::string missing_gpiod2();

class Guest {
 public:
  struct Options {
    Machine machine = Machine::amd64;
    std::string tree = "panels";         ///< the device tree's name, of armhf and arm64
    std::string modules{};               ///< of the kernel, with commas
    std::string kernel{};                ///< more words of the kernel's command line
    std::vector<std::string> devices{};  ///< more words of the emulator's command line
  };
  /// Returns when the machine has started. All functions throw std::runtime_error when it does not do its part in time.
  explicit Guest(const Options& options);

  struct Answer {
    std::string text;  ///< all lines
    int status = -1;
  };
  Answer run(const std::string& command);
  /// Empty if the screen shows the picture, or does so soon: drivers pass on what was written some time later. Else the
  /// difference.
  std::string screen_differs(const boards::ColourPicture& expected);
  /// Of one of several: `head` of the emulator's device "card".
  std::string head_differs(int head, const boards::ColourPicture& expected);

 private:
  /// All lines until one that begins with `last`; `what` is waited for, in words.
  Answer answer(const std::string& last, const std::string& what);
  std::string differs(const boards::ColourPicture& expected, const std::function<boards::ColourPicture()>& seen);

  boards::Qemu emulator_;
};

/// Frames of a turn of the guests' scene.
inline const std::string kTurn = "8";

/// A frame of the guests' scene as the host's command draws it.
boards::ColourPicture host_frame(int frame, int width, int height);
/// The same of one bit a pixel: rows of whole bytes, the leftmost pixel in the highest bit.
std::vector<std::byte> host_frame_mono(int frame, int width, int height);

}  // namespace zstrip::linux_guest
