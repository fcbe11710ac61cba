// A screen through the kernel's mode setting (DRM/KMS), with two dumb buffers that are flipped.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "zstrip_hal/display.hpp"
#include "zstrip_hal_linux/device.hpp"
#include "zstrip_hal_linux/screen_size.hpp"
#include "zstrip_hal_linux/video_memory.hpp"

namespace zstrip::hal {

struct DrmHead;    // a connector, and the card's file
struct DrmScreen;  // the card, the CRTC and its former picture

/// Lists the connectors of a graphics card, with one line of text for each.
Outcome<std::vector<std::string>> drm_connectors(const std::string& path);

/// Pixel format of the card's buffers.
enum class DrmFormat : std::uint8_t {
  rgb565,    ///< two bytes a pixel
  xrgb8888,  ///< four bytes a pixel
};

/// Selects connector, size and format.
struct DrmOptions {
  std::string connector;            ///< as in "HDMI-A-1"; empty: the first one with a screen
  std::optional<ScreenSize> size;   ///< one of the screen's modes; none: the preferred one
  std::optional<DrmFormat> format;  ///< none: the driver's preferred format, or else the other one
};

/// Takes RGB565. A frame appears whole, at a vertical blank: end_frame() requests the flip and returns. The next
/// end_frame() waits for that flip, at most kFlipTimeout milliseconds; then it returns Error::flip, and the next frame
/// waits again. Error::bus: the driver refuses the flip, for example because another program has taken the screen.
/// The object keeps the pixels in the processor's own memory, too: a frame may write only changed areas, and the card's
/// buffers, which are slow to read, are never read. When the object ends, the CRTC shows its former picture again.
class DrmDisplay {
 public:
  static constexpr int kFlipTimeout = 1000;  ///< ms

  /// Errors: the device is missing, no permission, another program shows pictures, no such connector or size, no
  /// screen connected, a driver without dumb buffers or with neither of the formats.
  static Outcome<DrmDisplay> open(const std::string& path, const DrmOptions& options = {});
  /// Opens every connector with a screen, all in the size of the options, or else in the first size of the first
  /// screen that all have. Errors: as above; the screens have no size in common. `options.connector` is ignored.
  static Outcome<std::vector<DrmDisplay>> open_all(const std::string& path, const DrmOptions& options = {});

  /// The new object takes over the screen.
  DrmDisplay(DrmDisplay&&) noexcept;
  DrmDisplay& operator=(DrmDisplay&&) = delete;
  ~DrmDisplay();

  /// @{
  /// See the concept Display.
  std::uint16_t width() const { return size_.width; }
  std::uint16_t height() const { return size_.height; }
  DisplayFormat format() const { return DisplayFormat::rgb565; }
  /// Returns the pixel format of the card's buffers.
  DrmFormat card_format() const { return card_format_; }

  Error begin_frame() { return Error::none; }
  Error write(const Area& area, std::span<const std::byte> pixels);
  Error wait() { return Error::none; }
  Error end_frame();
  /// @}

 private:
  /// The pixels of a row that a buffer of the card does not have yet. Empty if right <= left.
  struct Stale {
    std::uint16_t left = 0;
    std::uint16_t right = 0;
  };

  DrmDisplay(std::unique_ptr<DrmScreen> screen, const ScreenSize& size, DrmFormat card_format,
             const PixelWriter& writer);
  static Outcome<DrmDisplay> start(const DrmHead& head, const DrmOptions& options);
  Error bring_up_to_date(std::size_t buffer);

  std::unique_ptr<DrmScreen> screen_;
  ScreenSize size_;
  DrmFormat card_format_;
  PixelWriter writer_;
  std::vector<std::byte> picture_;  ///< RGB565
  std::array<std::vector<Stale>, 2> stale_;
};

static_assert(Display<DrmDisplay>);

}  // namespace zstrip::hal
