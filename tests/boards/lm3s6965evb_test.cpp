// The EK-LM3S6965 in the emulator: what its OLED shows, compared pixel for pixel.
#include <gtest/gtest.h>

#include <chrono>
#include <set>
#include <string>

#include "host_render.hpp"
#include "programs.hpp"
#include "qemu.hpp"

namespace zstrip::boards {
namespace {

constexpr int kScreenScale = 4;
constexpr int kFramesPerTurn = 64;

/// A pause becomes effective after whatever frame is shown then; the board says which.
int announced_frame(Qemu& board) {
  const std::string line = board.read_line();
  EXPECT_TRUE(line.starts_with("frame ")) << line;
  return std::stoi(line.substr(line.find(' ') + 1));
}

TEST(Board, Lm3sDisplayTest) {
  Qemu board({.machine = "lm3s6965evb", .program = program("zstrip_lm3s6965evb_display_test")});
  ASSERT_EQ(board.read_line(), "display test: no error");
  const GreyPicture screen = board.screen(kScreenScale);
  ASSERT_EQ(screen.width, 128);
  ASSERT_EQ(screen.height, 64);
  GreyPicture expected{128, 64, {}};
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 128; ++x) {
      const bool frame = x == 0 || y == 0 || x == 127 || y == 63;
      expected.levels.push_back(static_cast<std::uint8_t>(frame ? 15 : x / 8));
    }
  }
  EXPECT_EQ(difference(expected, screen), "");
}

TEST(Board, Lm3sTeapot) {
  Qemu board({.machine = "lm3s6965evb", .program = program("zstrip_lm3s6965evb_teapot")});
  board.write_console("p");
  const int first = announced_frame(board);
  std::set<std::string> pictures;
  for (int step = 0; step < 12; ++step) {
    const int frame = step == 0 ? first : announced_frame(board);
    ASSERT_EQ(frame, (first + step) % kFramesPerTurn);
    const GreyPicture screen = board.screen(kScreenScale);
    EXPECT_EQ(difference(render_turntable_gray4("teapot", static_cast<std::uint32_t>(frame), kFramesPerTurn, 128, 64),
                         screen),
              "")
        << "frame " << frame;
    pictures.emplace(screen.levels.begin(), screen.levels.end());
    board.write_console("n");
  }
  EXPECT_EQ(pictures.size(), 12U) << "the teapot does not turn";
}

TEST(Board, Lm3sLayers) {
  Qemu board({.machine = "lm3s6965evb", .program = program("zstrip_lm3s6965evb_layers")});
  board.write_console("p");
  std::string line = board.read_line();
  const int first = std::stoi(line.substr(line.find(' ') + 1));
  std::set<std::string> pictures;
  for (int step = 0; step < 16; ++step) {
    if (step > 0) line = board.read_line();
    const int frame = (first + step) % kFramesPerTurn;
    ASSERT_TRUE(line.starts_with("frame " + std::to_string(frame) + ", ")) << line;
    const int drawn = std::stoi(line.substr(line.find(',') + 2));
    EXPECT_GT(drawn, 0);
    if (frame > 0) {
      EXPECT_LT(drawn, 128 * 64 / 2) << "only what changed is drawn";
    }
    const GreyPicture screen = board.screen(kScreenScale);
    EXPECT_EQ(difference(render_showroom_gray4(static_cast<std::uint32_t>(frame), kFramesPerTurn, 128, 64), screen), "")
        << "frame " << frame;
    pictures.emplace(screen.levels.begin(), screen.levels.end());
    board.write_console("n");
  }
  EXPECT_EQ(pictures.size(), 16U) << "the teapot does not fly";
}

TEST(Board, Lm3sTeapotRunsWithoutHost) {
  Qemu board({.machine = "lm3s6965evb", .program = program("zstrip_lm3s6965evb_teapot")});
  std::set<std::string> pictures;
  const auto deadline = std::chrono::steady_clock::now() + Qemu::kPatience;
  while (pictures.size() < 3 && std::chrono::steady_clock::now() < deadline) {
    const GreyPicture screen = board.screen(kScreenScale);
    pictures.emplace(screen.levels.begin(), screen.levels.end());
  }
  EXPECT_GE(pictures.size(), 3U);
}

}  // namespace
}  // namespace zstrip::boards
