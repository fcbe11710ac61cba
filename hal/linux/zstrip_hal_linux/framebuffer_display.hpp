// A Linux framebuffer, /dev/fbN, as a display.
#pragma once

#include <linux/fb.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "zstrip_hal/display.hpp"
#include "zstrip_hal_linux/device.hpp"
#include "zstrip_hal_linux/screen_size.hpp"
#include "zstrip_hal_linux/video_memory.hpp"

namespace zstrip::hal {

/// Takes RGB565 and converts it to whatever true colour the driver has, 16, 24 or 32 bits a pixel. Pixels show as they
/// are written: there is one buffer, so that a frame may tear. The text console is not its business: see
/// GraphicsConsole. When the object ends, the screen is black and has the mode that it had before.
class FramebufferDisplay {
 public:
  /// The driver's present mode, or one of `size`. What counts is what the driver says afterwards that it has: many
  /// report success and change nothing. Errors: the device is missing, no permission, it is no framebuffer, its pixels
  /// are a palette or planes, the driver does not take the size, its description of its memory makes no sense.
  static Outcome<FramebufferDisplay> open(const std::string& path, std::optional<ScreenSize> size = std::nullopt);

  FramebufferDisplay(FramebufferDisplay&&) = default;
  FramebufferDisplay& operator=(FramebufferDisplay&&) = delete;
  ~FramebufferDisplay();

  std::uint16_t width() const { return memory_.width; }
  std::uint16_t height() const { return memory_.height; }
  PixelFormat format() const { return PixelFormat::rgb565; }
  const PixelLayout& layout() const { return layout_; }  ///< the driver's

  Error begin_frame() { return Error::none; }
  Error write(const Area& area, std::span<const std::byte> pixels) { return writer_.write(memory_, area, pixels); }
  Error wait() { return Error::none; }
  /// Drivers that watch which pages were written pass them on now, not some time later.
  Error end_frame();

 private:
  FramebufferDisplay(FileDescriptor file, Mapping mapping, const VideoMemory& memory, const PixelLayout& layout,
                     const PixelWriter& writer, const std::optional<fb_var_screeninfo>& former_mode);
  void blacken();

  FileDescriptor file_;
  Mapping mapping_;
  VideoMemory memory_;
  PixelLayout layout_;
  PixelWriter writer_;
  std::optional<fb_var_screeninfo> former_mode_;  ///< if it was changed
};

static_assert(Display<FramebufferDisplay>);

}  // namespace zstrip::hal
