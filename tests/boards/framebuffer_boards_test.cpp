// Boards whose picture lies in memory, in the emulator: what their screens show, compared pixel for pixel.
#include <gtest/gtest.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <set>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "colour_picture.hpp"
#include "host_render.hpp"
#include "programs.hpp"
#include "qemu.hpp"
#include "zstrip_hal/framebuffer.hpp"
#include "zstrip_hal/message_screen.hpp"

namespace zstrip::boards {
namespace {

constexpr std::uint32_t kFramesPerTurn = 64;

struct FramebufferBoard {
  const char* program;
  const char* scene;
  std::uint16_t width, height;
  bool risc_v;
  LowBits low_bits;  ///< how the emulator widens 16 bits a pixel
  const Quality* preset = &quality::balanced;
};

std::ostream& operator<<(std::ostream& stream, const FramebufferBoard& board) { return stream << board.program; }

Qemu::Options options_of(const FramebufferBoard& board) {
  const auto elf = program(std::string("zstrip_") + board.program);
  if (!board.risc_v) return {.machine = "versatilepb", .program = elf, .devices = {"-audiodev", "none,id=none"}};
  return {.emulator = "qemu-system-riscv32",
          .machine = "virt",
          .program = elf,
          .devices = {"-bios", "none", "-device", "bochs-display,romfile="}};
}

class FramebufferBoards : public testing::TestWithParam<FramebufferBoard> {};

TEST_P(FramebufferBoards, ScreenIsThePictureOfTheHost) {
  const FramebufferBoard& board = GetParam();
  Qemu emulator(options_of(board));
  emulator.write_console("p");
  std::set<std::vector<std::array<std::uint8_t, 3>>> pictures;
  constexpr std::size_t kFrames = 2;
  for (std::size_t step = 0; step < kFrames; ++step) {
    const std::string line = emulator.read_line();
    ASSERT_TRUE(line.starts_with("frame ")) << line;
    const auto frame = static_cast<std::uint32_t>(std::stoi(line.substr(6)));
    const ColourPicture screen = emulator.colour_screen();
    EXPECT_EQ(difference(widened(render_turntable_rgb565(board.scene, frame, kFramesPerTurn, board.width, board.height,
                                                         *board.preset),
                                 board.width, board.height, board.low_bits),
                         screen),
              "")
        << "frame " << frame;
    pictures.insert(screen.pixels);
    emulator.write_console("n");
  }
  EXPECT_EQ(pictures.size(), kFrames) << "it does not turn";
}

constexpr FramebufferBoard kBoards[] = {
    {"versatilepb_teapot_qvga", "teapot", 320, 240, false, LowBits::zeros},
    {"versatilepb_room_vga", "room", 640, 480, false, LowBits::zeros, &quality::exact},
#ifdef ZSTRIP_RISCV_PROGRAMS
    {"riscv_virt_room", "room", 640, 480, true, LowBits::repeated, &quality::exact},
    {"riscv_virt_teapot", "teapot", 320, 240, true, LowBits::repeated},
#endif
};

INSTANTIATE_TEST_SUITE_P(Board, FramebufferBoards, testing::ValuesIn(kBoards),
                         [](const auto& test) { return std::string(test.param.program); });

class FaultingFramebufferBoards : public testing::TestWithParam<FramebufferBoard> {};

TEST_P(FaultingFramebufferBoards, FaultShowsOnConsoleAndScreen) {
  const FramebufferBoard& board = GetParam();
  Qemu emulator(options_of(board));
  const std::string report = emulator.read_line();
  ASSERT_TRUE(report.starts_with("fault: ")) << report;
  const std::string words = "panic: " + report.substr(0, report.find(" value "));
  ASSERT_EQ(emulator.read_line(), words);
  std::vector<std::uint16_t> pixels(std::size_t{board.width} * board.height);
  hal::Framebuffer display(std::as_writable_bytes(std::span(pixels)),
                           {board.width, board.height, hal::DisplayFormat::rgb565});
  ASSERT_EQ(hal::show_message(display, words), hal::Error::none);
  const ColourPicture expected = widened(pixels, board.width, board.height, board.low_bits);
  // The console is faster than the screen.
  std::string wrong;
  for (int look = 0; look < 20; ++look) {
    wrong = difference(expected, emulator.colour_screen());
    if (wrong.empty()) break;
  }
  EXPECT_EQ(wrong, "");
  // Without semihosting the end was an exception in its turn, reported again and again.
  EXPECT_THROW(emulator.read_line(std::chrono::milliseconds(1000)), std::runtime_error);
}

constexpr FramebufferBoard kFaultingBoards[] = {
    {"versatilepb_fault_qvga", "", 320, 240, false, LowBits::zeros},
#ifdef ZSTRIP_RISCV_PROGRAMS
    {"riscv_virt_fault", "", 320, 240, true, LowBits::repeated},
#endif
};

INSTANTIATE_TEST_SUITE_P(Board, FaultingFramebufferBoards, testing::ValuesIn(kFaultingBoards),
                         [](const auto& test) { return std::string(test.param.program); });

}  // namespace
}  // namespace zstrip::boards
