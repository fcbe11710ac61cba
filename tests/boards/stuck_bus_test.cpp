// A bus that gets stuck: the board says so where it still can, and its watchdog starts it again.
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "grey_picture.hpp"
#include "programs.hpp"
#include "qemu.hpp"
#include "zstrip_hal/framebuffer.hpp"
#include "zstrip_hal/message_screen.hpp"

namespace zstrip::boards {
namespace {

constexpr const char* kPrompt = "stuck bus: t, d, h, f, o, g or s?";

/// The board, asked for this. Each of its instructions takes 256 ns, so that the watchdog's seconds pass soon.
std::unique_ptr<Qemu> stuck(const char* how) {
  auto board = std::make_unique<Qemu>(Qemu::Options{.machine = "lm3s6965evb",
                                                    .program = program("zstrip_lm3s6965evb_stuck_bus"),
                                                    .devices = {"-icount", "shift=8,sleep=off"}});
  EXPECT_EQ(board->read_line(), kPrompt);
  board->write_console(how);
  return board;
}

/// Its panel soon shows these words and nothing else, and then its watchdog resets it; the panel keeps them until the
/// program draws again.
void expect_message_and_reset(Qemu& board, const std::string& words) {
  std::vector<std::byte> memory(64 * 64);
  hal::Framebuffer display(memory, {128, 64, hal::DisplayFormat::gray4});
  ASSERT_EQ(hal::show_message(display, words), hal::Error::none);
  const GreyPicture expected = unpack_gray4(memory, 128, 64);
  // The console is faster than the panel.
  std::string wrong;
  for (int look = 0; look < 20; ++look) {
    wrong = difference(expected, board.screen(4));
    if (wrong.empty()) break;
  }
  EXPECT_EQ(wrong, "");
  EXPECT_EQ(board.read_line(), kPrompt) << "the watchdog does not reset the board";
}

TEST(Board, StuckBusThatTimesOutShowsAPanicAndIsReset) {
  const auto board = stuck("t");
  const std::string words = "panic: display: the bus did not get ready in time";
  ASSERT_EQ(board->read_line(), words);
  expect_message_and_reset(*board, words);
}

// Nothing can be shown any more: each step of the panic times out, too, says so, and leaves the rest to the watchdog.
TEST(Board, StuckBusThatStaysStuckSaysSoAndIsReset) {
  const auto board = stuck("d");
  ASSERT_EQ(board->read_line(), "panic: display: the bus did not get ready in time");
  ASSERT_EQ(board->read_line(), "panic on the display: the bus did not get ready in time");
  EXPECT_EQ(board->read_line(), kPrompt) << "the watchdog does not reset the board";
}

TEST(Board, StuckBusThatNeverReturnsIsResetByTheWatchdog) {
  const auto board = stuck("h");
  EXPECT_EQ(board->read_line(), kPrompt) << "the watchdog does not reset the board";
}

TEST(Board, FaultShowsOnConsoleAndPanelAndIsReset) {
  const auto board = stuck("f");
  const std::string report = board->read_line();
  ASSERT_TRUE(report.starts_with("fault: exception 3 pc 0")) << report;
  const std::string words = "panic: " + report.substr(0, report.find(" cfsr "));
  ASSERT_EQ(board->read_line(), words);
  expect_message_and_reset(*board, words);
}

TEST(Board, StackOverflowShowsOnConsoleAndPanelAndIsReset) {
  const auto board = stuck("o");
  const std::string report = board->read_line();
  ASSERT_TRUE(report.starts_with("fault: exception 3 stack overflow ")) << report;
  ASSERT_EQ(board->read_line(), "panic: fault: exception 3 stack overflow");
  expect_message_and_reset(*board, "panic: fault: exception 3 stack overflow");
}

// The panel cannot be told any more, and that does not keep the board from its reset.
TEST(Board, FaultWithAStuckBusIsResetByTheWatchdog) {
  const auto board = stuck("g");
  const std::string report = board->read_line();
  ASSERT_TRUE(report.starts_with("fault: exception 3 pc 0")) << report;
  ASSERT_EQ(board->read_line(), "panic: " + report.substr(0, report.find(" cfsr ")));
  EXPECT_EQ(board->read_line(), kPrompt) << "the watchdog does not reset the board";
}

// A fault of the panic itself locked the processor up. It is reported, and ends in the same reset.
TEST(Board, SecondFaultInThePanicIsReportedAndReset) {
  const auto board = stuck("s");
  const std::string first = board->read_line();
  ASSERT_TRUE(first.starts_with("fault: exception 3 pc 0")) << first;
  ASSERT_EQ(board->read_line(), "panic: " + first.substr(0, first.find(" cfsr ")));
  const std::string second = board->read_line();
  EXPECT_TRUE(second.starts_with("fault: exception 3 pc 0")) << second;
  EXPECT_NE(second.substr(0, second.find(" cfsr ")), first.substr(0, first.find(" cfsr "))) << "another place";
  EXPECT_EQ(board->read_line(), kPrompt) << "nothing but the watchdog comes after it";
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
