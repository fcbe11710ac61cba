// Boards with a panel on SPI, in the emulator: every write to their pins and controllers is traced and decoded, and
// what a panel would show of it is the picture of the host.
#include <gtest/gtest.h>

#include <functional>
#include <ostream>
#include <stdexcept>
#include <string>
#include <variant>

#include "host_render.hpp"
#include "panel/dcs_model.hpp"
#include "panel_trace.hpp"
#include "programs.hpp"
#include "qemu.hpp"

namespace zstrip::boards {
namespace {

constexpr std::uint32_t kFramesPerTurn = 64;

struct PanelBoard {
  const char* machine;
  const char* program;
  int serial_port;
  const char* trace;
  std::variant<BitBangedPins, StmSpiPins, StmBitBangedPins> pins;
  const sim::DcsPart& part;
  sim::Glass glass;
  bool sideways;  ///< the picture lies on its side, turned clockwise
  const char* scene;
  std::uint16_t width, height;  ///< of the picture
};

std::ostream& operator<<(std::ostream& stream, const PanelBoard& board) { return stream << board.program; }

/// Reads the trace as it grows and keeps a panel's model up to date.
class TracedPanel {
 public:
  TracedPanel(Qemu& board, const PanelBoard& wiring)
      : board_(board), wiring_(wiring), panel_(wiring.part, wiring.glass), wires_(panel_) {}

  /// Until this is true after a write, or throws at the end of patience.
  void read_until(const std::function<bool(const PanelWires&)>& done) {
    for (;;) {
      const auto write = parse_write(board_.read_trace_line());
      if (!write) continue;
      std::visit([&](const auto& pins) { feed(wires_, pins, *write); }, wiring_.pins);
      if (done(wires_)) return;
    }
  }
  /// Whatever the trace has by now.
  void read_rest() {
    while (const auto line = board_.poll_trace_line()) {
      const auto write = parse_write(*line);
      if (write) std::visit([&](const auto& pins) { feed(wires_, pins, *write); }, wiring_.pins);
    }
  }

  const sim::DcsModel& panel() const { return panel_; }
  PanelWires& wires() { return wires_; }

  /// The picture's pixel as RGB565.
  unsigned seen(const sim::RgbImage& image, std::uint32_t x, std::uint32_t y) const {
    const std::uint8_t* rgb = wiring_.sideways ? image.pixel(image.width - 1 - y, x) : image.pixel(x, y);
    return static_cast<unsigned>(rgb[0] >> 3) << 11 | static_cast<unsigned>(rgb[1] >> 2) << 5 | rgb[2] >> 3;
  }

  /// How many pixels of these columns and rows are not those of the host.
  int wrong_pixels(const std::vector<std::uint16_t>& expected, std::uint32_t left, std::uint32_t right,
                   std::uint32_t top, std::uint32_t bottom) const {
    const sim::RgbImage image = panel_.seen();
    int wrong = 0;
    for (std::uint32_t y = top; y < bottom; ++y) {
      for (std::uint32_t x = left; x < right; ++x) {
        wrong += seen(image, x, y) != expected[std::size_t{y} * wiring_.width + x];
      }
    }
    return wrong;
  }

 private:
  Qemu& board_;
  const PanelBoard& wiring_;
  sim::DcsModel panel_;
  PanelWires wires_;
};

Qemu::Options options_of(const PanelBoard& board) {
  return {.machine = board.machine,
          .program = program(std::string("zstrip_") + board.program),
          .serial_port = board.serial_port,
          .trace = board.trace};
}

std::uint32_t frame_of(const std::string& line) {
  if (!line.starts_with("frame ")) throw std::runtime_error("the board says " + line);
  return static_cast<std::uint32_t>(std::stoul(line.substr(6)));
}

class PanelBoards : public testing::TestWithParam<PanelBoard> {};

TEST_P(PanelBoards, StreamIsThePictureOfTheHost) {
  const PanelBoard& board = GetParam();
  Qemu emulator(options_of(board));
  TracedPanel traced(emulator, board);
  const std::uint32_t first = frame_of(emulator.prompt("p"));
  traced.read_rest();
  EXPECT_EQ(traced.panel().complaints(), std::vector<std::string>{});
  EXPECT_EQ(traced.panel().darkness(), "");
  for (std::uint32_t frame = first; frame < first + 2; ++frame) {
    EXPECT_EQ(
        traced.wrong_pixels(render_turntable_rgb565(board.scene, frame, kFramesPerTurn, board.width, board.height), 0,
                            board.width, 0, board.height),
        0)
        << "frame " << frame;
    if (frame == first + 1) break;
    emulator.write_console("n");
    ASSERT_EQ(frame_of(emulator.read_line()), first + 1);
    traced.read_rest();
  }
  EXPECT_EQ(traced.panel().complaints(), std::vector<std::string>{});
}

const PanelBoard kBoards[] = {
    {"stm32vldiscovery", "stm32vldiscovery_show", 0, "memory_region_ops_write",
     StmSpiPins{0x4001300C, {0x40010C10, 0}, {0x40010810, 4}, {0x40010C10, 1}}, sim::kSt7735Part,
     sim::Glass{.width = 128,
                .height = 128,
                .column_offset = 2,
                .row_offset = 3,
                .columns_reversed = true,
                .rows_reversed = true,
                .bgr = true},
     false, "teapot_meshlets", 128, 128},
    {"netduinoplus2", "netduinoplus2_show", 5, "memory_region_ops_write",
     StmSpiPins{0x4000380C, {0x40020018, 6}, {0x40020418, 10}, {0x40020018, 0}}, sim::kIli9341Part,
     sim::Glass{.width = 240, .height = 320, .columns_reversed = true, .bgr = true}, true, "teapot", 320, 240},
};

INSTANTIATE_TEST_SUITE_P(Board, PanelBoards, testing::ValuesIn(kBoards),
                         [](const auto& test) { return std::string(test.param.program); });

// Bit-banged, three writes a bit: the start sequence up to the blackening, and every write of a frame.
class BitBangedPanelBoards : public testing::TestWithParam<PanelBoard> {};

constexpr std::uint64_t kPortB = 0x40010C10;
const PanelBoard kBitBangedBoards[] = {
    {"microbit", "microbit_show", 0, "nrf51_gpio_write",
     BitBangedPins{1U << 23, 1U << 21, 1U << 16, 1U << 18, 1U << 20}, sim::kSt7789Part,
     sim::Glass{.width = 240, .height = 240, .inverted = true}, false, "teapot_meshlets", 240, 240},
    {"stm32vldiscovery", "my_board_show", 0, "memory_region_ops_write",
     StmBitBangedPins{{kPortB, 0}, {kPortB, 1}, {kPortB, 2}, {kPortB, 3}, {kPortB, 4}}, sim::kSt7735Part,
     sim::Glass{.width = 128, .height = 128, .column_offset = 2, .row_offset = 3, .bgr = true}, false,
     "teapot_meshlets", 128, 128},
};

INSTANTIATE_TEST_SUITE_P(Board, BitBangedPanelBoards, testing::ValuesIn(kBitBangedBoards),
                         [](const auto& test) { return std::string(test.param.program); });

TEST_P(BitBangedPanelBoards, StreamIsThePictureOfTheHost) {
  const PanelBoard& board = GetParam();
  Qemu emulator(options_of(board));
  TracedPanel traced(emulator, board);
  // Up to the first zeros for the panel's memory. Neither they nor the command behind them are traced.
  traced.read_until([](const PanelWires& wires) { return !wires.windows().empty() && wires.windows()[0].bytes > 100; });
  emulator.set_trace(false);
  const std::uint32_t frame = frame_of(emulator.prompt("p"));
  traced.read_rest();
  traced.wires().missed_some();
  EXPECT_EQ(traced.panel().complaints(), std::vector<std::string>{});
  constexpr std::uint8_t kDisplayOn = 0x29;
  traced.wires().set_data_command(false);
  traced.wires().set_select(false);
  traced.wires().shift_byte(kDisplayOn);
  traced.wires().set_select(true);
  ASSERT_EQ(traced.panel().darkness(), "");

  emulator.set_trace(true);
  emulator.write_console("n");
  const std::size_t first = traced.wires().windows().size();
  const std::uint64_t all = 2U * board.width * board.height;
  traced.read_until([&](const PanelWires& wires) {
    std::uint64_t bytes = 0;
    for (std::size_t i = first; i < wires.windows().size(); ++i) bytes += wires.windows()[i].bytes;
    return bytes >= all;
  });
  ASSERT_EQ(frame_of(emulator.read_line()), frame + 1);
  emulator.set_trace(false);
  traced.read_rest();
  EXPECT_EQ(traced.panel().complaints(), std::vector<std::string>{});
  std::uint64_t bytes = 0;
  for (std::size_t i = first; i < traced.wires().windows().size(); ++i) {
    const PanelWires::Window& window = traced.wires().windows()[i];
    EXPECT_EQ(window.bytes, 2 * (window.right + 1 - window.left) * (window.bottom + 1 - window.top)) << i;
    bytes += window.bytes;
  }
  EXPECT_EQ(bytes, all) << "some pixel was sent twice, or another not at all";
  EXPECT_EQ(
      traced.wrong_pixels(render_turntable_rgb565(board.scene, frame + 1, kFramesPerTurn, board.width, board.height), 0,
                          board.width, 0, board.height),
      0);
}

}  // namespace
}  // namespace zstrip::boards
