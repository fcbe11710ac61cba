// The boards with 16 KB and 8 KB of RAM in the emulator: the checksums of their pictures are those of the host's.
#include <gtest/gtest.h>

#include <cstdio>
#include <nlohmann/json.hpp>
#include <ostream>
#include <set>
#include <string>

#include "host_render.hpp"
#include "programs.hpp"
#include "qemu.hpp"

namespace zstrip::boards {
namespace {

struct SmallBoard {
  const char* machine;
  const char* program;
  const char* scene;
  std::uint16_t size;
};

std::ostream& operator<<(std::ostream& stream, const SmallBoard& board) { return stream << board.program; }

class SmallBoards : public testing::TestWithParam<SmallBoard> {};

TEST_P(SmallBoards, ChecksumsAreThoseOfTheHost) {
  const SmallBoard& board = GetParam();
  Qemu emulator({.machine = board.machine, .program = program(std::string("zstrip_") + board.program)});
  const std::string line = emulator.read_line();
  const auto report = nlohmann::json::parse(line, nullptr, false);
  ASSERT_FALSE(report.is_discarded()) << line;
  EXPECT_EQ(report["scene"], board.scene);
  EXPECT_EQ(report["width"], board.size);
  EXPECT_EQ(report["height"], board.size);
  EXPECT_GT(report["strips"], 1);
  const std::uint32_t frames_per_turn = report["frames_per_turn"];
  ASSERT_GE(report["frames"].size(), 3U);
  std::set<std::string> different;
  for (std::uint32_t frame = 0; frame < report["frames"].size(); ++frame) {
    char expected[9];
    std::snprintf(expected, sizeof expected, "%08x",
                  turntable_crc32(board.scene, frame, frames_per_turn, board.size, board.size));
    EXPECT_EQ(report["frames"][frame], expected) << "frame " << frame;
    different.insert(expected);
  }
  EXPECT_EQ(different.size(), report["frames"].size()) << "it does not turn";
}

INSTANTIATE_TEST_SUITE_P(Board, SmallBoards,
                         testing::Values(SmallBoard{"microbit", "microbit_teapot", "teapot_meshlets", 240},
                                         SmallBoard{"microbit", "microbit_knot", "knot_textured", 240},
                                         SmallBoard{"microbit", "microbit_room", "room", 240},
                                         SmallBoard{"stm32vldiscovery", "stm32vldiscovery_teapot", "teapot_meshlets",
                                                    128},
                                         SmallBoard{"stm32vldiscovery", "stm32vldiscovery_room", "room", 128}),
                         [](const auto& test) { return std::string(test.param.program); });

}  // namespace
}  // namespace zstrip::boards
