// A graphics card whose page flips do not happen, or not in time: what the HAL makes of it.
#include <drm.h>
#include <drm_mode.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "mocked_devices.hpp"
#include "zstrip_hal_linux/drm_display.hpp"
#include "zstrip_hal_linux/mirrored_displays.hpp"

namespace zstrip::linux_mock {
namespace {

using hal::DrmDisplay;
using hal::Error;

constexpr std::uint16_t kWidth = 8, kHeight = 4;
constexpr std::uint32_t kPitch = 2 * kWidth, kBuffer = 4096;  // of each of two, of 16 bits a pixel
constexpr std::uint32_t kCrtc = 11, kConnector = 22, kEncoder = 33, kFirstBuffer = 100;
constexpr std::uint32_t kOther = 1000;  // added to each of these: those of a second screen

/// A card with one screen of one mode, as libdrm's system calls see it; or with two, of which the second is shown by
/// the first CRTC, and the first by none.
struct MockedCard {
  std::uint32_t crtcs = 1;
  bool two_screens = false;
  std::uint16_t second_width = kWidth;  ///< of the second screen
  std::uint32_t set_crtc = 0;           ///< the last one that was given a picture
  std::uint32_t buffers = 0;            ///< made so far
  struct Flip {
    std::uint32_t framebuffer = 0;
    std::uint64_t user_data = 0;
  };
  std::map<std::uint32_t, std::uint32_t> shown;  ///< CRTC: the framebuffer on its screen
  std::map<std::uint32_t, Flip> asked;           ///< CRTC: a flip that was not answered
  int flip_error = 0;

  static void put(std::uint64_t to, std::uint32_t value, std::uint32_t count = 1) {
    for (std::uint32_t i = 0; to != 0 && i < count; ++i) reinterpret_cast<std::uint32_t*>(to)[i] = value + i * kOther;
  }
  int control(unsigned long request, void* argument) {
    switch (request) {
      case DRM_IOCTL_MODE_GETRESOURCES: {
        auto& resources = *static_cast<drm_mode_card_res*>(argument);
        const std::uint32_t screens = two_screens ? 2 : 1;
        put(resources.crtc_id_ptr, kCrtc, crtcs);
        put(resources.connector_id_ptr, kConnector, screens);
        put(resources.encoder_id_ptr, kEncoder, screens);
        resources.count_crtcs = crtcs;
        resources.count_connectors = resources.count_encoders = screens;
        resources.count_fbs = 0;
        return 0;
      }
      case DRM_IOCTL_GET_CAP: {
        auto& capability = *static_cast<drm_get_cap*>(argument);
        capability.value = capability.capability == DRM_CAP_DUMB_PREFERRED_DEPTH ? 16 : 1;
        return 0;
      }
      case DRM_IOCTL_MODE_GETCONNECTOR: {
        auto& connector = *static_cast<drm_mode_get_connector*>(argument);
        if (connector.modes_ptr != 0 && connector.count_modes >= 1) {
          drm_mode_modeinfo mode{};
          mode.hdisplay = connector.connector_id != kConnector ? second_width : kWidth;
          mode.vdisplay = kHeight;
          std::memcpy(reinterpret_cast<void*>(connector.modes_ptr), &mode, sizeof mode);
        }
        const bool second = connector.connector_id != kConnector;
        put(connector.encoders_ptr, second ? kEncoder + kOther : kEncoder);
        connector.count_modes = connector.count_encoders = 1;
        connector.count_props = 0;
        connector.encoder_id = second ? kEncoder + kOther : two_screens ? 0 : kEncoder;
        connector.connection = 1;
        return 0;
      }
      case DRM_IOCTL_MODE_GETENCODER: {
        auto& encoder = *static_cast<drm_mode_get_encoder*>(argument);
        encoder.crtc_id = two_screens && encoder.encoder_id == kEncoder ? 0 : kCrtc;
        encoder.possible_crtcs = 3;
        return 0;
      }
      case DRM_IOCTL_AUTH_MAGIC: return EINVAL;  // and not EACCES: the caller is the card's master
      case DRM_IOCTL_MODE_GETCRTC: return 0;
      case DRM_IOCTL_MODE_SETCRTC:
        set_crtc = static_cast<drm_mode_crtc*>(argument)->crtc_id;
        shown[set_crtc] = static_cast<drm_mode_crtc*>(argument)->fb_id;
        return 0;
      case DRM_IOCTL_MODE_CREATE_DUMB: {
        auto& buffer = *static_cast<drm_mode_create_dumb*>(argument);
        buffer.handle = ++buffers;
        buffer.pitch = kPitch;
        buffer.size = kBuffer;
        return 0;
      }
      case DRM_IOCTL_MODE_ADDFB2: {
        auto& framebuffer = *static_cast<drm_mode_fb_cmd2*>(argument);
        framebuffer.fb_id = kFirstBuffer + framebuffer.handles[0];
        return 0;
      }
      case DRM_IOCTL_MODE_MAP_DUMB: {
        auto& map = *static_cast<drm_mode_map_dumb*>(argument);
        map.offset = std::uint64_t{map.handle - 1} * kBuffer;
        return 0;
      }
      case DRM_IOCTL_MODE_PAGE_FLIP: {
        const auto& flip = *static_cast<drm_mode_crtc_page_flip*>(argument);
        if (flip_error != 0) return flip_error;
        // Kernels refuse a second one.
        return asked.emplace(flip.crtc_id, Flip{flip.fb_id, flip.user_data}).second ? 0 : EBUSY;
      }
      case DRM_IOCTL_MODE_RMFB:
      case DRM_IOCTL_MODE_DESTROY_DUMB: return 0;
      default: return ENOTTY;
    }
  }
};

class LinuxMockedDrm : public testing::Test {
 protected:
  LinuxMockedDrm() {
    devices_.add(
        "drm", "dri/card0", 226, 0, [this](auto request, void* argument) { return card_.control(request, argument); },
        4 * kBuffer);
    file_ = devices_.file("dri/card0");
  }

  /// The card opened, and its file read to the end of its memory: behind that are events.
  hal::Outcome<DrmDisplay> open() {
    auto display = DrmDisplay::open("/dev/dri/card0");
    go_to_events();
    return display;
  }
  void go_to_events() const {
    for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd")) {
      std::error_code gone;
      if (std::filesystem::read_symlink(entry.path(), gone) == file_)
        ::lseek(std::stoi(entry.path().filename()), 0, SEEK_END);
    }
  }

  void send_event(std::uint32_t type, std::uint64_t user_data) const {
    drm_event_vblank event{};
    event.base = {.type = type, .length = sizeof event};
    event.user_data = user_data;
    event.crtc_id = kCrtc;
    std::ofstream(file_, std::ios::app | std::ios::binary).write(reinterpret_cast<const char*>(&event), sizeof event);
  }
  /// The flip happens.
  void flip(std::uint32_t crtc = kCrtc) {
    const auto asked = card_.asked.extract(crtc);
    ASSERT_FALSE(asked.empty());
    card_.shown[crtc] = asked.mapped().framebuffer;
    send_event(DRM_EVENT_FLIP_COMPLETE, asked.mapped().user_data);
  }

  /// What the screen shows.
  std::vector<std::uint16_t> screen(std::uint32_t crtc = kCrtc) const {
    std::vector<std::uint16_t> pixels(std::size_t{kWidth} * kHeight);
    std::ifstream stream(file_, std::ios::binary);
    stream.seekg(static_cast<std::streamoff>((card_.shown.at(crtc) - kFirstBuffer - 1) * kBuffer));
    stream.read(reinterpret_cast<char*>(pixels.data()), static_cast<std::streamsize>(pixels.size() * 2));
    return pixels;
  }

  /// A frame that changes one row.
  template <class Display>
  static Error show_row(Display& display, std::uint16_t row, std::uint16_t colour) {
    std::array<std::uint16_t, kWidth> pixels{};
    pixels.fill(colour);
    if (const Error error = display.begin_frame(); error != Error::none) return error;
    const Error written = display.write({0, row, kWidth, 1}, std::as_bytes(std::span(pixels)));
    const Error end = display.end_frame();
    return written != Error::none ? written : end;
  }
  static std::vector<std::uint16_t> rows(const std::array<std::uint16_t, kHeight>& colours) {
    std::vector<std::uint16_t> pixels;
    for (const std::uint16_t colour : colours) pixels.insert(pixels.end(), kWidth, colour);
    return pixels;
  }

  MockedCard card_;
  MockedDevices devices_;
  std::filesystem::path file_;
};

TEST_F(LinuxMockedDrm, FlipThatDoesNotHappenIsAnErrorThatNamesItAndTheNextFrameIsRight) {
  auto display = open();
  ASSERT_TRUE(display) << display.fault().message;
  EXPECT_EQ(show_row(*display, 0, 0x1111), Error::none);
  flip();
  EXPECT_EQ(show_row(*display, 1, 0x2222), Error::none);
  EXPECT_EQ(screen(), rows({0x1111, 0, 0, 0})) << "the second frame is not to be seen before its flip";

  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(show_row(*display, 2, 0x3333), Error::flip);
  const std::chrono::duration<double, std::milli> waited = std::chrono::steady_clock::now() - start;
  EXPECT_GE(waited.count(), DrmDisplay::kFlipTimeout);
  EXPECT_LT(waited.count(), 3 * DrmDisplay::kFlipTimeout);
  EXPECT_STREQ(hal::message(Error::flip), "the last page flip did not happen");
  EXPECT_EQ(screen(), rows({0x1111, 0, 0, 0})) << "what is shown was drawn upon";

  // It comes late, other events before it; the next frame has what the one that failed changed.
  send_event(DRM_EVENT_VBLANK, 0);
  flip();
  EXPECT_EQ(screen(), rows({0x1111, 0x2222, 0, 0}));
  EXPECT_EQ(show_row(*display, 3, 0x4444), Error::none);
  flip();
  EXPECT_EQ(screen(), rows({0x1111, 0x2222, 0x3333, 0x4444}));
  EXPECT_EQ(show_row(*display, 0, 0x5555), Error::none);
  flip();
  EXPECT_EQ(screen(), rows({0x5555, 0x2222, 0x3333, 0x4444})) << "the other buffer was not brought up to date";
}

TEST_F(LinuxMockedDrm, RefusedFlipIsAnErrorAndTheNextFrameIsRight) {
  auto display = open();
  ASSERT_TRUE(display) << display.fault().message;
  EXPECT_EQ(show_row(*display, 0, 0x1111), Error::none);
  flip();
  card_.flip_error = EACCES;  // another program has taken the screen
  EXPECT_EQ(show_row(*display, 1, 0x2222), Error::bus);
  card_.flip_error = 0;
  EXPECT_EQ(show_row(*display, 2, 0x3333), Error::none);
  flip();
  EXPECT_EQ(screen(), rows({0x1111, 0x2222, 0x3333, 0}));
}

/// It took the first one that could, and the second screen went dark.
TEST_F(LinuxMockedDrm, ACrtcThatDrivesAnotherScreenIsLeftAlone) {
  card_.two_screens = true;
  const auto none_left = open();
  ASSERT_FALSE(none_left);
  EXPECT_NE(none_left.fault().message.find("no CRTC left for "), std::string::npos) << none_left.fault().message;
  EXPECT_EQ(card_.set_crtc, 0U);
  card_.crtcs = 2;
  const auto display = open();
  ASSERT_TRUE(display) << display.fault().message;
  EXPECT_EQ(card_.set_crtc, kCrtc + kOther);
}

TEST_F(LinuxMockedDrm, ScreensOfOneCardFlipEachInItsTime) {
  constexpr std::uint32_t kFirst = kCrtc + kOther, kSecond = kCrtc;
  card_.two_screens = true;
  card_.crtcs = 2;
  auto displays = DrmDisplay::open_all("/dev/dri/card0");
  ASSERT_TRUE(displays) << displays.fault().message;
  ASSERT_EQ(displays->size(), 2U);
  go_to_events();
  {
    hal::MirroredDisplays both(std::move(*displays));
    EXPECT_EQ(both.width(), kWidth);
    EXPECT_EQ(show_row(both, 0, 0x1111), Error::none);
    flip(kSecond);
    flip(kFirst);
    EXPECT_EQ(show_row(both, 1, 0x2222), Error::none);
    for (const std::uint32_t crtc : {kFirst, kSecond}) EXPECT_EQ(screen(crtc), rows({0x1111, 0, 0, 0})) << crtc;

    // The first one's flip does not come. The second screen goes on.
    flip(kSecond);
    EXPECT_EQ(show_row(both, 2, 0x3333), Error::flip);
    flip(kSecond);
    EXPECT_EQ(screen(kSecond), rows({0x1111, 0x2222, 0x3333, 0}));
    EXPECT_EQ(screen(kFirst), rows({0x1111, 0, 0, 0}));
    flip(kFirst);
    EXPECT_EQ(show_row(both, 3, 0x4444), Error::none);
    flip(kSecond);
    // That of the first one never comes.
  }
  EXPECT_EQ(card_.shown.at(kFirst), 0U) << "dark as before";
}

TEST_F(LinuxMockedDrm, ScreensWithoutASizeInCommonAreNamed) {
  card_.two_screens = true;
  card_.crtcs = 2;
  card_.second_width = kWidth - 1;
  const auto displays = DrmDisplay::open_all("/dev/dri/card0");
  ASSERT_FALSE(displays);
  EXPECT_EQ(displays.fault().message,
            "/dev/dri/card0: the screens have no size in common (Unknown-0: 8x4; Unknown-0: 7x4); choose a connector");
  EXPECT_EQ(card_.set_crtc, 0U);
}

}  // namespace
}  // namespace zstrip::linux_mock
