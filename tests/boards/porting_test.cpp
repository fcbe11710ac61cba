// The made-up board of docs/new-board.md, whose files the build has taken out of that page: it draws what another board
// with the same chip draws. What its panel gets is in panel_boards_test.cpp.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "programs.hpp"
#include "qemu.hpp"

namespace zstrip::boards {
namespace {

std::string first_line(const std::string& name) {
  Qemu board({.machine = "stm32vldiscovery", .program = program(name)});
  return board.read_line();
}

TEST(BoardPorting, ChecksumsAreThoseOfAnotherBoard) {
  const auto mine = nlohmann::json::parse(first_line("zstrip_my_board_checksums"));
  const auto other = nlohmann::json::parse(first_line("zstrip_stm32vldiscovery_teapot"));
  EXPECT_GE(mine["frames"].size(), 3U);
  EXPECT_EQ(mine["frames"], other["frames"]);
}

}  // namespace
}  // namespace zstrip::boards
