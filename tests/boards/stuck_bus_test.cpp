// A bus that gets stuck: the board says so where it still can, and its watchdog starts it again.
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "grey_picture.hpp"
#include "programs.hpp"
#include "qemu.hpp"
#include "zstrip_hal/framebuffer.hpp"
#include "zstrip_hal/message_screen.hpp"

namespace zstrip::boards {
namespace {

constexpr const char* kPrompt = "stuck bus: t or h?";

TEST(Board, StuckBusThatTimesOutShowsAPanicAndIsReset) {
  Qemu board({.machine = "lm3s6965evb", .program = program("zstrip_lm3s6965evb_stuck_bus")});
  ASSERT_EQ(board.read_line(), kPrompt);
  board.write_console("t");
  const std::string error = "display: the bus did not get ready in time";
  ASSERT_EQ(board.read_line(), "panic: " + error);
  std::vector<std::byte> memory(64 * 64);
  hal::Framebuffer display(memory, {128, 64, hal::PixelFormat::gray4});
  ASSERT_EQ(hal::show_message(display, "panic: " + error), hal::Error::none);
  const GreyPicture expected = unpack_gray4(memory, 128, 64);
  // The console is faster than the panel, the watchdog slower than both.
  std::string wrong;
  for (int look = 0; look < 20; ++look) {
    wrong = difference(expected, board.screen(4));
    if (wrong.empty()) break;
  }
  EXPECT_EQ(wrong, "");
  EXPECT_EQ(board.read_line(), kPrompt) << "the watchdog does not reset the board";
}

TEST(Board, StuckBusThatNeverReturnsIsResetByTheWatchdog) {
  Qemu board({.machine = "lm3s6965evb", .program = program("zstrip_lm3s6965evb_stuck_bus")});
  ASSERT_EQ(board.read_line(), kPrompt);
  board.write_console("h");
  EXPECT_EQ(board.read_line(), kPrompt) << "the watchdog does not reset the board";
}

// As long as frames are shown, nothing resets it: the host sees them in order.
TEST(Board, WatchdogSparesABoardThatIsPaused) {
  Qemu board({.machine = "lm3s6965evb", .program = program("zstrip_lm3s6965evb_teapot")});
  const std::string first = board.prompt("p");
  EXPECT_THROW(board.read_line(std::chrono::milliseconds(5000)), std::runtime_error) << "longer than the watchdog";
  board.write_console("n");
  EXPECT_EQ(board.read_line(), "frame " + std::to_string((std::stoi(first.substr(6)) + 1) % 64));
}

}  // namespace
}  // namespace zstrip::boards
