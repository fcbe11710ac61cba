// A baked header draws, byte for byte, what `zstrip render` draws of the scene that it was baked from.
#include <algorithm>
#include <array>

#include "command_report.hpp"
#include "linked_effects.hpp"
#include "scene.hpp"
#include "support.hpp"
#include "zstrip/frame/renderer.hpp"
#include "zstrip_scenes/stage.hpp"

namespace baked_alone {
zstrip::Status draw(std::span<std::byte> pixels, void (*send)(std::uint16_t strip, std::span<const std::byte> pixels));
}

namespace zstrip::sim::test {
namespace {

/// Puts strips, which may be narrower than the picture, into the picture.
std::vector<std::byte> picture;
void send(std::uint16_t strip, std::span<const std::byte> pixels) {
  const Rect area = baked::kPlan.strip_area(strip, baked::kView);
  const auto bytes = [](std::int32_t columns) {
    return static_cast<std::ptrdiff_t>(bytes_per_row(static_cast<std::uint16_t>(columns), baked::kView.format));
  };
  for (std::int32_t row = 0; row < area.height(); ++row) {
    std::copy_n(pixels.begin() + row * bytes(area.width()), bytes(area.width()),
                picture.begin() + (area.top + row) * bytes(baked::kView.width) + bytes(area.left));
  }
}

class BakedHeader : public FolderTest {
 protected:
  BakedHeader() {
    picture.assign(std::size_t{bytes_per_row(baked::kView.width, baked::kView.format)} * baked::kView.height,
                   std::byte{0xAA});
  }
  /// Checksums of `zstrip render`'s frames: one, or of a turntable four of a turn.
  std::vector<std::string> rendered() { return rendered_frames(BAKED_SCENE, BAKED_OPTIONS, turntable_, path("")); }
  bool turntable_ = !baked::kAnimation.tracks.empty() || is_turntable(BAKED_OPTIONS);  ///< it moves
};

TEST_F(BakedHeader, DrawsWhatTheModelDraws) {
  const std::vector<std::string> expected = rendered();
  ASSERT_FALSE(expected.empty());
  alignas(4) std::array<std::byte, baked::kPlan.strip_pixel_bytes(baked::kView)> pixels{};
  const Status drawn = baked_alone::draw(pixels, send);
  ASSERT_TRUE(drawn) << message(drawn.error);
  EXPECT_EQ(crc32_of(picture), expected[0]);
}

TEST_F(BakedHeader, TurnsAsTheModelTurns) {
  const std::vector<std::string> expected = rendered();
  ASSERT_EQ(expected.size(), turntable_ ? 4U : 1U);
  if (turntable_) {
    EXPECT_NE(expected[0], expected[1]);
  }
  Renderer<baked::kEffects> renderer;
#ifdef BAKED_TREE
  renderer.set_visibility({.tree = &baked::kTree});
#endif
  std::vector<std::uint64_t> arena(baked::kPlan.bytes() / 8 + 1);
  alignas(4) std::array<std::byte, baked::kPlan.strip_pixel_bytes(baked::kView)> pixels{};
  for (std::uint32_t frame = 0; frame < expected.size(); ++frame) {
    std::vector<Instance> instances(std::begin(baked::kInstances), std::end(baked::kInstances));
    Camera camera = baked::kCamera;
    if (baked::kAnimation.tracks.empty() && baked::kTurn.what == Turning::camera) {
      camera = scenes::turned(camera, frame, 4);
    } else if (baked::kAnimation.tracks.empty()) {
      for (std::size_t i = baked::kTurn.still_instances; i < instances.size(); ++i) {
        instances[i].transform = scenes::turned(instances[i].transform, frame, 4);
      }
    } else {
      pose(baked::kAnimation, time_of_frame(baked::kAnimation, frame, 4), instances);
    }
    Scene scene = baked::kScene;
    scene.instances = instances;
    const Status begun =
        renderer.begin_frame(scene, camera, baked::kView, baked::kPlan, std::as_writable_bytes(std::span(arena)));
    ASSERT_TRUE(begun) << message(begun.error);
    for (std::uint16_t strip = 0; strip < baked::kPlan.strips; ++strip) {
      ASSERT_TRUE(renderer.draw_strip(strip, pixels));
      send(strip, pixels);
    }
    EXPECT_EQ(crc32_of(picture), expected[frame]) << "frame " << frame;
  }
}

/// What `zstrip bake` chose is what the compiler finds, and within what was allowed.
TEST_F(BakedHeader, PlanIsTheOneThatWasReported) {
  const std::optional<PlanReport> plan = baked_plan(BAKED_SCENE, BAKED_OPTIONS, path(""));
  ASSERT_TRUE(plan);
  EXPECT_EQ(plan->arena, baked::kPlan.bytes());
  EXPECT_EQ(plan->strip_pixels, baked::kPlan.strip_pixel_bytes(baked::kView));
  EXPECT_EQ(plan->strips, baked::kPlan.strips);
  EXPECT_EQ(plan->mode, baked::kPlan.mode == Mode::binned ? "binned" : "streamed");
  if (baked::kBudget.bytes != 0) {
    EXPECT_LE(baked::kPlan.bytes() + baked::kPlan.strip_pixel_bytes(baked::kView), baked::kBudget.bytes);
  }
}

/// This very program: of the core it links what the scene calls for.
TEST_F(BakedHeader, LinksOnlyTheScenesEffects) {
  expect_only(std::filesystem::read_symlink("/proc/self/exe").string(), baked::kEffects);
}

}  // namespace
}  // namespace zstrip::sim::test
