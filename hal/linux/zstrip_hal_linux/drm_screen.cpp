// A connector, its CRTC and two dumb buffers of a graphics card: sets the mode, flips, and restores the former mode.
#include "zstrip_hal_linux/drm_screen.hpp"

#include <drm_fourcc.h>
#include <poll.h>
#include <xf86drm.h>

#include <cerrno>
#include <chrono>
#include <utility>

namespace zstrip::hal {

int DumbBuffer::create(int card, const ScreenSize& size, DrmFormat format, DumbBuffer& buffer) {
  DumbBuffer made;
  const bool is_565 = format == DrmFormat::rgb565;
  std::uint32_t pitch = 0;
  std::uint64_t bytes = 0;
  if (drmModeCreateDumbBuffer(card, size.width, size.height, is_565 ? 16 : 32, 0, &made.handle_, &pitch, &bytes) != 0)
    return errno;
  made.card_ = card;
  const std::uint32_t handles[4]{made.handle_};
  const std::uint32_t pitches[4]{pitch};
  const std::uint32_t offsets[4]{};
  const std::uint32_t fourcc = is_565 ? DRM_FORMAT_RGB565 : DRM_FORMAT_XRGB8888;
  if (drmModeAddFB2(card, size.width, size.height, fourcc, handles, pitches, offsets, &made.framebuffer_, 0) != 0)
    return errno;
  std::uint64_t offset = 0;
  if (drmModeMapDumbBuffer(card, made.handle_, &offset) != 0) return errno;
  made.mapping_ = Mapping(card, static_cast<std::size_t>(bytes), static_cast<off_t>(offset));
  if (made.mapping_.bytes().empty()) return errno;
  made.memory_ = {made.mapping_.bytes(), size.width, size.height, pitch};
  buffer = std::move(made);
  return 0;
}

DumbBuffer& DumbBuffer::operator=(DumbBuffer&& other) noexcept {
  std::swap(card_, other.card_);
  std::swap(handle_, other.handle_);
  std::swap(framebuffer_, other.framebuffer_);
  std::swap(mapping_, other.mapping_);
  std::swap(memory_, other.memory_);
  return *this;
}

DumbBuffer::~DumbBuffer() {
  if (card_ < 0) return;
  if (framebuffer_ != 0) drmModeRmFB(card_, framebuffer_);
  drmModeDestroyDumbBuffer(card_, handle_);
}

DrmScreen::~DrmScreen() {
  if (!card) return;
  // A pending flip would show a buffer that no longer exists, so wait for it. If it does not come in time, another
  // screen of the same file may read its event later.
  if (wait_for_flip(DrmDisplay::kFlipTimeout) != Error::none) static_cast<void>(flipping.release());
  if (former != nullptr && former->mode_valid != 0) {
    drmModeSetCrtc(card->get(), crtc, former->buffer_id, former->x, former->y, &connector, 1, &former->mode);
  } else if (crtc != 0) {
    drmModeSetCrtc(card->get(), crtc, 0, 0, 0, nullptr, 0, nullptr);
  }
  buffers = {};  // before the card is closed
}

int DrmScreen::show(DumbBuffer& buffer) {
  return drmModeSetCrtc(card->get(), crtc, buffer.framebuffer(), 0, 0, &connector, 1, &mode) == 0 ? 0 : errno;
}

Error DrmScreen::flip() {
  if (drmModePageFlip(card->get(), crtc, buffers[back].framebuffer(), DRM_MODE_PAGE_FLIP_EVENT, flipping.get()) != 0)
    return Error::bus;
  *flipping = true;
  back = 1 - back;
  return Error::none;
}

Error DrmScreen::wait_for_flip(int milliseconds) {
  using Clock = std::chrono::steady_clock;
  const auto deadline = Clock::now() + std::chrono::milliseconds(milliseconds);
  drmEventContext events{};
  events.version = 2;
  events.page_flip_handler = [](int, unsigned, unsigned, unsigned, void* of_screen) {
    *static_cast<bool*>(of_screen) = false;
  };
  // Wait for the flip itself, not until the file is readable: it may hold other events, or none.
  for (bool in_time = true; *flipping; in_time = Clock::now() < deadline) {
    if (!in_time) return Error::flip;
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now()).count();
    pollfd waiting{card->get(), POLLIN, 0};
    const int ready = poll(&waiting, 1, left > 0 ? static_cast<int>(left) : 0);
    if (ready < 0 && errno != EINTR) return Error::bus;
    if (ready > 0 && drmHandleEvent(card->get(), &events) != 0) return Error::bus;
  }
  return Error::none;
}

}  // namespace zstrip::hal
