// Chooses connector, mode, CRTC and format of a graphics card, and keeps a copy of the picture for its buffers.
#include "zstrip_hal_linux/drm_display.hpp"

#include <xf86drm.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "zstrip_hal_linux/drm_screen.hpp"

namespace zstrip::hal {
namespace {

constexpr DeviceKind kGraphicsCard = DeviceKind::graphics_card;

std::string name_of(const drmModeConnector& connector) {
  const char* type = drmModeGetConnectorTypeName(connector.connector_type);
  return std::string(type != nullptr ? type : "Unknown") + "-" + std::to_string(connector.connector_type_id);
}

bool is_usable(const drmModeConnector& connector) {
  return connector.connection == DRM_MODE_CONNECTED && connector.count_modes > 0;
}

std::span<const drmModeModeInfo> modes_of(const drmModeConnector& connector) {
  return {connector.modes, static_cast<std::size_t>(std::max(connector.count_modes, 0))};
}

ScreenSize size_of(const drmModeModeInfo& mode) { return {mode.hdisplay, mode.vdisplay}; }

const drmModeModeInfo& preferred_mode(std::span<const drmModeModeInfo> modes) {
  const auto preferred = std::ranges::find_if(
      modes, [](const drmModeModeInfo& mode) { return (mode.type & DRM_MODE_TYPE_PREFERRED) != 0; });
  return preferred != modes.end() ? *preferred : modes.front();
}

/// Lists every size once, in the screen's order.
std::string sizes_of(const drmModeConnector& connector) {
  std::vector<std::string> sizes;
  for (const drmModeModeInfo& mode : modes_of(connector)) {
    const std::string size = to_string(size_of(mode));
    if (std::ranges::find(sizes, size) == sizes.end()) sizes.push_back(size);
  }
  std::string text;
  for (const std::string& size : sizes) text += (text.empty() ? "" : ", ") + size;
  return text;
}

std::vector<DrmConnector> connectors_of(int card, const drmModeRes& resources) {
  std::vector<DrmConnector> connectors;
  for (int i = 0; i < resources.count_connectors; ++i) {
    DrmConnector connector(drmModeGetConnector(card, resources.connectors[i]));
    if (connector != nullptr) connectors.push_back(std::move(connector));
  }
  return connectors;
}

/// Returns the CRTC that drives this connector, or 0 if none does.
std::uint32_t current_crtc(int card, const drmModeConnector& connector) {
  const DrmEncoder encoder(connector.encoder_id != 0 ? drmModeGetEncoder(card, connector.encoder_id) : nullptr);
  return encoder != nullptr ? encoder->crtc_id : 0;
}

/// Returns the CRTC that drives the connector, or else the first usable CRTC that drives no other connector: taking a
/// CRTC from another screen would make that screen dark, and later restore its picture on the wrong connector. Returns
/// 0 if there is none.
std::uint32_t crtc_for(int card, const drmModeRes& resources, const drmModeConnector& connector) {
  if (const std::uint32_t crtc = current_crtc(card, connector); crtc != 0) return crtc;
  std::vector<std::uint32_t> taken;
  for (const DrmConnector& other : connectors_of(card, resources)) taken.push_back(current_crtc(card, *other));
  for (int i = 0; i < connector.count_encoders; ++i) {
    const DrmEncoder encoder(drmModeGetEncoder(card, connector.encoders[i]));
    if (encoder == nullptr) continue;
    for (int index = 0; index < resources.count_crtcs && index < 32; ++index) {
      const std::uint32_t crtc = resources.crtcs[index];
      if ((encoder->possible_crtcs >> index & 1U) != 0 && std::ranges::find(taken, crtc) == taken.end()) return crtc;
    }
  }
  return 0;
}

/// Returns a line such as "VGA-1: 1024x768, 800x600".
std::string line_of(const drmModeConnector& connector) {
  return name_of(connector) + ": " + (is_usable(connector) ? sizes_of(connector) : "no screen");
}

Outcome<DrmResources> resources_of(int card, const std::string& path) {
  DrmResources resources(drmModeGetResources(card));
  if (resources == nullptr)
    return Fault{path + " sets no modes: it only computes; choose another card, as --list shows"};
  return resources;
}

/// Keeps the connectors with a screen, in the card's order; a Fault if none has one.
Outcome<std::vector<DrmConnector>> usable_connectors(std::vector<DrmConnector> connectors, const std::string& path) {
  std::string found;
  for (const DrmConnector& connector : connectors) found += (found.empty() ? "" : ", ") + name_of(*connector);
  if (found.empty()) return Fault{path + " has no connector for a screen"};
  std::erase_if(connectors, [](const DrmConnector& connector) { return !is_usable(*connector); });
  if (connectors.empty()) return Fault{path + ": no screen is connected to " + found};
  return connectors;
}

Outcome<DrmConnector> choose_connector(std::vector<DrmConnector> connectors, const std::string& path,
                                       const std::string& wanted) {
  if (wanted.empty()) {
    Outcome<std::vector<DrmConnector>> usable = usable_connectors(std::move(connectors), path);
    if (!usable) return usable.fault();
    return std::move(usable->front());
  }
  std::string found;
  for (DrmConnector& connector : connectors) {
    const std::string name = name_of(*connector);
    if (name == wanted) {
      if (!is_usable(*connector)) return Fault{std::string(path).append(": no screen is connected to ").append(name)};
      return std::move(connector);
    }
    found += (found.empty() ? "" : ", ") + name + (is_usable(*connector) ? "" : " (no screen)");
  }
  if (found.empty()) return Fault{path + " has no connector for a screen"};
  return Fault{path + " has no connector " + wanted + ", only " + found};
}

const drmModeModeInfo* mode_of(const drmModeConnector& connector, const ScreenSize& size) {
  const std::span<const drmModeModeInfo> modes = modes_of(connector);
  const auto mode = std::ranges::find(modes, size, size_of);
  return mode != modes.end() ? &*mode : nullptr;
}

/// Returns a size that all screens have: the first screen's preferred size, or else the first such size in its list.
std::optional<ScreenSize> common_size(const std::vector<DrmConnector>& connectors) {
  const auto is_common = [&connectors](const drmModeModeInfo& mode) {
    return std::ranges::all_of(
        connectors, [&mode](const DrmConnector& connector) { return mode_of(*connector, size_of(mode)) != nullptr; });
  };
  const std::span<const drmModeModeInfo> modes = modes_of(*connectors.front());
  if (is_common(preferred_mode(modes))) return size_of(preferred_mode(modes));
  const auto common = std::ranges::find_if(modes, is_common);
  if (common == modes.end()) return std::nullopt;
  return size_of(*common);
}

std::vector<DrmFormat> formats_to_try(int card, const std::optional<DrmFormat>& wanted) {
  if (wanted) return {*wanted};
  std::uint64_t depth = 0;
  const bool prefers_16 = drmGetCap(card, DRM_CAP_DUMB_PREFERRED_DEPTH, &depth) == 0 && depth == 16;
  if (prefers_16) return {DrmFormat::rgb565, DrmFormat::xrgb8888};
  return {DrmFormat::xrgb8888, DrmFormat::rgb565};
}

int start_in(DrmScreen& screen, DrmFormat format) {
  for (DumbBuffer& buffer : screen.buffers) {
    buffer = {};
    if (const int error = DumbBuffer::create(screen.card->get(), size_of(screen.mode), format, buffer); error != 0)
      return error;
  }
  return screen.show(screen.buffers[0]);
}

struct Card {
  std::shared_ptr<const FileDescriptor> file;
  DrmResources resources;
};

Outcome<Card> open_card(const std::string& path) {
  Outcome<FileDescriptor> file = open_device(kGraphicsCard, path);
  if (!file) return file.fault();
  Outcome<DrmResources> resources = resources_of(file->get(), path);
  if (!resources) return resources.fault();
  return Card{std::make_shared<const FileDescriptor>(std::move(*file)), std::move(*resources)};
}

/// Opens a card that can show pictures.
Outcome<Card> open_screens(const std::string& path) {
  Outcome<Card> card = open_card(path);
  if (!card) return card;
  std::uint64_t has_dumb_buffers = 0;
  if (drmGetCap(card->file->get(), DRM_CAP_DUMB_BUFFER, &has_dumb_buffers) != 0 || has_dumb_buffers == 0)
    return Fault{path + " has no dumb buffers; use its framebuffer (fbdev:/dev/fb0) if it has one"};
  return card;
}

}  // namespace

struct DrmHead {
  const std::string& path;
  std::shared_ptr<const FileDescriptor> card;
  const drmModeRes& resources;
  const drmModeConnector& connector;
};

Outcome<std::vector<std::string>> drm_connectors(const std::string& path) {
  const Outcome<Card> card = open_card(path);
  if (!card) return card.fault();
  std::vector<std::string> lines;
  for (const DrmConnector& connector : connectors_of(card->file->get(), *card->resources))
    lines.push_back(line_of(*connector));
  return lines;
}

Outcome<DrmDisplay> DrmDisplay::open(const std::string& path, const DrmOptions& options) {
  Outcome<Card> card = open_screens(path);
  if (!card) return card.fault();
  const Outcome<DrmConnector> chosen =
      choose_connector(connectors_of(card->file->get(), *card->resources), path, options.connector);
  if (!chosen) return chosen.fault();
  return start({path, card->file, *card->resources, **chosen}, options);
}

Outcome<std::vector<DrmDisplay>> DrmDisplay::open_all(const std::string& path, const DrmOptions& options) {
  const Outcome<Card> card = open_screens(path);
  if (!card) return card.fault();
  const auto connectors = usable_connectors(connectors_of(card->file->get(), *card->resources), path);
  if (!connectors) return connectors.fault();
  DrmOptions common = options;
  if (!common.size) common.size = common_size(*connectors);
  if (!common.size) {
    std::string sizes;
    for (const DrmConnector& connector : *connectors) sizes += (sizes.empty() ? "" : "; ") + line_of(*connector);
    return Fault{path + ": the screens have no size in common (" + sizes + "); choose a connector"};
  }
  std::vector<DrmDisplay> displays;
  for (const DrmConnector& connector : *connectors) {
    // All displays share one file, because the right to show pictures belongs to the file. Each display also reads the
    // flip events of the others, and passes them on.
    Outcome<DrmDisplay> display = start({path, card->file, *card->resources, *connector}, common);
    if (!display) return display.fault();
    displays.push_back(std::move(*display));
  }
  return displays;
}

Outcome<DrmDisplay> DrmDisplay::start(const DrmHead& head, const DrmOptions& options) {
  const auto& [path, card, resources, connector] = head;
  const int number = card->get();
  auto screen = std::make_unique<DrmScreen>();
  screen->mode = preferred_mode(modes_of(connector));
  if (options.size) {
    const drmModeModeInfo* const mode = mode_of(connector, *options.size);
    if (mode == nullptr) {
      return Fault{path + ": the screen at " + name_of(connector) + " has no mode of " + to_string(*options.size) +
                   ", only " + sizes_of(connector)};
    }
    screen->mode = *mode;
  }
  const ScreenSize size = size_of(screen->mode);
  if (size.width == 0 || size.height == 0 || size.width > kMaxScreen || size.height > kMaxScreen)
    return Fault{path + ": the mode " + to_string(size) + " is too large; choose a size, one of " +
                 sizes_of(connector)};

  const std::uint32_t crtc = crtc_for(number, resources, connector);
  if (crtc == 0)
    return Fault{path + " has no CRTC left for " + name_of(connector) + ": the other screens take all of them"};
  if (drmIsMaster(number) == 0) return device_fault(kGraphicsCard, path, "show pictures", EBUSY);

  screen->connector = connector.connector_id;
  screen->former.reset(drmModeGetCrtc(number, crtc));
  screen->crtc = crtc;
  screen->card = card;
  int error = 0;
  for (const DrmFormat format : formats_to_try(number, options.format)) {
    error = start_in(*screen, format);
    if (error != 0) continue;
    const std::optional<PixelWriter> writer =
        PixelWriter::create(format == DrmFormat::rgb565 ? kRgb565Layout : kXrgb8888Layout);
    return DrmDisplay(std::move(screen), size, format, *writer);
  }
  return device_fault(kGraphicsCard, path, "show pictures of " + to_string(size), error);
}

DrmDisplay::DrmDisplay(std::unique_ptr<DrmScreen> screen, const ScreenSize& size, DrmFormat card_format,
                       const PixelWriter& writer)
    : screen_(std::move(screen)),
      size_(size),
      card_format_(card_format),
      writer_(writer),
      picture_(std::size_t{2} * size.width * size.height) {
  stale_.fill(std::vector<Stale>(size.height));
}

DrmDisplay::DrmDisplay(DrmDisplay&&) noexcept = default;
DrmDisplay::~DrmDisplay() = default;

Error DrmDisplay::write(const Area& area, std::span<const std::byte> pixels) {
  if (!contains(size_.width, size_.height, area)) return Error::area;
  const std::size_t row_bytes = std::size_t{2} * area.width;
  if (pixels.size() < row_bytes * area.height) return Error::pixels_too_small;
  const auto right = static_cast<std::uint16_t>(area.left + area.width);
  for (std::size_t y = 0; y < area.height; ++y) {
    const std::size_t row = area.top + y;
    std::memcpy(&picture_[2 * (row * size_.width + area.left)], &pixels[y * row_bytes], row_bytes);
    for (std::vector<Stale>& rows : stale_) {
      Stale& stale = rows[row];
      const bool empty = stale.right <= stale.left;
      stale = {empty ? area.left : std::min(stale.left, area.left), empty ? right : std::max(stale.right, right)};
    }
  }
  return Error::none;
}

Error DrmDisplay::bring_up_to_date(std::size_t buffer) {
  for (std::size_t y = 0; y < size_.height; ++y) {
    Stale& stale = stale_[buffer][y];
    if (stale.right <= stale.left) continue;
    const Area area{stale.left, static_cast<std::uint16_t>(y), static_cast<std::uint16_t>(stale.right - stale.left), 1};
    const auto pixels = std::span<const std::byte>(picture_).subspan(2 * (y * size_.width + stale.left));
    if (const Error error = writer_.write(screen_->buffers[buffer].memory(), area, pixels); error != Error::none)
      return error;
    stale = {};
  }
  return Error::none;
}

Error DrmDisplay::end_frame() {
  // Until the flip has happened, the back buffer is still on the screen.
  if (const Error error = screen_->wait_for_flip(kFlipTimeout); error != Error::none) return error;
  if (const Error error = bring_up_to_date(screen_->back); error != Error::none) return error;
  return screen_->flip();
}

}  // namespace zstrip::hal
