// Whole frames by two renderers, with two threads in the cores' place: the pixels of one core.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "second_core_thread.hpp"
#include "zstrip/renderer.hpp"
#include "zstrip/skin.hpp"
#include "zstrip_hal/second_core.hpp"
#include "zstrip_scenes/character.hpp"
#include "zstrip_scenes/knot_meshlets.hpp"
#include "zstrip_scenes/stage.hpp"

namespace zstrip::hal {
namespace {

/// A picture in RGB565.
struct Framebuffer {
  static constexpr std::uint16_t kColumns = 160, kRows = 120;
  std::vector<std::byte> bytes = std::vector<std::byte>(std::size_t{kColumns} * kRows * 2);

  std::uint16_t width() const { return kColumns; }
  std::uint16_t height() const { return kRows; }
  DisplayFormat format() const { return DisplayFormat::rgb565; }
  Error begin_frame() { return Error::none; }
  Error write(const Area& area, std::span<const std::byte> pixels) {
    std::ranges::copy(pixels, bytes.begin() + area.top * kColumns * 2);
    return Error::none;
  }
  Error wait() { return Error::none; }
  Error end_frame() { return Error::none; }
};

TEST(SecondCore, ThreadsDrawThePixelsOfOneCore) {
  constexpr const scenes::BuiltIn& kScene = scenes::knot_meshlets;
  constexpr Effects kEffects = effects_of(kScene.scene, kScene.camera);
  using SceneRenderer = Renderer<kEffects>;
  constexpr View kView{Framebuffer::kColumns, Framebuffer::kRows, zstrip::PixelFormat::rgb565};
  constexpr Plan kPlan = plan(kScene.counts, kView, kEffects, {.strip_rows = 11}).plan;
  alignas(kArenaAlignment) static std::array<std::byte, kPlan.bytes()> arenas[2];
  alignas(4) static std::array<std::byte, kPlan.strip_pixel_bytes(kView)> pixels[3];
  SceneRenderer own, other;
  SecondCore second(other);
  const Thread thread(second);
  Sleep clock;
  scenes::Staged staged;
  for (std::uint32_t frame = 0; frame < 12; ++frame) {
    scenes::stage(kScene, staged, frame, 12);
    const auto begin = [&] { return other.begin_frame(staged.scene, staged.camera, kView, kPlan, arenas[1]); };
    if (frame % 2 == 0) {
      second.start(begin);
    } else {
      ASSERT_TRUE(begin());
    }
    ASSERT_TRUE(own.begin_frame(staged.scene, staged.camera, kView, kPlan, arenas[0]));
    Framebuffer one, two;
    EXPECT_TRUE(present(own, one, {kPlan.strips, kPlan.strip_rows, kPlan.strip_columns}, {pixels[0], {}}));
    EXPECT_TRUE(present(own, second, two, {kPlan.strips, kPlan.strip_rows, kPlan.strip_columns},
                        {pixels[0], pixels[1], pixels[2]}, clock));
    EXPECT_EQ(one.bytes, two.bytes) << "frame " << frame;
  }
}

/// A core's own: a renderer with its arena, and of the character a mesh with what moves it.
struct CharacterOfOneCore {
  static constexpr View kView{Framebuffer::kColumns, Framebuffer::kRows, zstrip::PixelFormat::rgb565};
  static constexpr Effects kEffects = effects_of(scenes::character.scene, scenes::character.camera);
  static constexpr Plan kPlan = plan(scenes::character.counts, kView, kEffects, {.strip_rows = 5}).plan;

  Status begin(std::uint32_t frame) {
    ram.joints = scenes::kCharacterRest;
    pose(scenes::kCharacterWalk, frame * scenes::kCharacterFrameTime, ram.joints);
    const Status posed = pose_skin(skinning, ram.joints);
    if (!posed) return posed;
    scene.meshes = {&mesh, 1};
    return renderer.begin_frame(scene, scenes::character.camera, kView, kPlan, arena);
  }

  scenes::CharacterInRam ram{};
  Skinning skinning{
      .skin = &scenes::kCharacterSkin, .matrices = ram.matrices, .positions = ram.positions, .normals = ram.normals};
  Mesh mesh = [this] {
    Mesh moving = scenes::kCharacterBindMesh[0];
    moving.skinning = &skinning;
    return moving;
  }();
  Scene scene = scenes::character.scene;
  Renderer<kEffects> renderer;
  alignas(kArenaAlignment) std::array<std::byte, kPlan.bytes()> arena{};
};

TEST(SecondCore, ThreadsDrawAMovingSkinAsOneCoreDoes) {
  using Own = CharacterOfOneCore;
  static Own alone, first, other;
  static_assert(Own::kEffects.any(effect::skins));
  constexpr StripLayout kLayout{Own::kPlan.strips, Own::kPlan.strip_rows, Own::kPlan.strip_columns};
  alignas(4) static std::array<std::byte, Own::kPlan.strip_pixel_bytes(Own::kView)> pixels[3];
  SecondCore second(other.renderer);
  const Thread thread(second);
  Sleep clock;
  std::vector<std::byte> before;
  for (std::uint32_t frame = 0; frame < 25; ++frame) {
    Framebuffer one, two;
    ASSERT_TRUE(alone.begin(frame));
    ASSERT_TRUE(present(alone.renderer, one, kLayout, {pixels[0], {}}));
    const auto begin = [&] { return other.begin(frame); };
    second.start(begin);
    ASSERT_TRUE(first.begin(frame));
    ASSERT_TRUE(present(first.renderer, second, two, kLayout, {pixels[0], pixels[1], pixels[2]}, clock));
    EXPECT_EQ(one.bytes, two.bytes) << "frame " << frame;
    EXPECT_NE(one.bytes, before) << "frame " << frame;
    before = one.bytes;
  }
}

}  // namespace
}  // namespace zstrip::hal
