// A Linux framebuffer, /dev/fbN, as a display.
#pragma once

#include <linux/fb.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "zstrip_hal/display.hpp"
#include "zstrip_hal_linux/device.hpp"
#include "zstrip_hal_linux/screen_size.hpp"
#include "zstrip_hal_linux/video_memory.hpp"

namespace zstrip::hal {

/// The requested mode.
struct FramebufferOptions {
  std::optional<ScreenSize> size;      ///< none: unchanged
  std::optional<std::uint32_t> depth;  ///< bits a pixel, 16, 24 or 32; none: unchanged
};

/// A framebuffer's file and its former mode, which the destructor sets again.
class FramebufferFile {
 public:
  /// Takes the file.
  FramebufferFile(FileDescriptor file, const fb_var_screeninfo& former_mode)
      : file_(std::move(file)), former_mode_(former_mode) {}
  /// The moved-from object no longer sets a mode.
  FramebufferFile(FramebufferFile&&) = default;
  FramebufferFile& operator=(FramebufferFile&&) = delete;
  ~FramebufferFile();

  /// Returns the number of the file.
  int get() const { return file_.get(); }
  /// True if the file is open.
  explicit operator bool() const { return static_cast<bool>(file_); }

 private:
  FileDescriptor file_;
  fb_var_screeninfo former_mode_;
};

/// Takes RGB565 and converts it to the driver's true colour format, 16, 24 or 32 bits a pixel. Pixels are visible as
/// soon as they are written: there is one buffer, so that a frame may tear. Enter GraphicsConsole first: this class
/// does not touch the text console, which would otherwise take over the new mode. When the object ends, the screen is
/// black and has its former mode.
class FramebufferDisplay {
 public:
  /// Keeps the driver's present mode, or sets another. Uses the mode that it reads back afterwards: many drivers
  /// report success and change nothing. (Framebuffers on top of DRM take any smaller size: the picture is in the upper
  /// left corner then, on black.) Errors: the device is missing, no permission, the file is not a framebuffer, its
  /// pixels are a palette or planes, the driver does not take the mode, its description of its memory makes no sense.
  /// After an error the device has its former mode.
  static Outcome<FramebufferDisplay> open(const std::string& path, const FramebufferOptions& options = {});

  /// The new object takes over the screen.
  FramebufferDisplay(FramebufferDisplay&&) = default;
  FramebufferDisplay& operator=(FramebufferDisplay&&) = delete;
  ~FramebufferDisplay();

  /// @{
  /// See the concept Display.
  std::uint16_t width() const { return memory_.width; }
  std::uint16_t height() const { return memory_.height; }
  DisplayFormat format() const { return DisplayFormat::rgb565; }
  const PixelLayout& layout() const { return layout_; }  ///< of the driver

  Error begin_frame() { return Error::none; }
  Error write(const Area& area, std::span<const std::byte> pixels) { return writer_.write(memory_, area, pixels); }
  Error wait() { return Error::none; }
  /// @}
  /// Calls fsync: a driver that tracks written pages then updates the screen at once instead of later.
  Error end_frame();

 private:
  FramebufferDisplay(FramebufferFile file, Mapping mapping, std::span<std::byte> device_memory,
                     const VideoMemory& memory, const PixelLayout& layout, const PixelWriter& writer);
  void blacken();

  FramebufferFile file_;
  Mapping mapping_;
  std::span<std::byte> device_memory_;
  VideoMemory memory_;  ///< the visible part of the device's memory
  PixelLayout layout_;
  PixelWriter writer_;
};

static_assert(Display<FramebufferDisplay>);

}  // namespace zstrip::hal
