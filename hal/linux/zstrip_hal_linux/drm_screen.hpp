// A connector, its CRTC and two dumb buffers of a graphics card: sets the mode, flips, and restores the former mode.
#pragma once

#include <xf86drmMode.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>

#include "zstrip_hal_linux/device.hpp"
#include "zstrip_hal_linux/drm_display.hpp"
#include "zstrip_hal_linux/release.hpp"

namespace zstrip::hal {

using DrmResources = Owned<drmModeRes, drmModeFreeResources>;
using DrmConnector = Owned<drmModeConnector, drmModeFreeConnector>;
using DrmEncoder = Owned<drmModeEncoder, drmModeFreeEncoder>;
using DrmCrtc = Owned<drmModeCrtc, drmModeFreeCrtc>;

/// Memory of the card that it can show. The kernel fills it with zeros.
class DumbBuffer {
 public:
  /// Returns 0 or errno.
  static int create(int card, const ScreenSize& size, DrmFormat format, DumbBuffer& buffer);

  DumbBuffer() = default;
  DumbBuffer(DumbBuffer&& other) noexcept { *this = std::move(other); }
  DumbBuffer& operator=(DumbBuffer&& other) noexcept;
  ~DumbBuffer();

  std::uint32_t framebuffer() const { return framebuffer_; }
  const VideoMemory& memory() const { return memory_; }

 private:
  int card_ = -1;
  std::uint32_t handle_ = 0;
  std::uint32_t framebuffer_ = 0;
  Mapping mapping_;
  VideoMemory memory_;
};

struct DrmScreen {
  ~DrmScreen();

  /// Shows the picture of `buffer` in `mode`. Returns 0 or errno.
  int show(DumbBuffer& buffer);
  /// Requests that the back buffer is shown at the next vertical blank. No flip may be under way.
  Error flip();
  /// Returns when no flip is under way.
  Error wait_for_flip(int milliseconds);

  std::shared_ptr<const FileDescriptor> card;  ///< shared by all screens that are open at once
  std::uint32_t connector = 0;
  std::uint32_t crtc = 0;
  drmModeModeInfo mode{};
  DrmCrtc former;
  std::array<DumbBuffer, 2> buffers;
  std::size_t back = 1;  ///< index of the buffer that is not shown, or will not be after the pending flip
  std::unique_ptr<bool> flipping = std::make_unique<bool>(false);  ///< a flip is under way
};

}  // namespace zstrip::hal
