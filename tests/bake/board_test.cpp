// A model of one's own on the OLED of the EK-LM3S6965 in the emulator: what it shows is what `zstrip render` draws.
#include <algorithm>
#include <set>

#include "grey_picture.hpp"
#include "linked_effects.hpp"
#include "qemu.hpp"
#include "support.hpp"

namespace zstrip::sim::test {
namespace {

class BakeBoard : public FolderTest {
 protected:
  /// Eight frames of `program` are those of `zstrip render` of the model, all different.
  void expect_moves(const std::string& model, const std::string& program);
};

void BakeBoard::expect_moves(const std::string& model, const std::string& program) {
  constexpr int kFramesPerTurn = 64, kScreenScale = 4;
  const Outcome rendered = run(ZSTRIP_COMMAND,
                               {"render", model, "-o", "frames", "--size", "128x64", "--format", "gray4", "--image",
                                "raw", "--frames", std::to_string(kFramesPerTurn), "--quiet"},
                               path(""));
  ASSERT_EQ(rendered.status, 0) << rendered.err;

  boards::Qemu board({.machine = "lm3s6965evb", .program = program});
  board.write_console("p");
  std::set<std::string> pictures;
  for (int step = 0; step < 8; ++step) {
    const std::string line = board.read_line();
    ASSERT_TRUE(line.starts_with("frame ")) << line;
    char name[32];
    std::snprintf(name, sizeof name, "frames/frame_%04d.raw", std::stoi(line.substr(6)));
    const std::string expected = read(path(name));
    ASSERT_EQ(expected.size(), 128U * 64 / 2) << name;
    std::vector<std::byte> bytes(expected.size());
    std::transform(expected.begin(), expected.end(), bytes.begin(), [](char c) { return static_cast<std::byte>(c); });
    EXPECT_EQ(difference(boards::unpack_gray4(bytes, 128, 64), board.screen(kScreenScale)), "") << line;
    pictures.insert(expected);
    board.write_console("n");
  }
  EXPECT_EQ(pictures.size(), 8U) << "it does not move";
}

TEST_F(BakeBoard, OledShowsTheModelTurning) { expect_moves(BAKED_MODEL, BAKED_PROGRAM); }

/// A board's player that did not move the skin drew nothing, and no error.
TEST_F(BakeBoard, OledShowsASkinThatMoves) { expect_moves(BENDING_MODEL, BENDING_PROGRAM); }

/// The house is lit and smooth, and its door has no back, so that both sides are seen: of all other effects the program
/// holds nothing. It turns in front of the camera: no clipper either.
TEST_F(BakeBoard, ProgramLinksOnlyTheScenesEffects) {
  expect_only(BAKED_PROGRAM,
              effect::lighting | effect::gouraud | effect::shade_gouraud | effect::two_sided | effect::unclipped);
}

}  // namespace
}  // namespace zstrip::sim::test
