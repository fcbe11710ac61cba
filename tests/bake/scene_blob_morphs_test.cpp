// Morph targets of scene blobs: every byte is where docs/formats.md says, damage is refused, older versions are read,
// and the pixels are those of meshes that morph_mesh has moved, as the headers of `zstrip bake` do.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "../effects/creature.hpp"
#include "../oracle/draw.hpp"
#include "blob_sample.hpp"
#include "zstrip/zstrip.hpp"

namespace zstrip::sim::test {
namespace {

TEST(SceneBlobMorphs, AreReadAsTheyWereWritten) {
  const Opened opened(morph_bytes(), kMorphMemory);
  ASSERT_TRUE(opened.status) << message(opened.status.error) << opened.status.needed;
  const SceneBlob& read = opened.content;
  ASSERT_EQ(read.morphs.meshes.size(), 2U);
  EXPECT_EQ(read.morphs.weights.size(), 3U);
  EXPECT_EQ(read.memory_bytes, kMorphMemory);
  std::size_t target = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    const MovedMorph& morph = read.morphs.meshes[i];
    const Mesh& shown = read.scene.meshes[i];
    EXPECT_EQ(morph.mesh, i);
    EXPECT_EQ(shown.positions.data(), morph.vertices.positions.data());
    EXPECT_EQ(shown.meshlets.data(), morph.vertices.meshlets.data());
    EXPECT_EQ(read.skins[i].mesh, &shown) << "a skin moves the morphed vertices";
    EXPECT_NE(morph.morph.mesh->positions.data(), shown.positions.data());
    EXPECT_EQ(morph.morph.mesh->triangles.data(), shown.triangles.data());
    // Vertices are as they were modelled until pose_clips.
    expect_same_bytes(shown.positions, std::span<const Position>(kPositions));
    expect_same_bytes(shown.normals, kBindMeshes[i].normals);
    expect_same_bytes(shown.meshlets, kBindMeshes[i].meshlets);
    for (const MorphTarget& from : kMovedMorphs[i].morph.targets) {
      const MorphTarget& to = read.morphs.meshes[i].morph.targets[target++ - i * 2];
      EXPECT_EQ(to.weight, from.weight);
      expect_same_bytes(to.runs, from.runs);
      expect_same_bytes(to.positions, from.positions);
      expect_same_bytes(to.normals, from.normals);
    }
  }
  const Track& wave = read.clips[1].weights.tracks[1];
  EXPECT_EQ(wave.first, 3U) << "after the keys of the walk";
  EXPECT_EQ(read.clips[1].weights.keys[wave.first + 1U].weight, -2000);
  EXPECT_EQ(read.clips[1].weights.duration, 700U);
}

TEST(SceneBlobMorphs, WhatIsReadIsWrittenAgain) {
  const Bytes bytes = morph_bytes();
  const Opened opened(bytes, kMorphMemory);
  ASSERT_TRUE(opened.status);
  const SceneBlob& read = opened.content;
  PlayedClips played;
  played.seek(400, read.clips);
  (void)pose_clips(read.clips, played.all(), read.morphs);  // vertices leave the box
  EXPECT_NE(read.scene.meshes[0].positions[0].x, kPositions[0].x);
  EXPECT_EQ(*to_scene_blob(read), bytes) << "whatever its pose";
}

/// From docs/formats.md.
TEST(SceneBlobMorphs, EachMemberIsAtItsPlace) {
  const Bytes bytes = morph_bytes();
  const auto expect_words = [&bytes](const char* tag, std::uint32_t at, std::initializer_list<std::uint32_t> words) {
    at += section(bytes, tag);
    for (const std::uint32_t expected : words) {
      EXPECT_EQ(word(bytes, at), expected) << tag << at;
      at += 4;
    }
  };
  EXPECT_EQ(bytes[2], 6);
  EXPECT_EQ(section_bytes(bytes, "MORF"), 2 * 12U);
  expect_words("MORF", 0, {0, 2, 0, 2, 1, 1});
  EXPECT_EQ(section_bytes(bytes, "MTGT"), 3 * 28U);
  expect_words("MTGT", 0, {0, 2, 0, 3, 0, 3, 1, 2, 1, 3, 1, 0, 0, 0, 3, 1, 4, 4, 0, 0, 2});
  EXPECT_EQ(section_bytes(bytes, "MRUN"), 4 * 6U);
  expect_words("MRUN", 0, {0x10000, 0x20000, 0x10002});
  EXPECT_EQ(section_bytes(bytes, "MOFF"), 8 * 6U);
  expect_words("MOFF", 0, {0xFF380064, 0x1012C, 0x30002});
  EXPECT_EQ(section_bytes(bytes, "MOFN"), 9U);
  expect_words("MOFN", 0, {0x8003FE01, 0x0504007F});
  EXPECT_EQ(section_bytes(bytes, "CWGT"), 2 * 8U);
  expect_words("CWGT", 0, {0, 1, 1, 2});
  EXPECT_EQ(section_bytes(bytes, "WTRK"), 3 * 8U);
  expect_words("WTRK", 0, {0x20001, 0, 0x10000, 2, 0x20002, 3});
  EXPECT_EQ(section_bytes(bytes, "WKEY"), 5 * 8U);
  expect_words("WKEY", 8, {500, 4096, 7, 0xFF9C});
}

TEST(SceneBlobMorphs, LentMemoryHoldsTheMorphedMeshes) {
  const Bytes bytes = morph_bytes();
  for (std::size_t lent = 0; lent < kMorphMemory; ++lent) {
    EXPECT_EQ(Opened(bytes, lent).status, (Status{.error = Error::blob_memory,
                                                  .needed = static_cast<std::uint32_t>(kMorphMemory),
                                                  .available = static_cast<std::uint32_t>(lent)}));
  }
  EXPECT_EQ(character_memory({.weights = 1}), 2U);
  EXPECT_EQ(character_memory({.morphed_positions = 1, .morphed_normals = 1, .morphed_meshlets = 1}), 30U);
}

TEST(SceneBlobEvents, AreReadAsTheyWereWritten) {
  const Bytes whole = morph_bytes();
  const Opened opened(whole, kMorphMemory);
  ASSERT_TRUE(opened.status);
  expect_same_bytes(opened.content.events, std::span<const ClipEvent>(kEvents));
  const std::uint32_t events = section(whole, "evnt");
  ASSERT_EQ(section_bytes(whole, "evnt"), 3 * 8U);
  EXPECT_EQ(word(whole, events + 8), 0xFFFF0000U);
  EXPECT_EQ(word(whole, events + 12), 999U);
  EXPECT_EQ(word(whole, events + 16), 0x30001U);
}

TEST(SceneBlobEvents, ThatNeverComeAreDamage) {
  const Bytes whole = morph_bytes();
  const std::uint32_t events = section(whole, "evnt");
  const auto with_word = [&whole](std::uint32_t at, std::uint32_t value) {
    Bytes changed = whole;
    put_word(changed, at, value);
    mend(changed);
    return Opened(changed, kMorphMemory).status;
  };
  const auto damage = [](std::uint32_t at) { return Status{.error = Error::blob_damaged, .needed = at}; };
  EXPECT_EQ(with_word(events + 12, 1000), damage(events + 12)) << "behind the clip's end";
  EXPECT_EQ(with_word(events + 16, 2), damage(events + 20)) << "a clip that is not there";
  EXPECT_EQ(with_word(events + 12, 0), damage(events + 8)) << "two at a time";
  EXPECT_EQ(with_word(events, 1), damage(events + 8)) << "a clip before the last one";
  EXPECT_TRUE(with_word(events + 12, 1));
  // Of the only animation, as clip 0; without one nothing happens.
  const Piece event{"evnt", {0, 0, 1, 0, 0, 0, 0, 0}};
  std::vector<Piece> pieces = pieces_of(sample_bytes());
  pieces.push_back(event);
  const Bytes still = blob_of(pieces);
  EXPECT_EQ(Opened(still).status, damage(section(still, "evnt") + 4));
  pieces = pieces_of(skin_bytes());
  std::erase_if(pieces, [](const Piece& piece) { return piece.tag == "CLIP"; });
  pieces.insert(pieces.begin(), {"ANIM", {1, 0, 0, 0}});
  pieces.push_back(event);
  EXPECT_TRUE(Opened(blob_of(pieces), kSkinMemory).status);
}

/// What has no morph targets is read by programs that do not know them.
TEST(SceneBlobMorphs, OnlyTheyNeedTheLatestVersion) {
  EXPECT_EQ(skin_bytes()[2], 5);
  Bytes later = skin_bytes();
  later[2] = 6;
  EXPECT_TRUE(Opened(later, kSkinMemory).status);
  for (const char* tag : {"MORF", "MTGT"}) EXPECT_TRUE(tag[0] >= 'A' && tag[0] <= 'Z');
}

Status morphs_with_word(std::uint32_t at, std::uint32_t value) {
  Bytes changed = morph_bytes();
  put_word(changed, at, value);
  mend(changed);
  return Opened(changed, kMorphMemory + 200000).status;
}

TEST(SceneBlobMorphs, WrongRecordsAreRefused) {
  const Bytes whole = morph_bytes();
  const auto damage = [](std::uint32_t at) { return Status{.error = Error::blob_damaged, .needed = at}; };
  const auto skin = [](std::uint32_t index) { return Status{.error = Error::skin, .needed = index}; };
  const auto animation = [](std::uint32_t index) { return Status{.error = Error::animation, .needed = index}; };
  const std::uint32_t morph = section(whole, "MORF"), target = section(whole, "MTGT"), run = section(whole, "MRUN");
  const std::uint32_t clip = section(whole, "CWGT"), track = section(whole, "WTRK"), key = section(whole, "WKEY");
  EXPECT_EQ(morphs_with_word(morph + 8, 1), damage(morph + 12 + 8)) << "two sets of targets of one mesh";
  EXPECT_EQ(morphs_with_word(morph + 12 + 8, 2), damage(morph + 12 + 8)) << "targets of no mesh";
  EXPECT_EQ(morphs_with_word(morph + 12, 0), damage(morph + 12)) << "another mesh's targets";
  EXPECT_EQ(morphs_with_word(morph + 12 + 4, 2), damage(morph + 12)) << "more targets than there are";
  EXPECT_EQ(morphs_with_word(morph + 12 + 4, 0), skin(0)) << "no target";
  EXPECT_EQ(morphs_with_word(target + 28, 1), damage(target + 28)) << "another target's runs";
  EXPECT_EQ(morphs_with_word(target + 56 + 4, 2), damage(target + 56)) << "more runs than there are";
  EXPECT_EQ(morphs_with_word(target + 12, 2), skin(0)) << "fewer offsets than vertices";
  EXPECT_EQ(morphs_with_word(target + 20, 2), skin(0)) << "fewer normals than offsets";
  EXPECT_EQ(morphs_with_word(target + 56 + 20, 3), skin(0)) << "normals of a mesh without";
  EXPECT_EQ(morphs_with_word(run, 0), skin(0)) << "a run of no vertex";
  EXPECT_EQ(morphs_with_word(run + 16, 0x40000), skin(0)) << "a vertex that is not there";
  EXPECT_EQ(morphs_with_word(run + 16, 1), skin(1)) << "an offset that is not there";
  EXPECT_EQ(morphs_with_word(clip, 1), damage(clip)) << "another clip's tracks";
  EXPECT_EQ(morphs_with_word(clip + 12, 3), damage(clip + 8)) << "more tracks than there are";
  EXPECT_EQ(morphs_with_word(track, 0x20003), animation(0)) << "a weight that is not there";
  EXPECT_EQ(morphs_with_word(track + 16, 0x30002), animation(1)) << "a key that is not there";
  EXPECT_EQ(morphs_with_word(key + 8, 0), animation(0)) << "times that do not ascend";
  std::vector<Piece> pieces = pieces_of(whole);
  for (Piece& piece : pieces) {
    if (piece.tag == "CWGT") piece.content.resize(8);
  }
  const Bytes fewer = blob_of(pieces);
  EXPECT_EQ(Opened(fewer, kMorphMemory).status, damage(section(fewer, "CWGT"))) << "weights of one of two clips";
  std::erase_if(pieces, [](const Piece& piece) { return piece.tag == "CWGT"; });
  EXPECT_TRUE(Opened(blob_of(pieces), kMorphMemory).status) << "no clip moves weights";
  std::erase_if(pieces, [](const Piece& piece) { return piece.tag == "MTGT"; });
  const Bytes none = blob_of(pieces);
  EXPECT_EQ(Opened(none, kMorphMemory).status, damage(section(none, "MORF")));
}

/// Two meshes with morph targets: one that joints move further, and one without normals and meshlets.
struct Face {
  zstrip::test::Random random{21};
  zstrip::test::Creature creature = zstrip::test::creature(random, 1.0);
  std::vector<MorphOffset> offsets;
  std::vector<NormalOffset> normals;
  std::vector<MorphRun> runs;
  std::vector<MorphTarget> targets;
  std::vector<MovedMorph> morphs;
  std::vector<std::vector<WeightKey>> keys{2};
  std::vector<std::vector<Track>> tracks{2};
  std::vector<Keyframe> keyframes;
  std::vector<Track> joint_tracks;
  std::vector<Clip> clips;
  Mesh meshes[2];
  Skin skin;
  SceneBlob blob;

  static constexpr Material kMaterials[] = {{.colour = {200, 180, 90, 255}, .double_sided = true},
                                            {.colour = {90, 40, 200, 255}, .lit = false, .double_sided = true}};
  static constexpr Instance kInstances[] = {{0, 0, Transform::identity()}, {1, 1, Transform::identity()}};
  static constexpr DirectionalLight kLight{};
  static constexpr std::uint32_t kWeights = 4;

  Face() {
    connect(creature);
    meshes[0] = meshes[1] = creature.mesh;
    meshes[1].normals = {};
    meshes[1].meshlets = {};
    skin = creature.skin;
    skin.mesh = &meshes[0];
    const auto within = [this](int limit) { return static_cast<int>(random.within(-limit, limit)); };
    for (std::size_t i = 0; i < zstrip::test::kVertices; ++i) {
      const auto place = [&] { return static_cast<std::int16_t>(within(1500)); };
      const auto normal = [&] { return static_cast<std::int8_t>(within(40)); };
      offsets.push_back({place(), place(), place()});
      normals.push_back({normal(), normal(), normal()});
    }
    runs = {{3, 100, 0}, {150, 90, 100}, {0, 300, 0}, {20, 40, 5}, {200, 50, 60}};
    const auto all = std::span<const MorphRun>(runs);
    targets = {{.weight = 2, .runs = all.first(2), .positions = offsets, .normals = normals},
               {.weight = 0, .runs = all.subspan(2, 1), .positions = offsets},
               {.weight = 2, .runs = all.subspan(3, 1), .positions = offsets},
               {.weight = 3, .runs = all.subspan(4, 1), .positions = offsets}};
    const auto some = std::span<const MorphTarget>(targets);
    morphs = {{.morph = {&meshes[0], some.first(2)}, .vertices = {}, .mesh = 0},
              {.morph = {&meshes[1], some.subspan(2)}, .vertices = {}, .mesh = 1}};
    for (std::size_t clip = 0; clip < 2; ++clip) {
      constexpr std::uint16_t kMoved[] = {0, 2, 3};
      for (const std::uint16_t weight : kMoved) {
        if (clip == 1 && weight == 2) continue;
        tracks[clip].push_back({weight, 3, static_cast<std::uint32_t>(keys[clip].size())});
        for (const std::uint32_t time : {0U, 200U, 450U}) {
          keys[clip].push_back({time, static_cast<MorphWeight>(within(5000))});
        }
      }
    }
    for (std::uint16_t joint = 0; joint < creature.joints.size(); ++joint) {
      JointPose pose = creature.rest[joint];
      random.turn(pose, 0.6);
      const auto& q = pose.rotation;
      joint_tracks.push_back({joint, 1, joint});
      keyframes.push_back({0, {q[0], q[1], q[2], q[3]}, pose.translation, pose.scale});
    }
    clips = {
        {.name = "talk",
         .instances = {{}, {}, 500},
         .joints = {joint_tracks, keyframes, 500},
         .weights = {tracks[0], keys[0], 500}},
        {.name = "blink", .instances = {{}, {}, 700}, .joints = {{}, {}, 700}, .weights = {tracks[1], keys[1], 700}},
        {.name = "nod", .instances = {{}, {}, 900}, .joints = {joint_tracks, keyframes, 900}}};
    blob.scene.meshes = meshes;
    blob.scene.materials = kMaterials;
    blob.scene.instances = kInstances;
    blob.scene.lights = {&kLight, 1};
    blob.view = {64, 48, PixelFormat::rgb565};
    blob.skins = {&skin, 1};
    blob.clips = clips;
    blob.morphs.meshes = morphs;
    EXPECT_TRUE(look_at(blob.camera, {20000, 30000, 170000}, {0, 0, 0}, {0, kFixedOne, 0}));
  }

  std::vector<MorphWeight> weights_of(std::size_t clip, std::uint32_t time) const {
    std::vector<MorphWeight> weights(kWeights);
    pose(clips[clip].weights, time, weights);
    return weights;
  }
  std::vector<JointPose> joints_of(std::size_t clip, std::uint32_t time) const {
    std::vector<JointPose> joints = creature.rest;
    pose(clips[clip].joints, time, joints);
    return joints;
  }
  /// The meshes as the code of a header moves them: morph_mesh, then skin_mesh.
  picture::Picture drawn_with(const std::vector<MorphWeight>& weights, const std::vector<JointPose>& joints) const {
    std::vector<Position> positions[2];
    std::vector<Normal> moved_normals[2];
    std::vector<Meshlet> meshlets[2];
    Mesh moved[2];
    for (std::size_t i = 0; i < 2; ++i) {
      positions[i].resize(meshes[i].positions.size());
      moved_normals[i].resize(meshes[i].normals.size());
      meshlets[i].resize(meshes[i].meshlets.size());
      const MovedVertices vertices{positions[i], moved_normals[i], meshlets[i]};
      EXPECT_TRUE(morph_mesh(morphs[i].morph, weights, vertices));
      moved[i] = moved_mesh(meshes[i], vertices);
      if (i == 1) continue;
      Skin of_morphed = skin;
      of_morphed.mesh = &moved[0];
      std::vector<Transform> work(joints.size());
      EXPECT_TRUE(skin_mesh(of_morphed, joints, work, vertices));
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
};

std::size_t face_memory(const Face& face) {
  constexpr std::uint32_t kVertices = zstrip::test::kVertices;
  return scene_blob_memory(2, 0) + character_memory({.skins = 1,
                                                     .joints = static_cast<std::uint32_t>(face.creature.joints.size()),
                                                     .clips = 3,
                                                     .positions = 30,
                                                     .normals = 30,
                                                     .morphs = 2,
                                                     .targets = 4,
                                                     .weights = Face::kWeights,
                                                     .morphed_positions = 2 * kVertices,
                                                     .morphed_normals = kVertices,
                                                     .morphed_meshlets = 10});
}

TEST(SceneBlobMorphs, PixelsAreThoseOfMeshesMovedBefore) {
  const Face face;
  const Opened opened(*to_scene_blob(face.blob), face_memory(face));
  ASSERT_TRUE(opened.status) << message(opened.status.error);
  const SceneBlob& read = opened.content;
  const std::vector<MorphWeight> none(Face::kWeights);
  EXPECT_EQ(face.draw(read.scene).pixels, face.draw(face.blob.scene).pixels) << "as they were modelled";
  std::vector<std::byte> last;
  for (std::uint16_t clip = 0; clip < 3; ++clip) {
    PlayedClips played;
    played.play(clip);
    for (const std::uint32_t time : {0U, 77U, 200U, 399U}) {
      played.seek(time, read.clips);
      ASSERT_TRUE(pose_clips(read.clips, played.all(), read.morphs));
      ASSERT_TRUE(pose_clips(read.clips, played.all(), read.moved));
      const std::vector<MorphWeight> weights = clip == 2 ? none : face.weights_of(clip, time);
      const picture::Picture expected = face.drawn_with(weights, face.joints_of(clip, time));
      EXPECT_EQ(face.draw(read.scene).pixels, expected.pixels) << clip << " at " << time;
      if (clip != 2) {
        EXPECT_NE(expected.pixels, last) << "it moves";
      }
      last = expected.pixels;
    }
  }
}

/// Each weight goes linearly from one clip's to the other's; a clip without a track for it has 0.
TEST(SceneBlobMorphs, CrossFadesMixWeights) {
  const Face face;
  const Opened opened(*to_scene_blob(face.blob), face_memory(face));
  ASSERT_TRUE(opened.status);
  const SceneBlob& read = opened.content;
  PlayedClips played;
  played.advance(50, read.clips);
  played.play(1, 256);
  for (std::uint32_t passed = 0; passed < 256; passed += 32) {
    ASSERT_TRUE(pose_clips(read.clips, played.all(), read.morphs));
    const std::vector<MorphWeight> from = face.weights_of(0, 50 + passed), to = face.weights_of(1, passed);
    std::vector<MorphWeight> mixed(Face::kWeights);
    for (std::size_t i = 0; i < mixed.size(); ++i) {
      // Rounded down, as everything between two keys.
      mixed[i] = static_cast<MorphWeight>(from[i] + ((to[i] - from[i]) * static_cast<int>(passed) >> 8));
    }
    EXPECT_TRUE(std::ranges::equal(read.morphs.weights, mixed)) << passed;
    EXPECT_EQ(mixed[1], 0) << "no target has it";
    ASSERT_TRUE(pose_clips(read.clips, played.all(), read.moved));
    EXPECT_EQ(face.draw(read.scene).pixels,
              face.drawn_with(mixed, {read.moved.pose.begin(), read.moved.pose.end()}).pixels)
        << passed;
    played.advance(32, read.clips);
  }
}

TEST(SceneBlobMorphs, WithoutClipsTheWeightsAreZero) {
  Face face;
  face.blob.clips = {};
  const Opened opened(*to_scene_blob(face.blob), face_memory(face));
  ASSERT_TRUE(opened.status);
  std::ranges::fill(opened.content.morphs.weights, MorphWeight{5});
  ASSERT_TRUE(pose_clips({}, PlayedClips().all(), opened.content.morphs));
  EXPECT_EQ(face.draw(opened.content.scene).pixels, face.draw(face.blob.scene).pixels);
}

}  // namespace
}  // namespace zstrip::sim::test
