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

/// The mode that is asked for.
struct FramebufferOptions {
  std::optional<ScreenSize> size;      ///< none: as it is
  std::optional<std::uint32_t> depth;  ///< bits a pixel, 16, 24 or 32; none: as it is
};

/// A framebuffer's file, and the mode that it had: set again when the object ends, so on every way out.
class FramebufferFile {
 public:
  /// Takes the file.
  FramebufferFile(FileDescriptor file, const fb_var_screeninfo& former_mode)
      : file_(std::move(file)), former_mode_(former_mode) {}
  /// The other one sets nothing any more.
  FramebufferFile(FramebufferFile&&) = default;
  FramebufferFile& operator=(FramebufferFile&&) = delete;
  ~FramebufferFile();

  /// The file's number.
  int get() const { return file_.get(); }
  /// Whether it is open.
  explicit operator bool() const { return static_cast<bool>(file_); }

 private:
  FileDescriptor file_;
  fb_var_screeninfo former_mode_;
};

/// Takes RGB565 and converts it to whatever true colour the driver has, 16, 24 or 32 bits a pixel. Pixels show as they
/// are written: there is one buffer, so that a frame may tear. The text console is not its business: enter
/// GraphicsConsole first, which else takes the new mode for its own. When the object ends, the screen is black and has
/// the mode that it had before.
class FramebufferDisplay {
 public:
  /// The driver's present mode, or another. What counts is the mode that is read back afterwards: many drivers
  /// report success and change nothing. (Framebuffers on top of DRM take any smaller size: the picture is in the upper
  /// left corner then, on black.) Errors: the device is missing, no permission, it is no framebuffer, its pixels
  /// are a palette or planes, the driver does not take the mode, its description of its memory makes no sense. It has
  /// its former mode then.
  static Outcome<FramebufferDisplay> open(const std::string& path, const FramebufferOptions& options = {});

  /// The screen goes along.
  FramebufferDisplay(FramebufferDisplay&&) = default;
  FramebufferDisplay& operator=(FramebufferDisplay&&) = delete;
  ~FramebufferDisplay();

  /// @{
  /// As the concept Display states.
  std::uint16_t width() const { return memory_.width; }
  std::uint16_t height() const { return memory_.height; }
  PixelFormat format() const { return PixelFormat::rgb565; }
  const PixelLayout& layout() const { return layout_; }  ///< the driver's

  Error begin_frame() { return Error::none; }
  Error write(const Area& area, std::span<const std::byte> pixels) { return writer_.write(memory_, area, pixels); }
  Error wait() { return Error::none; }
  /// @}
  /// Drivers that watch which pages were written pass them on now, not some time later.
  Error end_frame();

 private:
  FramebufferDisplay(FramebufferFile file, Mapping mapping, std::span<std::byte> device_memory,
                     const VideoMemory& memory, const PixelLayout& layout, const PixelWriter& writer);
  void blacken();

  FramebufferFile file_;
  Mapping mapping_;
  std::span<std::byte> device_memory_;
  VideoMemory memory_;  ///< the part of it that shows
  PixelLayout layout_;
  PixelWriter writer_;
};

static_assert(Display<FramebufferDisplay>);

}  // namespace zstrip::hal
