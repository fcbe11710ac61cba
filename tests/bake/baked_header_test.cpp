// A baked header draws, byte for byte, what `zstrip render` draws of the scene that it was baked from. One object file
// for all headers: what is of a header comes from baked_alone.hpp and from baked_from.hpp.
#include <algorithm>
#include <memory>

#include "baked_alone.hpp"
#include "baked_from.hpp"
#include "command_report.hpp"
#include "linked_effects.hpp"
#include "support.hpp"
#include "zstrip_scenes/stage.hpp"

namespace zstrip::sim::test {
namespace {

using baked_alone::header;

/// Puts strips, which may be narrower than the picture, into the picture.
std::vector<std::byte> picture;
void send(std::uint16_t strip, std::span<const std::byte> pixels) {
  const Rect area = header.plan.strip_area(strip, header.view);
  const auto bytes = [](std::int32_t columns) {
    return static_cast<std::ptrdiff_t>(bytes_per_row(static_cast<std::uint16_t>(columns), header.view.format));
  };
  for (std::int32_t row = 0; row < area.height(); ++row) {
    std::copy_n(pixels.begin() + row * bytes(area.width()), bytes(area.width()),
                picture.begin() + (area.top + row) * bytes(header.view.width) + bytes(area.left));
  }
}

class BakedHeader : public FolderTest {
 protected:
  BakedHeader() {
    picture.assign(std::size_t{bytes_per_row(header.view.width, header.view.format)} * header.view.height,
                   std::byte{0xAA});
  }
  /// Checksums of `zstrip render`'s frames: one, or of a turntable four of a turn.
  std::vector<std::string> rendered() {
    return rendered_frames(baked_from.scene, baked_from.options, turntable_, path(""));
  }
  /// For one strip, and not a byte more.
  std::span<std::byte> pixels() { return {pixels_.get(), header.plan.strip_pixel_bytes(header.view)}; }
  bool turntable_ = !header.animation.tracks.empty() || header.moving_duration != 0 ||
                    is_turntable(baked_from.options);  ///< it moves

 private:
  std::unique_ptr<std::byte[]> pixels_ = std::make_unique<std::byte[]>(header.plan.strip_pixel_bytes(header.view));
};

TEST_F(BakedHeader, DrawsWhatTheModelDraws) {
  const std::vector<std::string> expected = rendered();
  ASSERT_FALSE(expected.empty());
  const Status drawn = baked_alone::draw(pixels(), send);
  ASSERT_TRUE(drawn) << message(drawn.error);
  EXPECT_EQ(crc32_of(picture), expected[0]);
}

TEST_F(BakedHeader, TurnsAsTheModelTurns) {
  const std::vector<std::string> expected = rendered();
  ASSERT_EQ(expected.size(), turntable_ ? 4U : 1U);
  if (turntable_) {
    EXPECT_NE(expected[0], expected[1]);
  }
  for (std::uint32_t frame = 0; frame < expected.size(); ++frame) {
    std::vector<Instance> instances(header.scene.instances.begin(), header.scene.instances.end());
    Camera camera = header.camera;
    if (header.animation.tracks.empty() && header.turn.what == Turning::camera) {
      camera = scenes::turned(camera, frame, 4);
    } else if (header.animation.tracks.empty() && header.turn.what != Turning::nothing) {
      for (std::size_t i = header.turn.still_instances; i < instances.size(); ++i) {
        instances[i].transform = scenes::turned(instances[i].transform, frame, 4);
      }
    } else if (!header.animation.tracks.empty()) {
      pose(header.animation, time_of_frame(header.animation, frame, 4), instances);
    }
    if (header.moving_duration != 0) {
      const Status moved = header.pose(time_of_frame(Animation{{}, {}, header.moving_duration}, frame, 4));
      ASSERT_TRUE(moved) << message(moved.error);
    }
    Scene scene = header.scene;
    scene.instances = instances;
    const Status drawn = baked_alone::draw_moved(scene, camera, pixels(), send);
    ASSERT_TRUE(drawn) << message(drawn.error);
    EXPECT_EQ(crc32_of(picture), expected[frame]) << "frame " << frame;
  }
}

/// What `zstrip bake` chose is what the compiler finds, and within what was allowed.
TEST_F(BakedHeader, PlanIsTheOneThatWasReported) {
  const PlanReport plan = baked_plan(baked_from.report);
  EXPECT_EQ(plan.arena, header.plan.bytes());
  EXPECT_EQ(plan.strip_pixels, header.plan.strip_pixel_bytes(header.view));
  EXPECT_EQ(plan.strips, header.plan.strips);
  EXPECT_EQ(plan.mode, header.plan.mode == Mode::binned ? "binned" : "streamed");
  if (header.budget.bytes != 0) {
    EXPECT_LE(header.plan.bytes() + header.plan.strip_pixel_bytes(header.view), header.budget.bytes);
  }
}

/// This very program: of the core it links what the scene calls for.
TEST_F(BakedHeader, LinksOnlyTheScenesEffects) {
  expect_only(std::filesystem::read_symlink("/proc/self/exe").string(), header.effects);
}

}  // namespace
}  // namespace zstrip::sim::test
