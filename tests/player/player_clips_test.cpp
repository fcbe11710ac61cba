// The player plays the clips of a blob: in every frame the pixels of meshes that skin_mesh has moved, as the headers of
// `zstrip bake` do, through cross-fades too, in the memory that it asks for.
#include <set>

#include "baked.hpp"
#include "c_picture.hpp"
#include "zstrip/clips.hpp"
#include "zstrip/skin.hpp"
#include "zstrip_player/c_pipeline.hpp"

namespace zstrip::test {
namespace {

/// A clip at a time, and the share by which the clips before it have become it.
struct At {
  std::size_t clip;
  std::uint32_t time;
  std::uint32_t share = 65536;
};

/// The picture of a figure, posed, blended and moved by the functions that headers call.
std::vector<std::byte> drawn_as_by_a_header(Blob& blob, const Screen& screen, std::initializer_list<At> played) {
  SceneBlob opened;
  Memory tables(1 << 20);
  EXPECT_TRUE(open_scene_blob(blob.memory.span(), tables.span(), opened));
  std::vector<JointPose> joints;
  for (const At& at : played) {
    std::vector<JointPose> others(opened.skins[0].rest.begin(), opened.skins[0].rest.end());
    pose(opened.clips[at.clip].joints, at.time, others);
    if (joints.empty()) {
      joints = others;
    } else {
      blend(joints, others, at.share);
    }
  }
  std::vector<Mesh> meshes(opened.scene.meshes.begin(), opened.scene.meshes.end());
  std::vector<std::vector<Position>> positions(opened.skins.size());
  std::vector<std::vector<Normal>> normals(opened.skins.size());
  std::vector<std::vector<Meshlet>> meshlets(opened.skins.size());
  std::vector<Transform> work(joints.size());
  for (std::size_t i = 0; i < opened.skins.size(); ++i) {
    const Mesh& bind = *opened.skins[i].mesh;
    positions[i].resize(bind.positions.size());
    normals[i].resize(bind.normals.size());
    meshlets[i].resize(bind.meshlets.size());
    const MovedVertices moved{positions[i], normals[i], meshlets[i]};
    EXPECT_TRUE(skin_mesh(opened.skins[i], joints, work, moved));
    Mesh& mesh = meshes[static_cast<std::size_t>(opened.skins[i].mesh - opened.scene.meshes.data())];
    mesh = moved_mesh(bind, moved);
    mesh.skinning = nullptr;
  }
  Scene scene = opened.scene;
  scene.meshes = meshes;
  const View view{screen.display.width(), screen.display.height(), static_cast<PixelFormat>(screen.display.format())};
  const Camera camera = scenes::fit_width(opened.camera_for(2), opened.view, view);
  const Effects effects = effects_of(scene, camera) | effects_of(view);
  EXPECT_FALSE(effects.has(effect::skins));
  const PlanResult planned = plan(count(scene), view, effects, {.strip_rows = view.height});
  EXPECT_TRUE(planned.status);
  AnyRenderer renderer(effects);
  Memory arena(planned.plan.bytes());
  Memory pixels(planned.plan.strip_pixel_bytes(view));
  EXPECT_TRUE(renderer.begin_frame(scene, camera, view, planned.plan, arena.span()));
  EXPECT_TRUE(renderer.draw_strip(0, pixels.span()));
  return {pixels.span().begin(), pixels.span().end()};
}

struct Figure {
  Blob blob = blob_of("figure");
  Screen screen{96, 128, hal::DisplayFormat::rgb565};
  Memory memory;
  Player player{memory.span(), drawn_with_any};
  explicit Figure(std::size_t bytes = 1 << 20) : memory(bytes) {}
  bool open_and_fit() { return player.open(blob.data(), blob.size()) && player.fit(screen.display); }
  const std::vector<std::byte>& drawn() {
    EXPECT_TRUE(player.draw(screen.display)) << player.error();
    return screen.pixels;
  }
  std::vector<std::byte> expected(std::initializer_list<At> played) {
    return drawn_as_by_a_header(blob, screen, played);
  }
};

TEST(PlayerClips, HaveNamesAndTimes) {
  Figure figure;
  EXPECT_TRUE(figure.player.clips().empty());
  ASSERT_TRUE(figure.open_and_fit()) << figure.player.error();
  ASSERT_EQ(figure.player.clips().size(), 2U);
  EXPECT_STREQ(figure.player.clips()[0].name, "walk");
  EXPECT_STREQ(figure.player.clips()[1].name, "wave");
  EXPECT_EQ(figure.player.find_clip("wave"), 1U);
  EXPECT_EQ(figure.player.find_clip("walk"), 0U);
  EXPECT_EQ(figure.player.find_clip("wav"), 2U);
  EXPECT_EQ(figure.player.find_clip("waves"), 2U);
  EXPECT_EQ(figure.player.period(), figure.player.clips()[0].duration());
}

TEST(PlayerClips, AreDrawnAsByAHeader) {
  Figure figure;
  ASSERT_TRUE(figure.open_and_fit()) << figure.player.error();
  std::set<std::vector<std::byte>> pictures;
  for (const std::size_t clip : {0U, 1U}) {
    ASSERT_TRUE(figure.player.play_clip(clip));
    for (const std::uint32_t time : {0U, 100U, 333U, 700U, 1900U}) {
      figure.player.seek(time);
      const std::vector<std::byte> expected = figure.expected({{clip, figure.player.time()}});
      EXPECT_EQ(figure.drawn(), expected) << clip << " at " << time;
      pictures.insert(expected);
    }
  }
  EXPECT_GT(pictures.size(), 6U) << "it moves";
}

TEST(PlayerClips, FadeIntoEachOther) {
  Figure figure;
  ASSERT_TRUE(figure.open_and_fit()) << figure.player.error();
  Player& player = figure.player;
  player.play(5000);
  player.play(5250);
  ASSERT_TRUE(player.play_clip(player.find_clip("wave"), 400));
  for (std::uint32_t passed = 0; passed < 400; passed += 80) {
    player.play(5250 + passed);
    EXPECT_EQ(player.time(), passed);
    EXPECT_EQ(figure.drawn(), figure.expected({{0, 250 + passed}, {1, passed, 65536 * passed / 400}})) << passed;
  }
  player.play(5650);
  EXPECT_EQ(figure.drawn(), figure.expected({{1, 400}}));
  // Back, and on at once: nothing jumps.
  ASSERT_TRUE(player.play_clip(0, 200));
  player.play(5700);
  ASSERT_TRUE(player.play_clip(1, 100));
  const std::vector<std::byte> before = figure.drawn();
  EXPECT_EQ(before, figure.expected({{1, 450}, {0, 50, 16384}}));
  player.play(5750);
  EXPECT_EQ(figure.drawn(), figure.expected({{1, 500}, {0, 100, 32768}, {1, 50, 32768}}));
  player.hold(true);
  player.play(9000);
  EXPECT_EQ(player.time(), 50U);
  player.seek(60);
  EXPECT_EQ(figure.drawn(), figure.expected({{1, 60}})) << "a fade ends";
}

/// The rectangle outside of which nothing changed has what the joints moved.
TEST(PlayerClips, ChangeTheirRectangle) {
  Figure figure;
  ASSERT_TRUE(figure.open_and_fit()) << figure.player.error();
  Player& player = figure.player;
  (void)player.changed();
  std::vector<std::byte> before = figure.drawn();
  EXPECT_TRUE(player.changed().empty());
  for (int step = 0; step < 12; ++step) {
    if (step == 4) {
      ASSERT_TRUE(player.play_clip(1, 400));
    }
    player.play(static_cast<std::uint32_t>(90 * step));
    const std::vector<std::byte> now = figure.drawn();
    const Rect changed = player.changed();
    for (std::int32_t i = 0; i < 96 * 128; ++i) {
      const bool inside =
          i % 96 >= changed.left && i % 96 < changed.right && i / 96 >= changed.top && i / 96 < changed.bottom;
      const auto byte = static_cast<std::size_t>(2 * i);
      ASSERT_TRUE(inside || (now[byte] == before[byte] && now[byte + 1] == before[byte + 1])) << step << ' ' << i;
    }
    EXPECT_EQ(changed.empty(), now == before) << step;
    before = now;
  }
}

/// Time that passes between the begin of a frame and changed() belongs to the next frame.
TEST(PlayerClips, TheirRectangleIsThatOfTheFrameThatWasBegun) {
  Figure figure;
  ASSERT_TRUE(figure.open_and_fit()) << figure.player.error();
  Player& player = figure.player;
  player.play(0);
  ASSERT_TRUE(player.begin());
  (void)player.changed();
  player.play(200);
  EXPECT_TRUE(player.changed().empty());
  ASSERT_TRUE(player.begin());
  EXPECT_FALSE(player.changed().empty());
}

TEST(PlayerClips, StopAtTheirEndOrRepeat) {
  Figure figure;
  ASSERT_TRUE(figure.open_and_fit()) << figure.player.error();
  Player& player = figure.player;
  const std::uint32_t duration = player.clips()[1].duration();
  player.play(0);
  ASSERT_TRUE(player.play_clip(1, 0, false));
  player.play(100'000);
  EXPECT_EQ(player.time(), duration - 1);
  EXPECT_EQ(figure.drawn(), figure.expected({{1, duration - 1}}));
  ASSERT_TRUE(player.play_clip(1));
  player.play(100'000 + duration + 7);
  EXPECT_EQ(player.time(), 7U);
}

/// What the scene takes is what character_memory says, and the player draws in no byte more than it asks for.
TEST(PlayerClips, TakeTheMemoryOfAMeshletAndOfTheJoints) {
  Figure least(0);
  std::size_t size = 0;
  for (int tries = 0; tries < 6; ++tries) {
    Memory memory(size);
    Player player(memory.span(), drawn_with_any);
    if (player.open(least.blob.data(), least.blob.size()) && player.fit(least.screen.display)) break;
    const std::string words = player.error();
    ASSERT_NE(words.find(" bytes of memory are missing: "), std::string::npos) << words;
    size += std::stoul(words);
  }
  Figure figure(size);
  ASSERT_TRUE(figure.open_and_fit()) << figure.player.error();
  ASSERT_TRUE(figure.player.play_clip(1, 1000));
  figure.player.play(0);
  figure.player.play(500);
  EXPECT_EQ(figure.drawn(), figure.expected({{0, 500}, {1, 500, 32768}}));
  SceneBlob opened;
  Memory tables(1 << 20);
  ASSERT_TRUE(open_scene_blob(figure.blob.memory.span(), tables.span(), opened));
  std::uint32_t largest = 0;
  for (const Skin& skin : opened.skins) {
    for (const Meshlet& meshlet : skin.mesh->meshlets) largest = std::max<std::uint32_t>(largest, meshlet.vertex_count);
  }
  ASSERT_GT(largest, 0U);
  const auto skins = static_cast<std::uint32_t>(opened.skins.size());
  const auto joints = static_cast<std::uint32_t>(opened.skins[0].joints.size());
  EXPECT_EQ(
      opened.memory_bytes,
      scene_blob_memory(static_cast<std::uint32_t>(opened.scene.meshes.size()), 0) +
          character_memory({.skins = skins, .joints = joints, .clips = 2, .positions = largest, .normals = largest}));
}

TEST(PlayerClips, ThatAreNotThereAreSaidSo) {
  Figure figure;
  EXPECT_FALSE(figure.player.play_clip(0));
  EXPECT_STREQ(figure.player.error(), "no scene is open: open() comes first");
  ASSERT_TRUE(figure.open_and_fit());
  EXPECT_FALSE(figure.player.play_clip(2));
  EXPECT_STREQ(figure.player.error(), "there is no clip 2: the scene has 2 clips");
  EXPECT_FALSE(figure.player.play_clip(0x10000));
  EXPECT_EQ(figure.player.clip(), 0U);
  // What cannot be opened has no clips, and time goes on.
  EXPECT_FALSE(figure.player.open(figure.blob.data(), 100));
  EXPECT_TRUE(figure.player.clips().empty());
  figure.player.play(0);
  figure.player.play(100);
  EXPECT_EQ(figure.player.time(), 100U);
  Blob lit = blob_of("teapot_meshlets");
  ASSERT_TRUE(figure.player.open(lit.data(), lit.size()));
  EXPECT_FALSE(figure.player.play_clip(0));
  EXPECT_STREQ(figure.player.error(), "there is no clip 0: the scene has 0 clips");
}

TEST(PlayerClips, OtherTextBeforeTheRateStoppedThemAndTheRate) {
  Figure figure;
  ASSERT_TRUE(figure.open_and_fit());
  const auto shown = [&figure](const char* text, bool with_rate) {
    figure.player.show_text(text, with_rate);
    return figure.drawn();
  };
  for (std::uint32_t now = 0; now <= 1000; now += 100) {
    figure.player.show_text(now % 200 == 0 ? "even " : "an odd one ", true);
    figure.player.play(now);
    EXPECT_EQ(figure.player.time(), now);
    if (now < 1000) figure.drawn();
  }
  const auto odd = shown("an odd one ", true), even = shown("even ", true);
  EXPECT_EQ(odd, shown("an odd one 10 fps", false));
  EXPECT_EQ(even, shown("even 10 fps", false));
  EXPECT_NE(even, odd);
}

TEST(PlayerClips, PlayInC) {
  constexpr zstrip_pipeline kPipeline{drawn_with_any};
  Figure figure;
  Memory memory(100'000);
  zstrip_player* const player = zstrip_player_in(memory.span().data(), memory.span().size(), &kPipeline);
  ASSERT_NE(player, nullptr);
  EXPECT_EQ(zstrip_player_clips(player), 0U);
  EXPECT_EQ(zstrip_player_clip_name(player, 0), nullptr);
  ASSERT_TRUE(zstrip_player_open(player, figure.blob.data(), figure.blob.size())) << zstrip_player_error(player);
  ASSERT_TRUE(zstrip_player_fit(player, 96, 128, ZSTRIP_RGB565, 1)) << zstrip_player_error(player);
  ASSERT_EQ(zstrip_player_clips(player), 2U);
  EXPECT_STREQ(zstrip_player_clip_name(player, 1), "wave");
  EXPECT_EQ(zstrip_player_clip_name(player, 2), nullptr);
  EXPECT_GT(zstrip_player_clip_time(player, 1), 0U);
  EXPECT_EQ(zstrip_player_clip_time(player, 2), 0U);
  EXPECT_EQ(zstrip_player_clips(nullptr), 0U);
  EXPECT_EQ(zstrip_player_play_clip(nullptr, 0, 0, 1), 0);
  EXPECT_EQ(zstrip_player_play_clip(player, 2, 0, 1), 0);
  ASSERT_EQ(zstrip_player_play_clip(player, 1, 200, 1), 1);
  zstrip_player_play(player, 0);
  zstrip_player_play(player, 50);
  EXPECT_EQ(picture_in_c(player), figure.expected({{0, 50}, {1, 50, 16384}}));
}

}  // namespace
}  // namespace zstrip::test
