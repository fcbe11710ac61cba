// The player moves morph targets of a blob: in every frame the pixels of meshes that morph_mesh, and then skin_mesh,
// have moved, as the headers of `zstrip bake` do, through cross-fades too, in the memory that it asks for.
#include <algorithm>
#include <set>

#include "baked.hpp"
#include "c_picture.hpp"
#include "zstrip/clips.hpp"
#include "zstrip_hal/changed_tiles.hpp"
#include "zstrip_player/c_pipeline.hpp"

namespace zstrip::test {
namespace {

/// A model with morph targets, its player, and what its blob holds.
struct Morphing {
  Blob blob;
  Screen screen{96, 96, hal::DisplayFormat::rgb565};
  Memory memory;
  Player player{memory.span(), drawn_with_any};
  Memory tables{1 << 20};
  SceneBlob opened;

  explicit Morphing(const char* name, std::size_t bytes = 1 << 20) : blob(blob_of(name)), memory(bytes) {
    EXPECT_TRUE(open_scene_blob(blob.memory.span(), tables.span(), opened));
  }
  bool open_and_fit() { return player.open(blob.data(), blob.size()) && player.fit(screen.display); }
  const std::vector<std::byte>& drawn() {
    EXPECT_TRUE(player.draw(screen.display)) << player.error();
    return screen.pixels;
  }
  std::vector<MorphWeight> weights(std::size_t clip, std::uint32_t time) const {
    std::vector<MorphWeight> weights(opened.morphs.weights.size());
    pose(opened.clips[clip].weights, time, weights);
    return weights;
  }
  std::vector<JointPose> joints(std::size_t clip, std::uint32_t time) const {
    std::vector<JointPose> joints;
    if (!opened.skins.empty()) joints.assign(opened.skins[0].rest.begin(), opened.skins[0].rest.end());
    pose(opened.clips[clip].joints, time, joints);
    return joints;
  }

  /// The picture of meshes that the functions of headers have moved.
  std::vector<std::byte> expected(const std::vector<MorphWeight>& weights, const std::vector<JointPose>& joints) const {
    struct Vertices {
      std::vector<Position> positions;
      std::vector<Normal> normals;
      std::vector<Meshlet> meshlets;
    };
    std::vector<Mesh> meshes(opened.scene.meshes.begin(), opened.scene.meshes.end());
    std::vector<Vertices> vertices(meshes.size());
    std::vector<Transform> work(joints.size());
    const auto memory_of = [&](std::size_t mesh) {
      Vertices& own = vertices[mesh];
      own.positions.resize(meshes[mesh].positions.size());
      own.normals.resize(meshes[mesh].normals.size());
      own.meshlets.resize(meshes[mesh].meshlets.size());
      return MovedVertices{own.positions, own.normals, own.meshlets};
    };
    for (const MovedMorph& morph : opened.morphs.meshes) {
      const MovedVertices moved = memory_of(morph.mesh);
      EXPECT_TRUE(morph_mesh(morph.morph, weights, moved));
      meshes[morph.mesh] = moved_mesh(meshes[morph.mesh], moved);
    }
    for (const Skin& of_blob : opened.skins) {
      const auto index = static_cast<std::size_t>(of_blob.mesh - opened.scene.meshes.data());
      const Mesh before = meshes[index];
      Skin skin = of_blob;
      skin.mesh = &before;
      const MovedVertices moved = memory_of(index);
      EXPECT_TRUE(skin_mesh(skin, joints, work, moved));
      meshes[index] = moved_mesh(before, moved);
      meshes[index].skinning = nullptr;
    }
    Scene scene = opened.scene;
    scene.meshes = meshes;
    const View view{screen.display.width(), screen.display.height(), static_cast<PixelFormat>(screen.display.format())};
    const Camera camera = scenes::fit_width(opened.camera_for(2), opened.view, view);
    const Effects effects = effects_of(scene, camera) | effects_of(view);
    const PlanResult planned = plan(count(scene), view, effects, {.strip_rows = view.height});
    EXPECT_TRUE(planned.status);
    AnyRenderer renderer(effects);
    Memory arena(planned.plan.bytes());
    Memory pixels(planned.plan.strip_pixel_bytes(view));
    EXPECT_TRUE(renderer.begin_frame(scene, camera, view, planned.plan, arena.span()));
    EXPECT_TRUE(renderer.draw_strip(0, pixels.span()));
    return {pixels.span().begin(), pixels.span().end()};
  }
  std::vector<std::byte> expected(std::size_t clip, std::uint32_t time) const {
    return expected(weights(clip, time), joints(clip, time));
  }
};

TEST(PlayerMorphs, AreDrawnAsByAHeader) {
  for (const char* name : {"morph_cube", "morph_face"}) {
    Morphing model(name);
    ASSERT_TRUE(model.open_and_fit()) << model.player.error();
    std::set<std::vector<std::byte>> pictures;
    for (std::size_t clip = 0; clip < model.opened.clips.size(); ++clip) {
      ASSERT_TRUE(model.player.play_clip(clip));
      for (const std::uint32_t time : {0U, 130U, 333U, 700U}) {
        model.player.seek(time);
        const std::vector<std::byte> expected = model.expected(clip, model.player.time());
        EXPECT_EQ(model.drawn(), expected) << name << ' ' << clip << " at " << time;
        pictures.insert(expected);
      }
    }
    EXPECT_GT(pictures.size(), 3 * model.opened.clips.size()) << "it moves";
  }
}

TEST(PlayerMorphs, FadesMixWeights) {
  Morphing face("morph_face");
  ASSERT_TRUE(face.open_and_fit()) << face.player.error();
  Player& player = face.player;
  player.play(1000);
  player.play(1300);
  ASSERT_TRUE(player.play_clip(player.find_clip("puff"), 512));
  for (std::uint32_t passed = 0; passed < 512; passed += 128) {
    player.play(1300 + passed);
    std::vector<MorphWeight> weights = face.weights(0, 300 + passed);
    const std::vector<MorphWeight> to = face.weights(1, passed);
    for (std::size_t i = 0; i < weights.size(); ++i) {
      weights[i] = static_cast<MorphWeight>(weights[i] + ((to[i] - weights[i]) * static_cast<int>(passed) >> 9));
    }
    std::vector<JointPose> joints = face.joints(0, 300 + passed);
    blend(joints, face.joints(1, passed), 65536 * passed / 512);
    EXPECT_EQ(face.drawn(), face.expected(weights, joints)) << passed;
  }
  player.play(1300 + 512);
  EXPECT_EQ(face.drawn(), face.expected(1, 512));
}

/// Strips that a display shows already are left out, but none that a weight changes.
TEST(PlayerMorphs, StripsThatWeightsChangeAreDrawn) {
  Morphing cube("morph_cube");
  hal::ChangedTiles<hal::Framebuffer, 36> tiles(cube.screen.display);
  ASSERT_TRUE(cube.player.open(cube.blob.data(), cube.blob.size()));
  ASSERT_TRUE(cube.player.fit(tiles, {.strip_rows = 16}));
  cube.player.play(0);
  for (std::uint32_t time = 0; time < 1500; time += 90) {
    cube.player.play(time);
    ASSERT_TRUE(cube.player.draw(tiles)) << cube.player.error();
    EXPECT_EQ(cube.screen.pixels, cube.expected(0, cube.player.time())) << time;
  }
}

/// Nothing outside of the rectangle changes.
TEST(PlayerMorphs, ChangeTheirRectangle) {
  Morphing cube("morph_cube");
  ASSERT_TRUE(cube.player.open(cube.blob.data(), cube.blob.size()));
  ASSERT_TRUE(cube.player.fit(cube.screen.display, {.strip_rows = 16, .tracks_changes = true}));
  Player& player = cube.player;
  (void)player.changed();
  std::vector<std::byte> before = cube.drawn();
  EXPECT_TRUE(player.changed().empty());
  player.play(0);
  int moved = 0;
  for (std::uint32_t time = 100; time < 1500; time += 100) {
    player.play(time);
    const std::vector<std::byte> now = cube.drawn();
    const Rect changed = player.changed();
    for (std::int32_t i = 0; i < 96 * 96; ++i) {
      const bool inside =
          i % 96 >= changed.left && i % 96 < changed.right && i / 96 >= changed.top && i / 96 < changed.bottom;
      const auto byte = static_cast<std::size_t>(2 * i);
      ASSERT_TRUE(inside || (now[byte] == before[byte] && now[byte + 1] == before[byte + 1])) << time << ' ' << i;
    }
    moved += now != before ? 1 : 0;
    before = now;
  }
  EXPECT_GT(moved, 5);
}

/// What the scene takes is what character_memory says, and the player draws in no byte more than it asks for.
TEST(PlayerMorphs, TakeTheMemoryOfTheirMeshes) {
  Morphing least("morph_face", 0);
  std::size_t size = 0;
  for (int tries = 0; tries < 6; ++tries) {
    Memory memory(size);
    Player player(memory.span(), drawn_with_any);
    if (player.open(least.blob.data(), least.blob.size()) && player.fit(least.screen.display)) break;
    const std::string words = player.error();
    ASSERT_NE(words.find(" bytes of memory are missing: "), std::string::npos) << words;
    size += std::stoul(words);
  }
  Morphing face("morph_face", size);
  ASSERT_TRUE(face.open_and_fit()) << face.player.error();
  ASSERT_TRUE(face.player.play_clip(1));
  face.player.seek(200);
  EXPECT_EQ(face.drawn(), face.expected(1, 200));
  const SceneBlob& opened = face.opened;
  CharacterCounts counts{.skins = 1, .joints = 2, .clips = 3, .morphs = 2, .targets = 3, .weights = 3};
  for (const Meshlet& meshlet : opened.skins[0].mesh->meshlets) {
    counts.positions = std::max<std::uint32_t>(counts.positions, meshlet.vertex_count);
  }
  counts.normals = counts.positions;
  for (const MovedMorph& morph : opened.morphs.meshes) {
    counts.morphed_positions += morph.vertices.positions.size();
    counts.morphed_normals += morph.vertices.normals.size();
    counts.morphed_meshlets += morph.vertices.meshlets.size();
  }
  EXPECT_EQ(opened.memory_bytes, scene_blob_memory(2, 0) + character_memory(counts));
}

/// All numbers that are due now.
std::vector<int> polled(Player& player) {
  std::vector<int> numbers;
  for (std::uint16_t number = 0; player.poll_event(number);) numbers.push_back(number);
  return numbers;
}

using Numbers = std::vector<int>;

/// Of "talk", which takes a second: 7 at its beginning, 9 in its middle; of "puff", 800 ms: 2 at 300 ms.
TEST(PlayerEvents, ComeOnceInEachRepetition) {
  Morphing face("morph_face");
  ASSERT_TRUE(face.open_and_fit()) << face.player.error();
  Player& player = face.player;
  EXPECT_EQ(polled(player), Numbers{7});
  EXPECT_EQ(polled(player), Numbers{});
  player.play(1000);
  player.play(1499);
  EXPECT_EQ(polled(player), Numbers{});
  player.play(1500);
  EXPECT_EQ(polled(player), Numbers{9});
  player.play(1501);
  EXPECT_EQ(polled(player), Numbers{});
  player.play(1999);
  EXPECT_EQ(polled(player), Numbers{});
  player.play(2000);
  EXPECT_EQ(polled(player), Numbers{7}) << "again";
  player.play(2700);
  EXPECT_EQ(polled(player), Numbers{9});
  player.play(3600);
  EXPECT_EQ(polled(player), (Numbers{7, 9})) << "in their order";
  player.hold(true);
  player.play(9000);
  EXPECT_EQ(polled(player), Numbers{});
  player.hold(false);
  player.seek(500);
  EXPECT_EQ(polled(player), Numbers{9}) << "from that time on";
  ASSERT_TRUE(player.play_clip(1, 200));
  EXPECT_EQ(polled(player), Numbers{});
  player.play(9300);
  EXPECT_EQ(polled(player), Numbers{2});
  ASSERT_TRUE(player.play_clip(1, 0, false));
  player.play(12000);
  EXPECT_EQ(polled(player), Numbers{2});
  player.play(15000);
  EXPECT_EQ(polled(player), Numbers{}) << "it has stopped";
  ASSERT_TRUE(player.play_clip(2));
  player.play(16000);
  EXPECT_EQ(polled(player), Numbers{}) << "a clip without events";
}

TEST(PlayerEvents, OfAnimationsWithoutClips) {
  Morphing scene("events");
  EXPECT_TRUE(scene.opened.clips.empty());
  ASSERT_TRUE(scene.open_and_fit()) << scene.player.error();
  scene.player.play(0);
  EXPECT_EQ(polled(scene.player), Numbers{});
  scene.player.play(1200);
  EXPECT_EQ(polled(scene.player), (Numbers{3, 65535}));
  scene.player.play(2300);
  EXPECT_EQ(polled(scene.player), Numbers{3});
  // A header would have these constants of the same scene.
  const SceneBlob& opened = scene.opened;
  ASSERT_TRUE(
      scene.player.open({opened.scene, opened.camera, opened.animation, opened.turn}, opened.view, opened.events));
  scene.player.play(5000);
  EXPECT_EQ(polled(scene.player), Numbers{});
  scene.player.play(6200);
  EXPECT_EQ(polled(scene.player), (Numbers{3, 65535}));
}

TEST(PlayerEvents, InC) {
  constexpr zstrip_pipeline kPipeline{drawn_with_any};
  Morphing face("morph_face");
  Memory memory(200'000);
  zstrip_player* const player = zstrip_player_in(memory.span().data(), memory.span().size(), &kPipeline);
  ASSERT_TRUE(zstrip_player_open(player, face.blob.data(), face.blob.size()));
  std::uint16_t number = 0;
  EXPECT_EQ(zstrip_player_poll_event(nullptr, &number), 0);
  EXPECT_EQ(zstrip_player_poll_event(player, nullptr), 0);
  EXPECT_EQ(zstrip_player_poll_event(player, &number), 1);
  EXPECT_EQ(number, 7);
  EXPECT_EQ(zstrip_player_poll_event(player, &number), 0);
}

/// Against a list of every millisecond.
TEST(PlayerEvents, AreThoseOfEveryMillisecond) {
  constexpr ClipEvent kEvents[] = {{0, 1, 5}, {1, 2, 0}, {1, 3, 4}, {1, 4, 5}, {1, 5, 9}};
  for (std::uint32_t step = 1; step <= 10; ++step) {
    std::uint32_t from = 0;
    Numbers found, expected;
    for (std::uint32_t now = 0, next = 0; now < 200; now += step) {
      while (const ClipEvent* event = next_event(kEvents, 1, now % 10, 10, from)) found.push_back(event->number);
      for (; next <= now; ++next) {
        for (const ClipEvent& event : kEvents) {
          if (event.clip == 1 && event.time == next % 10) expected.push_back(event.number);
        }
      }
    }
    if (step == 10) {
      EXPECT_EQ(found, Numbers{2}) << "nothing seems to have passed";
    } else {
      EXPECT_EQ(found, expected) << step;
    }
  }
}

TEST(PlayerMorphs, PlayInC) {
  constexpr zstrip_pipeline kPipeline{drawn_with_any};
  Morphing face("morph_face");
  Memory memory(200'000);
  zstrip_player* const player = zstrip_player_in(memory.span().data(), memory.span().size(), &kPipeline);
  ASSERT_NE(player, nullptr);
  ASSERT_TRUE(zstrip_player_open(player, face.blob.data(), face.blob.size())) << zstrip_player_error(player);
  ASSERT_TRUE(zstrip_player_fit(player, 96, 96, ZSTRIP_RGB565, 1)) << zstrip_player_error(player);
  ASSERT_EQ(zstrip_player_clips(player), 3U);
  ASSERT_EQ(zstrip_player_play_clip(player, 1, 0, 1), 1);
  zstrip_player_play(player, 0);
  zstrip_player_play(player, 220);
  EXPECT_EQ(picture_in_c(player), face.expected(1, 220));
}

}  // namespace
}  // namespace zstrip::test
