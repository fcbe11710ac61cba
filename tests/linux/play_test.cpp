// What zstrip-panel shows, frame by frame: the pictures of `zstrip render` of the scene that was baked.
#include <algorithm>
#include <iterator>

#include "../host-sim/support.hpp"
#include "play.hpp"

namespace zstrip::panel {
namespace {

constexpr std::uint16_t kWidth = 64, kHeight = 48;

/// Keeps all frames, as files of raw pixels are.
class KeepingDisplay : public AnyDisplay {
 public:
  std::uint16_t width() const override { return kWidth; }
  std::uint16_t height() const override { return kHeight; }
  hal::DisplayFormat format() const override { return hal::DisplayFormat::rgb565; }
  hal::Error begin_frame() override {
    frames.emplace_back(std::size_t{kWidth} * kHeight * kPixelBytes, '\xAA');
    return hal::Error::none;
  }
  hal::Error write(const hal::Area& area, std::span<const std::byte> pixels) override {
    const auto* from = reinterpret_cast<const char*>(pixels.data());
    for (std::size_t row = 0; row < area.height; ++row, from += kPixelBytes * area.width) {
      const std::size_t to = ((area.top + row) * kWidth + area.left) * kPixelBytes;
      std::copy_n(from, kPixelBytes * area.width, frames.back().begin() + static_cast<std::ptrdiff_t>(to));
    }
    return hal::Error::none;
  }
  hal::Error wait() override { return hal::Error::none; }
  hal::Error end_frame() override { return hal::Error::none; }

  std::vector<std::string> frames;

 private:
  static constexpr std::size_t kPixelBytes = 2;
};

class LinuxPlay : public sim::test::FolderTest {
 protected:
  void expect_same(const std::string& scene) {
    const auto zstrip = [this](const std::vector<std::string>& arguments) {
      const sim::test::Outcome outcome = sim::test::run(ZSTRIP_COMMAND, arguments, path(""));
      ASSERT_EQ(outcome.status, 0) << outcome.err;
    };
    zstrip({"bake", scene, "-o", "scene.zsc", "--size", "64x48", "--quiet"});
    auto opened = SceneFile::open(path("scene.zsc"));
    ASSERT_TRUE(opened) << opened.fault().message;
    for (const std::uint32_t frames : {1U, 3U}) {
      zstrip({"render", scene, "-o", "frames", "--size", "64x48", "--image", "raw", "--frames", std::to_string(frames),
              "--quiet"});
      KeepingDisplay display;
      Played played;
      const auto failure = play(*opened, display, {.frames = frames, .frames_per_turn = frames}, stop_, played);
      ASSERT_FALSE(failure) << failure->message;
      ASSERT_EQ(display.frames.size(), frames);
      for (std::uint32_t frame = 0; frame < frames; ++frame) {
        EXPECT_EQ(display.frames[frame], sim::test::read(path("frames/frame_000" + std::to_string(frame) + ".raw")))
            << scene << ", frame " << frame << " of " << frames;
      }
    }
  }

  StopSignals stop_;
};

TEST_F(LinuxPlay, WhatTurnsBesideWhatStandsStill) {
  expect_same(file("scene.toml",
                   "[[material]]\nname = 'a'\n[[model]]\nname = 'cube'\nbuilt_in = 'cube'\n"
                   "[[instance]]\nmodel = 'cube'\ntranslation = [1, 0.3, 0.5]\nscale = 0.6\n"
                   "[[instance]]\nmodel = 'cube'\ntranslation = [-1, 0.2, 0.5]\nscale = 0.4\nlayer = 'static'\n"
                   "[[ellipsoid]]\nmaterial = 'a'\nradius = 0.4\ntranslation = [0.4, 1, -1]\n"
                   "[[lines]]\nmaterial = 'a'\nvertices = [[-2, -0.5, 1], [2, -0.5, 1.5], [1, 1.5, -1]]\n"));
}

TEST_F(LinuxPlay, TheCameraGoesAroundARoom) { expect_same("room"); }
TEST_F(LinuxPlay, AnAnimationIsPlayed) { expect_same(ZSTRIP_SCENE_FILES "/table.toml"); }
TEST_F(LinuxPlay, TexturesAreAsThePictureWantsThem) { expect_same(ZSTRIP_SCENE_FILES "/perspective.toml"); }

}  // namespace
}  // namespace zstrip::panel
