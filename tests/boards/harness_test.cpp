// The instruments themselves: a wrong picture is noticed, an emulator that fails or hangs is reported and leaves
// nothing behind.
#include <gtest/gtest.h>
#include <signal.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "grey_picture.hpp"
#include "programs.hpp"
#include "qemu.hpp"

namespace zstrip::boards {
namespace {

constexpr int kScale = 2;

/// A PPM of 4x4 pixels, each of the 2x2 squares with the level of its number.
std::string valid_ppm() {
  std::string ppm = "P6\n4 4\n255\n";
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 4; ++x) ppm.append(3, static_cast<char>(17 * (y / kScale * 2 + x / kScale)));
  }
  return ppm;
}

class Ppm : public testing::Test {
 protected:
  GreyPicture read(const std::string& content) {
    std::ofstream(file_, std::ios::binary) << content;
    return read_scaled_ppm(file_, kScale);
  }
  void TearDown() override { std::filesystem::remove(file_); }

 private:
  std::filesystem::path file_ =
      std::filesystem::path(testing::TempDir()) / ("zstrip-ppm-" + std::to_string(::getpid()));
};

TEST_F(Ppm, ReadsSquares) { EXPECT_EQ(read(valid_ppm()), (GreyPicture{2, 2, {0, 1, 2, 3}})); }

TEST_F(Ppm, RefusesUnevenSquares) {
  std::string ppm = valid_ppm();
  ppm.back() = 0;
  EXPECT_THROW(read(ppm), std::runtime_error);
}

TEST_F(Ppm, RefusesColours) {
  std::string ppm = valid_ppm();
  for (std::size_t pixel : {0U, 1U, 4U, 5U}) ppm[ppm.size() - 48 + 3 * pixel + 1] = 17;
  EXPECT_THROW(read(ppm), std::runtime_error);
}

TEST_F(Ppm, RefusesLevelsBetweenTheGreys) {
  std::string ppm = valid_ppm();
  for (std::size_t pixel : {0U, 1U, 4U, 5U}) ppm.replace(ppm.size() - 48 + 3 * pixel, 3, 3, '\x10');
  EXPECT_THROW(read(ppm), std::runtime_error);
}

TEST_F(Ppm, RefusesTruncation) {
  const std::string ppm = valid_ppm();
  for (std::size_t length = 0; length < ppm.size(); ++length) {
    EXPECT_THROW(read(ppm.substr(0, length)), std::runtime_error) << length;
  }
}

TEST(GreyPicture, DifferenceNamesTheFirstWrongPixel) {
  const GreyPicture right{2, 2, {0, 1, 2, 3}};
  GreyPicture wrong = right;
  EXPECT_EQ(difference(right, wrong), "");
  wrong.levels[2] = 7;
  wrong.levels[3] = 8;
  EXPECT_EQ(difference(right, wrong), "2 pixels differ, the first at (0, 1) is 7 instead of 2");
  EXPECT_NE(difference(right, {4, 1, {0, 1, 2, 3}}), "");
}

TEST(GreyPicture, UnpacksTheHighNibbleFirst) {
  EXPECT_EQ(unpack_gray4({std::byte{0x12}, std::byte{0x30}, std::byte{0x45}, std::byte{0x60}}, 3, 2),
            (GreyPicture{3, 2, {1, 2, 3, 4, 5, 6}}));
}

// The screenshot really comes from the board: with one byte of its picture changed, the comparison fails.
TEST(Board, HarnessNoticesAWrongPixel) {
  Qemu board({.machine = "lm3s6965evb", .program = program("zstrip_lm3s6965evb_display_test")});
  board.read_line();
  const GreyPicture screen = board.screen(4);
  GreyPicture wrong = screen;
  wrong.levels[5000] ^= 1U;
  EXPECT_EQ(difference(screen, wrong).substr(0, 14), "1 pixels diffe");
}

TEST(Board, HarnessReportsAMissingProgram) {
  EXPECT_THROW(Qemu({.machine = "lm3s6965evb", .program = program("no_such_program")}), std::runtime_error);
}

TEST(Board, HarnessReportsAnEmulatorThatEnds) {
  Qemu board({.machine = "no-such-machine", .program = program("zstrip_lm3s6965evb_display_test")});
  EXPECT_THROW(board.screen(4), std::runtime_error);
}

TEST(Board, HarnessTimesOutAndEndsTheEmulator) {
  pid_t process = -1;
  {
    Qemu board({.machine = "lm3s6965evb", .program = program("zstrip_lm3s6965evb_display_test")});
    process = board.process();
    board.read_line();
    EXPECT_THROW(board.read_line(std::chrono::milliseconds(200)), std::runtime_error);
  }
  EXPECT_EQ(kill(process, 0), -1);
  EXPECT_EQ(errno, ESRCH);
}

}  // namespace
}  // namespace zstrip::boards
