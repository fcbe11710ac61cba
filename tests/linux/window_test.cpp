// zstrip-panel in a window: on a desktop of X11 without a screen, and on SDL's driver that writes what it would show.
#include <SDL.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <span>
#include <thread>

#include "../host-sim/support.hpp"
#include "colour_picture.hpp"
#include "started_program.hpp"
#include "x11_desktop.hpp"
#include "zstrip_hal_linux/sdl_display.hpp"

namespace zstrip::linux_window {
namespace {

using namespace std::chrono_literals;

/// Each pixel a square.
boards::ColourPicture enlarged(const boards::ColourPicture& picture, int scale) {
  boards::ColourPicture result{picture.width * scale, picture.height * scale, {}};
  for (int y = 0; y < result.height; ++y) {
    for (int x = 0; x < result.width; ++x) result.pixels.push_back(picture.at(x / scale, y / scale));
  }
  return result;
}

boards::ColourPicture read_bmp(const std::string& path) {
  SDL_Surface* const file = SDL_LoadBMP(path.c_str());
  if (file == nullptr) throw std::runtime_error("no BMP: " + path);
  SDL_Surface* const surface = SDL_ConvertSurfaceFormat(file, SDL_PIXELFORMAT_RGB24, 0);
  boards::ColourPicture picture{surface->w, surface->h, {}};
  for (int y = 0; y < surface->h; ++y) {
    const auto* row = static_cast<const std::uint8_t*>(surface->pixels) + y * surface->pitch;
    for (int x = 0; x < surface->w; ++x, row += 3) picture.pixels.push_back({row[0], row[1], row[2]});
  }
  SDL_FreeSurface(surface);
  SDL_FreeSurface(file);
  return picture;
}

class LinuxWindow : public sim::test::FolderTest {
 protected:
  static constexpr const char* kTitle = "zstrip-panel";

  LinuxWindow() {
    EXPECT_EQ(run(ZSTRIP_COMMAND, {"bake", "teapot", "--turntable", "--size", "64x48", "--quiet", "-o", "scene.zsc"}),
              "");
    EXPECT_EQ(
        run(ZSTRIP_COMMAND, {"render", "scene.zsc", "--frames", "5", "--image", "ppm", "--quiet", "-o", "frames"}), "");
  }
  /// What it says on standard error, and its status unless that is 0.
  std::string run(const std::string& program, const std::vector<std::string>& arguments) const {
    const sim::test::Outcome outcome = sim::test::run(program, arguments, path(""));
    return outcome.err + (outcome.status == 0 ? "" : "status " + std::to_string(outcome.status));
  }
  std::vector<std::string> panel(const std::string& display, std::vector<std::string> more) const {
    std::vector<std::string> words{ZSTRIP_PANEL, path("scene.zsc"), "--turn", "5", "--display", display};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
  /// Frame `frame` of five.
  boards::ColourPicture rendered(int frame, int scale) const {
    return enlarged(boards::read_ppm(path("frames/frame_000" + std::to_string(frame) + ".ppm")), scale);
  }
};

class LinuxWindowX11 : public LinuxWindow {
 protected:
  void SetUp() override {
    if (std::system("command -v Xvfb >/dev/null") != 0) GTEST_SKIP() << "Xvfb is not installed";
    desktop_ = std::make_unique<X11Desktop>();
  }
  std::vector<std::string> on_desktop() const { return {desktop_->variable(), "SDL_VIDEODRIVER=x11"}; }
  /// Empty if the desktop shows the picture soon. Windows are shown some time after they are drawn.
  std::string differs(const boards::ColourPicture& expected) const {
    const auto deadline = std::chrono::steady_clock::now() + 10s;
    for (;;) {
      std::string difference = boards::difference(expected, desktop_->seen(kTitle));
      if (difference.empty() || std::chrono::steady_clock::now() > deadline) return difference;
      std::this_thread::sleep_for(20ms);
    }
  }

  /// SDL forgets what happens to a window before it is ready.
  void wait_for_a_picture() const {
    const auto is_black = [](const std::array<std::uint8_t, 3>& pixel) { return pixel[0] == 0; };
    const auto deadline = std::chrono::steady_clock::now() + 10s;
    while (std::ranges::all_of(desktop_->seen(kTitle).pixels, is_black)) {
      ASSERT_LT(std::chrono::steady_clock::now(), deadline) << "the window stays black";
      std::this_thread::sleep_for(20ms);
    }
  }

  std::unique_ptr<X11Desktop> desktop_;
};

TEST_F(LinuxWindowX11, ShowsTheRenderedPictureUntilItIsClosed) {
  StartedProgram program(panel("sdl:64x48@3", {"--frames", "3", "--hold"}), on_desktop());
  EXPECT_EQ(program.read_line().substr(0, 18), "3 frames of 64x48 ");
  EXPECT_EQ(differs(rendered(2, 3)), "");
  desktop_->cover_and_uncover(kTitle);
  EXPECT_EQ(differs(rendered(2, 3)), "") << "after another window was over it";
  desktop_->close(kTitle);
  EXPECT_EQ(program.wait(), 0);
}

TEST_F(LinuxWindowX11, ClosingEndsAPlayWithoutAnEnd) {
  for (const std::vector<std::string>& more : {std::vector<std::string>{}, {"--fps", "0.05"}}) {
    StartedProgram program(panel("sdl:", more), on_desktop());
    wait_for_a_picture();
    EXPECT_EQ(desktop_->seen(kTitle).width, 64) << "as large as the scene was baked";
    desktop_->close(kTitle);
    EXPECT_EQ(program.wait(), 0);
  }
}

TEST_F(LinuxWindowX11, SignalsEndIt) {
  for (const int signal : {SIGINT, SIGTERM}) {
    StartedProgram program(panel("sdl,scale=2", {}), on_desktop());
    EXPECT_EQ(desktop_->seen(kTitle).height, 96);
    program.send(signal);
    EXPECT_EQ(program.wait(), 0);
  }
}

TEST_F(LinuxWindowX11, ADesktopThatEndsEndsItToo) {
  StartedProgram program(panel("sdl:", {"--quiet"}), on_desktop());
  wait_for_a_picture();
  desktop_.reset();
  EXPECT_EQ(program.wait(), 1) << "Xlib's own end of a program";
}

/// Somewhere in it, pixel for pixel.
bool contains(const boards::ColourPicture& screen, const boards::ColourPicture& part) {
  for (int top = 0; top + part.height <= screen.height; ++top) {
    for (int left = 0; left + part.width <= screen.width; ++left) {
      int row = 0;
      while (row < part.height &&
             std::equal(&part.at(0, row), &part.at(0, row) + part.width, &screen.at(left, top + row)))
        ++row;
      if (row == part.height) return true;
    }
  }
  return false;
}

// Weston draws its desktop into a window of X11.
class LinuxWindowWayland : public LinuxWindowX11 {
 protected:
  void SetUp() override {
    if (std::system("command -v weston >/dev/null") != 0) GTEST_SKIP() << "weston is not installed";
    LinuxWindowX11::SetUp();
    if (IsSkipped()) return;
    const std::vector<std::string> words{
        "weston",      "--backend=x11-backend.so", "--use-pixman", "--no-config", "--width=640", "--height=480",
        "--socket=way"};
    weston_ = std::make_unique<StartedProgram>(words, std::vector{desktop_->variable(), folder_variable()});
    for (int tries = 0; tries < 200 && !std::filesystem::exists(path("way")); ++tries)
      std::this_thread::sleep_for(50ms);
  }
  std::string folder_variable() const { return "XDG_RUNTIME_DIR=" + path(""); }

  std::unique_ptr<StartedProgram> weston_;
};

TEST_F(LinuxWindowWayland, ShowsTheRenderedPictureUntilASignal) {
  StartedProgram program(panel("sdl:64x48@3", {"--frames", "3", "--hold"}),
                         {folder_variable(), "WAYLAND_DISPLAY=way", "SDL_VIDEODRIVER=wayland"});
  EXPECT_EQ(program.read_line().substr(0, 18), "3 frames of 64x48 ");
  const boards::ColourPicture expected = rendered(2, 3);
  const auto deadline = std::chrono::steady_clock::now() + 30s;
  bool is_seen = false;
  while (!is_seen && std::chrono::steady_clock::now() < deadline) {
    std::this_thread::sleep_for(50ms);
    is_seen = contains(desktop_->seen(""), expected);
  }
  EXPECT_TRUE(is_seen);
  EXPECT_FALSE(contains(desktop_->seen(""), rendered(1, 3)));
  program.send(SIGINT);
  EXPECT_EQ(program.wait(), 0);
}

TEST_F(LinuxWindow, EveryFrameIsWhatRenderWrites) {
  ::setenv("SDL_VIDEODRIVER", "dummy", 1);
  ::setenv("SDL_VIDEO_DUMMY_SAVE_FRAMES", "1", 1);
  EXPECT_EQ(run("/usr/bin/env", panel("sdl:64x48@2", {"--frames", "5", "--quiet"})), "");
  for (int frame = 0; frame < 5; ++frame) {
    // The first picture is the black one of the beginning.
    const std::string file = path("SDL_window1-0000000" + std::to_string(frame + 2) + ".bmp");
    EXPECT_EQ(boards::difference(rendered(frame, 2), read_bmp(file)), "") << "frame " << frame;
  }
}

TEST_F(LinuxWindow, NotFasterThanTheScreen) {
  ::setenv("SDL_VIDEODRIVER", "dummy", 1);
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(run("/usr/bin/env", panel("sdl:", {"--frames", "31", "--quiet"})), "");
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  EXPECT_GE(took.count(), 0.45) << "30 times a sixtieth of a second";
}

// A frame may write only what changes; the user's wish to close is kept.
TEST_F(LinuxWindow, TheDisplayByItself) {
  ::setenv("SDL_VIDEODRIVER", "dummy", 1);
  ::setenv("SDL_VIDEO_DUMMY_SAVE_FRAMES", "1", 1);
  std::filesystem::current_path(path(""));
  auto display = hal::SdlDisplay::open("a title", {4, 2}, 1);
  ASSERT_TRUE(display) << display.fault().message;
  const std::array<std::uint16_t, 2> blue_and_white{0x001F, 0xFFFF};
  const auto pixels = std::as_bytes(std::span(blue_and_white));
  EXPECT_EQ(display->write({3, 0, 2, 1}, pixels), hal::Error::area);
  EXPECT_EQ(display->write({0, 0, 2, 2}, pixels), hal::Error::pixels_too_small);
  EXPECT_EQ(display->write({1, 0, 2, 1}, pixels), hal::Error::none);
  EXPECT_EQ(display->end_frame(), hal::Error::none);
  EXPECT_EQ(display->write({3, 0, 1, 2}, pixels), hal::Error::none);
  EXPECT_EQ(display->end_frame(), hal::Error::none);
  using Pixel = std::array<std::uint8_t, 3>;
  constexpr Pixel kBlack{}, kBlue{0, 0, 255}, kWhite{255, 255, 255};
  EXPECT_EQ(read_bmp(path("SDL_window1-00000003.bmp")),
            (boards::ColourPicture{4, 2, {kBlack, kBlue, kWhite, kBlue, kBlack, kBlack, kBlack, kWhite}}));

  EXPECT_FALSE(display->is_closed());
  SDL_Event event{};
  event.type = SDL_QUIT;
  SDL_PushEvent(&event);
  EXPECT_TRUE(display->is_closed());
  EXPECT_TRUE(display->is_closed());
}

TEST_F(LinuxWindow, WhatIsRefused) {
  ::setenv("SDL_VIDEODRIVER", "dummy", 1);
  const auto said = [this](const std::string& display) { return run("/usr/bin/env", panel(display, {"--frames=1"})); };
  EXPECT_EQ(said("sdl:64x48@9"), "zstrip-panel: --display sdl: scale must be a number from 1 to 8, not '9'\nstatus 2");
  EXPECT_EQ(said("sdl:4096x48@2"),
            "zstrip-panel: --display sdl: scale makes a window of more than 4096 pixels a side\nstatus 2");
  EXPECT_EQ(said("sdl:64x@2"),
            "zstrip-panel: --display sdl: size must be WIDTHxHEIGHT, each 1 to 4096, not '64x'\nstatus 2");
  EXPECT_EQ(said("sdl:64x48,depth=16"), "zstrip-panel: --display sdl: depth is not known there; see --help\nstatus 2");
  ::setenv("SDL_VIDEODRIVER", "x11", 1);
  ::setenv("DISPLAY", ":4000", 1);
  EXPECT_EQ(said("sdl:"),
            "zstrip-panel: no window can be opened: x11 not available; WAYLAND_DISPLAY or DISPLAY must name a desktop "
            "of this user\nstatus 3");
  // SDL goes on without a desktop; a user would see nothing.
  ::unsetenv("SDL_VIDEODRIVER");
  ::unsetenv("DISPLAY");
  ::unsetenv("WAYLAND_DISPLAY");
  ::setenv("XDG_RUNTIME_DIR", path("").c_str(), 1);
  const std::string words = said("sdl:");
  EXPECT_NE(words.find("WAYLAND_DISPLAY or DISPLAY must name a desktop of this user\nstatus 3"), std::string::npos)
      << words;
}

}  // namespace
}  // namespace zstrip::linux_window
