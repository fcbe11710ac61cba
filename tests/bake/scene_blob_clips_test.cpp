// Skins and clips of scene blobs: every byte is where docs/formats.md says, damage is refused, and the pixels are those
// of meshes that skin_mesh has moved, as the headers of `zstrip bake` do.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "../effects/creature.hpp"
#include "../oracle/draw.hpp"
#include "blob_sample.hpp"
#include "zstrip/zstrip.hpp"

namespace zstrip::sim::test {
namespace {

template <class Record, std::size_t count>
void expect_records(std::span<const Record> actual, const Record (&expected)[count]) {
  expect_same_bytes(actual, std::span<const Record>(expected));
}

TEST(SceneBlobClips, AreReadAsTheyWereWritten) {
  const Bytes bytes = skin_bytes();
  const Opened opened(bytes, kSkinMemory);
  ASSERT_TRUE(opened.status) << message(opened.status.error) << opened.status.needed;
  const SceneBlob& read = opened.content;
  ASSERT_EQ(read.skins.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(read.skins[i].mesh, &read.scene.meshes[i]);
    EXPECT_EQ(read.scene.meshes[i].skinning, &read.moved.skinnings[i]);
    expect_records(read.skins[i].vertices, kVertexJoints);
    expect_records(read.skins[i].rest, kRest);
    ASSERT_EQ(read.skins[i].joints.size(), 2U);
    EXPECT_EQ(read.skins[i].joints[0].parent, kNoJoint);
    EXPECT_EQ(read.skins[i].joints[1].parent, 0);
    EXPECT_EQ(read.skins[i].joints[0].inverse_bind.m[2][1], 8);
    EXPECT_EQ(read.moved.skinnings[i].positions.size(), 4U);
    EXPECT_EQ(read.moved.skinnings[i].matrices.size(), 2U);
  }
  EXPECT_TRUE(read.moved.skinnings[1].normals.empty()) << "the mesh has none";
  ASSERT_EQ(read.clips.size(), 2U);
  EXPECT_STREQ(read.clips[0].name, "walk");
  EXPECT_STREQ(read.clips[1].name, "w\xC3\xA4ve");
  EXPECT_EQ(read.clips[0].duration(), 1000U);
  EXPECT_EQ(read.clips[1].duration(), 700U);
  expect_records(read.clips[0].instances.tracks, kWalkInstances);
  EXPECT_TRUE(read.clips[1].instances.tracks.empty());
  const Track& wave = read.clips[1].joints.tracks[1];
  EXPECT_EQ(wave.first, 4U) << "after the keyframes of the walk";
  expect_same_bytes(read.clips[1].joints.keyframes.subspan(wave.first, wave.count),
                    std::span<const Keyframe>(kWaveKeys).subspan(1));
  EXPECT_EQ(read.animation.tracks.data(), read.clips[0].instances.tracks.data()) << "the first clip's";
  EXPECT_EQ(read.animation.duration, 1000U);
  EXPECT_EQ(read.turn.what, Turning::nothing);
  EXPECT_EQ(read.memory_bytes, kSkinMemory);
  EXPECT_TRUE(effects_of(read.scene, read.camera).has(effect::skins));
}

TEST(SceneBlobClips, WhatIsReadIsWrittenAgain) {
  const Bytes bytes = skin_bytes();
  const Opened opened(bytes, kSkinMemory);
  ASSERT_TRUE(opened.status);
  EXPECT_EQ(*to_scene_blob(opened.content), bytes);
}

/// From docs/formats.md.
TEST(SceneBlobClips, EachMemberIsAtItsPlace) {
  const Bytes bytes = skin_bytes();
  const std::uint32_t clip = section(bytes, "CLIP"), skin = section(bytes, "SKIN");
  ASSERT_EQ(section_bytes(bytes, "CLIP"), 2 * 28U);
  // The second clip: its name, no tracks of instances, two tracks of joints, its duration.
  const std::uint32_t expected[] = {5, 6, 1, 0, 1, 2, 700};
  for (std::uint32_t i = 0; i < 7; ++i) EXPECT_EQ(word(bytes, clip + 28 + 4 * i), expected[i]) << i;
  ASSERT_EQ(section_bytes(bytes, "SKIN"), 2 * 12U);
  EXPECT_EQ(word(bytes, skin + 12 + 4), 4U);
  EXPECT_EQ(word(bytes, skin + 12 + 8), 1U) << "the mesh";
  EXPECT_EQ(section_bytes(bytes, "JOIN"), 2 * 52U);
  EXPECT_EQ(section_bytes(bytes, "JRES"), 2 * 32U);
  EXPECT_EQ(section_bytes(bytes, "VJOI"), 4 * 8U) << "both skins have the same";
  EXPECT_EQ(section_bytes(bytes, "JTRK"), 3 * 8U);
  EXPECT_EQ(section_bytes(bytes, "JKEY"), 6 * 36U);
  EXPECT_EQ(section_bytes(bytes, "CNAM"), 11U);
  EXPECT_EQ(entry_of(bytes, "ANIM"), 0U);
  EXPECT_EQ(bytes[section(bytes, "VJOI") + 4], 155);
  EXPECT_EQ(word(bytes, section(bytes, "JOIN") + 48), 0xFFFFU);
}

TEST(SceneBlobClips, LentMemoryHoldsTheJointsAndOneMeshlet) {
  const Bytes bytes = skin_bytes();
  for (std::size_t lent = 0; lent < kSkinMemory; ++lent) {
    EXPECT_EQ(Opened(bytes, lent).status, (Status{.error = Error::blob_memory,
                                                  .needed = static_cast<std::uint32_t>(kSkinMemory),
                                                  .available = static_cast<std::uint32_t>(lent)}));
  }
  EXPECT_EQ(character_memory({.skins = 1, .joints = 1}) - sizeof(Skin) - sizeof(Skinning), 80U);
  EXPECT_EQ(character_memory({.positions = 1, .normals = 1}), 10U);
}

/// A reader without these sections must not draw what stands still.
TEST(SceneBlobClips, OlderReadersRefuseThem) {
  for (const char* tag : {"CLIP", "SKIN", "JOIN"}) EXPECT_TRUE(tag[0] >= 'A' && tag[0] <= 'Z');
  EXPECT_EQ(skin_bytes()[2], 5);
}

Status clips_with_word(const Bytes& whole, std::uint32_t at, std::uint32_t value) {
  Bytes changed = whole;
  put_word(changed, at, value);
  mend(changed);
  return Opened(changed, kSkinMemory + 1000).status;
}
Status clips_with_byte(const Bytes& whole, std::uint32_t at, std::uint8_t value) {
  Bytes changed = whole;
  changed[at] = value;
  mend(changed);
  return Opened(changed, kSkinMemory + 1000).status;
}
Status damaged_at(std::uint32_t at) { return {.error = Error::blob_damaged, .needed = at}; }

TEST(SceneBlobClips, WrongRecordsAreRefused) {
  const Bytes whole = skin_bytes();
  const std::uint32_t clip = section(whole, "CLIP"), skin = section(whole, "SKIN");
  EXPECT_EQ(clips_with_word(whole, clip + 24, 0), damaged_at(clip + 24)) << "no duration";
  EXPECT_EQ(clips_with_word(whole, clip + 28 + 8, 0), damaged_at(clip + 28 + 8)) << "another clip's tracks";
  EXPECT_EQ(clips_with_word(whole, clip + 28 + 16, 0), damaged_at(clip + 28 + 16));
  EXPECT_EQ(clips_with_word(whole, clip + 28 + 20, 3), damaged_at(clip + 28 + 16)) << "more tracks than there are";
  EXPECT_EQ(clips_with_word(whole, clip + 12, 0xFFFFFFFF), damaged_at(clip + 8));
  EXPECT_EQ(clips_with_word(whole, skin + 8, 1), damaged_at(skin + 12 + 8)) << "two skins of one mesh";
  EXPECT_EQ(clips_with_word(whole, skin + 12 + 8, 2), damaged_at(skin + 12 + 8)) << "a skin of no mesh";
  EXPECT_EQ(clips_with_word(whole, skin + 4, 3).error, Error::skin) << "a vertex without joints";
  EXPECT_EQ(clips_with_word(whole, clip + 4, 12), damaged_at(clip));
  EXPECT_EQ(clips_with_word(whole, clip + 4, 4), damaged_at(clip)) << "a name without an end";
  EXPECT_EQ(clips_with_word(whole, clip + 4, 0), damaged_at(clip));
}

TEST(SceneBlobClips, WrongJointsAreRefused) {
  const Bytes whole = skin_bytes();
  const std::uint32_t joints = section(whole, "JOIN"), rest = section(whole, "JRES"), vertices = section(whole, "VJOI");
  const auto wrong = [](std::uint32_t index) { return Status{.error = Error::skin, .needed = index}; };
  EXPECT_EQ(clips_with_byte(whole, joints + 52 + 48, 1), wrong(1)) << "its own parent";
  EXPECT_EQ(clips_with_byte(whole, joints + 48 + 1, 0), wrong(0)) << "a parent that is not there";
  EXPECT_EQ(clips_with_word(whole, joints + 52, 256 << 16), wrong(1)) << "too large a matrix";
  EXPECT_EQ(clips_with_word(whole, rest + 20, 256 << 16), wrong(0));
  EXPECT_EQ(clips_with_word(whole, rest + 4, 0), wrong(0)) << "no rotation";
  EXPECT_EQ(clips_with_byte(whole, vertices + 8, 2), wrong(1)) << "a joint that is not there";
  EXPECT_EQ(clips_with_byte(whole, vertices + 16 + 7, 24), wrong(2)) << "weights that do not add up";
  std::vector<Piece> pieces = pieces_of(whole);
  for (Piece& piece : pieces) {
    if (piece.tag == "JRES") piece.content.resize(32);
  }
  EXPECT_EQ(Opened(blob_of(pieces), kSkinMemory).status, wrong(0)) << "a rest pose for one of two joints";
  for (Piece& piece : pieces) {
    if (piece.tag == "JOIN") piece.content.resize(257 * 52);
  }
  const Bytes many = blob_of(pieces);
  EXPECT_EQ(Opened(many, 1 << 20).status, damaged_at(section(many, "JOIN"))) << "more than 256 joints";
  std::erase_if(pieces, [](const Piece& piece) { return piece.tag == "SKIN"; });
  for (Piece& piece : pieces) {
    if (piece.tag == "JOIN") piece.content.resize(52);
  }
  const Bytes orphans = blob_of(pieces);
  EXPECT_EQ(Opened(orphans, kSkinMemory).status, damaged_at(section(orphans, "JOIN"))) << "joints of no skin";
}

TEST(SceneBlobClips, WrongTracksAreRefused) {
  const Bytes whole = skin_bytes();
  const std::uint32_t tracks = section(whole, "JTRK"), keys = section(whole, "JKEY");
  const auto wrong = [](std::uint32_t index) { return Status{.error = Error::animation, .needed = index}; };
  EXPECT_EQ(clips_with_byte(whole, tracks, 2), wrong(0)) << "a joint that is not there";
  EXPECT_EQ(clips_with_byte(whole, tracks + 16 + 2, 3), wrong(1)) << "a keyframe that is not there";
  EXPECT_EQ(clips_with_byte(whole, tracks + 16 + 2, 0), wrong(1)) << "no keyframe";
  EXPECT_EQ(clips_with_word(whole, keys + 5 * 36, 0), wrong(1)) << "times that do not ascend";
  EXPECT_EQ(clips_with_word(whole, section(whole, "KEYF") + 36, 0), wrong(0));
  EXPECT_EQ(clips_with_byte(whole, section(whole, "TRAK"), 3), wrong(0)) << "an instance that is not there";
}

TEST(SceneBlobClips, AnAnimationBesideClipsIsDamage) {
  std::vector<Piece> pieces = pieces_of(skin_bytes());
  pieces.insert(pieces.begin(), {"ANIM", {1, 0, 0, 0}});
  const Bytes bytes = blob_of(pieces);
  EXPECT_EQ(Opened(bytes, kSkinMemory).status, damaged_at(section(bytes, "ANIM")));
}

/// What reads vertices as they were modelled cannot show those that joints move.
TEST(SceneBlobClips, LinesEdgesAndCsgOfASkinAreRefused) {
  SceneBlob blob = skin_sample();
  blob.scene.edges = kEdgeSets;
  EXPECT_EQ(Opened(*to_scene_blob(blob), 1 << 16).status, (Status{.error = Error::skin, .needed = 0}));
  blob = skin_sample();
  std::vector<Material> materials(std::begin(kMaterials), std::end(kMaterials));
  materials[1].finish = Material{}.finish;
  materials[1].depth_slope_bias = 0;
  blob.scene.materials = materials;
  blob.scene.lines = std::span(kLines).first(1);
  EXPECT_EQ(Opened(*to_scene_blob(blob), 1 << 16).status, (Status{.error = Error::skin, .needed = 1}));
}

/// Two meshes of one creature's joints: with normals and meshlets, and with neither.
struct Animal {
  zstrip::test::Random random{7};
  zstrip::test::Creature creature;
  std::vector<std::vector<Keyframe>> keyframes;
  std::vector<std::vector<Track>> tracks;
  std::vector<Clip> clips;
  Mesh meshes[2];
  Skin skins[2];
  SceneBlob blob;

  static constexpr Material kMaterials[] = {{.colour = {200, 180, 90, 255}, .double_sided = true},
                                            {.colour = {90, 40, 200, 255}, .lit = false, .double_sided = true}};
  static constexpr Instance kInstances[] = {{0, 0, Transform::identity()}, {1, 1, Transform::identity()}};
  static constexpr DirectionalLight kLight{};

  Animal() : creature(zstrip::test::creature(random, 1.0)) {
    connect(creature);
    meshes[0] = creature.mesh;
    meshes[1] = creature.mesh;
    meshes[1].normals = {};
    meshes[1].meshlets = {};
    meshes[1].centre = {};
    for (std::size_t i = 0; i < 2; ++i) {
      skins[i] = creature.skin;
      skins[i].mesh = &meshes[i];
    }
    for (const char* name : {"walk", "wave", "fall"}) add_clip(name);
    blob.scene.meshes = meshes;
    blob.scene.materials = kMaterials;
    blob.scene.instances = kInstances;
    blob.scene.lights = {&kLight, 1};
    blob.view = {64, 48, PixelFormat::rgb565};
    blob.skins = skins;
    blob.clips = clips;
    EXPECT_TRUE(look_at(blob.camera, {20000, 30000, 170000}, {0, 0, 0}, {0, kFixedOne, 0}));
  }

  void add_clip(const char* name) {
    std::vector<Keyframe>& keys = keyframes.emplace_back();
    std::vector<Track>& all = tracks.emplace_back();
    for (std::size_t joint = keyframes.size() % 2; joint < creature.joints.size(); joint += 2) {
      JointPose pose = creature.rest[joint];
      all.push_back({static_cast<std::uint16_t>(joint), 2, static_cast<std::uint32_t>(keys.size())});
      for (const std::uint32_t time : {0U, 400U}) {
        pose.translation.y += 2000;
        random.turn(pose, 0.6);
        const auto& q = pose.rotation;
        keys.push_back({time, {q[0], q[1], q[2], q[3]}, pose.translation, pose.scale});
      }
    }
    const auto duration = static_cast<std::uint32_t>(500 + 130 * keyframes.size());
    clips.push_back({.name = name, .instances = {{}, {}, duration}, .joints = {all, keys, duration}});
  }

  /// The creature as the code of a header moves it: skin_mesh with `pose`.
  picture::Picture drawn_with(const std::vector<JointPose>& pose) const {
    std::vector<Transform> work(pose.size());
    std::vector<Position> positions[2];
    std::vector<Normal> normals[2];
    std::vector<Meshlet> meshlets[2];
    Mesh moved[2];
    for (std::size_t i = 0; i < 2; ++i) {
      positions[i].resize(meshes[i].positions.size());
      normals[i].resize(meshes[i].normals.size());
      meshlets[i].resize(meshes[i].meshlets.size());
      const MovedVertices vertices{positions[i], normals[i], meshlets[i]};
      EXPECT_TRUE(skin_mesh(skins[i], pose, work, vertices));
      moved[i] = moved_mesh(meshes[i], vertices);
    }
    Scene scene = blob.scene;
    scene.meshes = moved;
    return draw(scene);
  }
  picture::Picture draw(const Scene& scene) const {
    const Effects effects = effects_of(scene, blob.camera);
    const PlanResult planned = plan(count(scene), blob.view, effects, {.strip_rows = 16});
    EXPECT_TRUE(planned.status);
    AnyRenderer renderer(effects);
    picture::Picture drawn = picture::draw(renderer, scene, blob.camera, blob.view, planned.plan);
    EXPECT_TRUE(drawn.status) << message(drawn.status.error);
    return drawn;
  }
  std::vector<JointPose> posed(std::size_t clip, std::uint32_t time) const {
    std::vector<JointPose> pose = creature.rest;
    zstrip::pose(clips[clip].joints, time, pose);
    return pose;
  }
};

std::size_t animal_memory(const Animal& animal) {
  return scene_blob_memory(2, 0) +
         character_memory({.skins = 2,
                           .joints = static_cast<std::uint32_t>(animal.creature.joints.size()),
                           .clips = 3,
                           .positions = zstrip::test::kVertices,
                           .normals = 30});
}

TEST(SceneBlobClips, PixelsAreThoseOfMeshesMovedBefore) {
  const Animal animal;
  const Opened opened(*to_scene_blob(animal.blob), animal_memory(animal));
  ASSERT_TRUE(opened.status) << message(opened.status.error);
  const SceneBlob& read = opened.content;
  std::vector<std::byte> last;
  for (std::uint16_t clip = 0; clip < 3; ++clip) {
    PlayedClips played;
    played.play(clip);
    for (const std::uint32_t time : {0U, 77U, 200U, 399U}) {
      played.seek(time, read.clips);
      ASSERT_TRUE(pose_clips(read.clips, played.all(), read.moved));
      const picture::Picture expected = animal.drawn_with(animal.posed(clip, time));
      EXPECT_EQ(animal.draw(read.scene).pixels, expected.pixels) << clip << " at " << time;
      EXPECT_NE(expected.pixels, last) << "it moves";
      last = expected.pixels;
    }
  }
}

/// A fade that begins during another one: three clips at once, each goes on.
TEST(SceneBlobClips, CrossFadesAreThoseOfBlend) {
  const Animal animal;
  const Opened opened(*to_scene_blob(animal.blob), animal_memory(animal));
  ASSERT_TRUE(opened.status);
  const SceneBlob& read = opened.content;
  PlayedClips played;
  played.advance(50, read.clips);
  played.play(1, 300);
  for (std::uint32_t passed = 0; passed <= 360; passed += 40) {
    if (passed == 120) played.play(2, 200);
    std::vector<JointPose> pose = animal.posed(0, 50 + passed);
    if (passed < 300) {
      blend(pose, animal.posed(1, passed), 65536 * passed / 300);
    } else {
      pose = animal.posed(1, passed);
    }
    if (passed >= 320) {
      pose = animal.posed(2, passed - 120);
    } else if (passed >= 120) {
      blend(pose, animal.posed(2, passed - 120), 65536 * (passed - 120) / 200);
    }
    ASSERT_TRUE(pose_clips(read.clips, played.all(), read.moved));
    EXPECT_EQ(animal.draw(read.scene).pixels, animal.drawn_with(pose).pixels) << passed;
    played.advance(40, read.clips);
  }
  EXPECT_EQ(played.all().size(), 1U) << "the others have faded out";
}

TEST(SceneBlobClips, WithoutClipsTheJointsRest) {
  Animal animal;
  animal.blob.clips = {};
  const Opened opened(*to_scene_blob(animal.blob), animal_memory(animal));
  ASSERT_TRUE(opened.status);
  ASSERT_TRUE(pose_clips({}, PlayedClips().all(), opened.content.moved));
  EXPECT_EQ(animal.draw(opened.content.scene).pixels, animal.drawn_with(animal.creature.rest).pixels);
}

TEST(PlayedClips, RepeatOrStopAtTheirEnds) {
  PlayedClips played;
  played.advance(2'345, kClips);
  EXPECT_EQ(played.last().time, 345U);
  played.advance(0xFFFFFFFF, kClips);
  EXPECT_EQ(played.last().time, (345ULL + 0xFFFFFFFF) % 1000);
  played.play(1, 0, false);
  ASSERT_EQ(played.all().size(), 1U);
  EXPECT_EQ(played.last().time, 0U);
  played.advance(699, kClips);
  EXPECT_EQ(played.last().time, 699U);
  played.advance(0xFFFFFFFF, kClips);
  EXPECT_EQ(played.last().time, 699U);
  played.seek(1'401, kClips);
  EXPECT_EQ(played.last().time, 1U);
}

TEST(PlayedClips, AtMostFourFadeIntoEachOther) {
  PlayedClips played;
  for (int i = 0; i < 6; ++i) {
    played.advance(10, kClips);
    played.play(static_cast<std::uint16_t>(i % 2), 1000);
  }
  ASSERT_EQ(played.all().size(), 4U);
  EXPECT_EQ(played.all()[0].time, 30U);
  EXPECT_EQ(played.all()[2].share(), 655U);
  played.advance(1000, kClips);
  EXPECT_EQ(played.all().size(), 1U);
}

/// A clip without a track for an instance has it at rest.
TEST(PlayedClips, InstancesFadeEntryByEntry) {
  const std::vector<Instance> rest(std::begin(kInstances), std::end(kInstances));
  std::vector<Instance> walking = rest, faded(rest.size());
  pose(kClips[0].instances, 500, walking);
  const PlayedClip played[] = {{.time = 500, .clip = 0}, {.time = 3, .clip = 1, .fade = 4, .faded = 1}};
  pose_clips(kClips, played, rest, faded);
  for (std::size_t i = 0; i < rest.size(); ++i) {
    for (std::size_t row = 0; row < 3; ++row) {
      for (std::size_t column = 0; column < 4; ++column) {
        const std::int64_t from = walking[i].transform.m[row][column], to = rest[i].transform.m[row][column];
        EXPECT_EQ(faded[i].transform.m[row][column], from + ((to - from) >> 2)) << i;
      }
    }
  }
}

}  // namespace
}  // namespace zstrip::sim::test
