// What blob_sample.hpp declares, written by the same code as files are.
#include "blob_sample.hpp"

#include <zlib.h>

#include <iterator>

namespace zstrip::sim::test {

void put_word(Bytes& bytes, std::size_t at, std::uint32_t value) {
  for (std::size_t i = 0; i < 4; ++i) bytes[at + i] = static_cast<std::uint8_t>(value >> 8 * i);
}
std::uint32_t word(const Bytes& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value |= std::uint32_t{bytes[at + i]} << 8 * i;
  return value;
}
void mend(Bytes& bytes) {
  put_word(bytes, 4, static_cast<std::uint32_t>(bytes.size()));
  put_word(bytes, 8, static_cast<std::uint32_t>(::crc32(0, bytes.data() + 12, static_cast<uInt>(bytes.size() - 12))));
}

std::uint32_t entry_of(const Bytes& bytes, std::string_view tag) {
  for (std::uint32_t i = 0, at = 16; i < word(bytes, 12); ++i, at += 12) {
    if (std::equal(tag.begin(), tag.end(), bytes.begin() + at)) return at;
  }
  return 0;
}
std::uint32_t section(const Bytes& bytes, std::string_view tag) {
  const std::uint32_t entry = entry_of(bytes, tag);
  return entry == 0 ? 0 : word(bytes, entry + 4);
}
std::uint32_t section_bytes(const Bytes& bytes, std::string_view tag) {
  const std::uint32_t entry = entry_of(bytes, tag);
  return entry == 0 ? 0 : word(bytes, entry + 8);
}

std::vector<Piece> pieces_of(const Bytes& bytes) {
  std::vector<Piece> pieces;
  for (std::uint32_t i = 0, at = 16; i < word(bytes, 12); ++i, at += 12) {
    const auto first = bytes.begin() + word(bytes, at + 4);
    pieces.push_back({{bytes.begin() + at, bytes.begin() + at + 4}, {first, first + word(bytes, at + 8)}});
  }
  return pieces;
}
Bytes blob_of(const std::vector<Piece>& pieces) {
  Bytes bytes{'z', 's', 5, 's'};
  bytes.resize(16 + 12 * pieces.size());
  put_word(bytes, 12, static_cast<std::uint32_t>(pieces.size()));
  std::size_t entry = 16;
  for (const Piece& piece : pieces) {
    std::copy(piece.tag.begin(), piece.tag.end(), bytes.begin() + static_cast<std::ptrdiff_t>(entry));
    put_word(bytes, entry + 4, static_cast<std::uint32_t>(bytes.size()));
    put_word(bytes, entry + 8, static_cast<std::uint32_t>(piece.content.size()));
    entry += 12;
    bytes.insert(bytes.end(), piece.content.begin(), piece.content.end());
    bytes.resize((bytes.size() + 3) / 4 * 4);
  }
  mend(bytes);
  return bytes;
}

SceneBlob sample() {
  SceneBlob blob{.scene = {.meshes = kMeshes,
                           .materials = kMaterials,
                           .textures = kTextures,
                           .instances = kInstances,
                           .lights = kLights,
                           .ambient = {11, 12, 13, 14},
                           .background = {15, 16, 17, 18},
                           .fog = &kFog,
                           .finishes = kFinishes,
                           .punctual_lights = kPunctualLights},
                 .camera = {},
                 .view = {320, 200, PixelFormat::gray4, true}};
  EXPECT_TRUE(look_at(blob.camera, {20000, 30000, 250000}, {0, 0, 0}, {0, kFixedOne, 0}));
  blob.camera.fixed_depth_range = true;
  return blob;
}

Bytes sample_bytes() {
  const Result<Bytes> bytes = to_scene_blob(sample());
  EXPECT_TRUE(bytes);
  return bytes ? *bytes : Bytes{};
}

Bytes palette_bytes() {
  std::vector<Material> materials(std::begin(kMaterials), std::end(kMaterials));
  materials[0].finish = 0;  // which the one with a texture needs
  SceneBlob blob = sample();
  blob.scene.materials = materials;
  blob.scene.textures = kWithPalettes;
  const Result<Bytes> bytes = to_scene_blob(blob);
  EXPECT_TRUE(bytes);
  return bytes ? *bytes : Bytes{};
}

Bytes tree_bytes() {
  constexpr Mesh kMesh[] = {{kPositions, {}, {}, {}, kFourTriangles, {}, {0, 0, 0}, {65536, 65536, 65536}, 12}};
  SceneBlob blob = sample();
  blob.scene.meshes = kMesh;
  blob.scene.instances = std::span(kInstances).first(1);
  blob.tree.nodes = kNodes;
  const Result<Bytes> bytes = to_scene_blob(blob);
  EXPECT_TRUE(bytes);
  return bytes ? *bytes : Bytes{};
}

namespace {

/// lines_bytes with what moves, and what the picture is baked for.
Bytes bytes_with_lines(const Turn& turn, const Camera* turning_camera, Effects effects) {
  std::vector<Material> materials(std::begin(kMaterials), std::end(kMaterials));
  materials[1].finish = Material{}.finish;
  materials[1].depth_slope_bias = 0;
  SceneBlob blob = sample();
  blob.scene.materials = materials;
  blob.scene.lines = kLines;
  blob.scene.outlines = kOutlines;
  blob.scene.shadow = &kShadow;
  blob.turn = turn;
  blob.turning_camera = turning_camera;
  blob.effects = effects;
  const Result<Bytes> bytes = to_scene_blob(blob);
  EXPECT_TRUE(bytes);
  return bytes ? *bytes : Bytes{};
}

}  // namespace

Bytes lines_bytes() { return bytes_with_lines({}, nullptr, {}); }
Bytes edges_bytes() {
  SceneBlob blob = sample();
  blob.scene.edges = kEdgeSets;
  const Result<Bytes> bytes = to_scene_blob(blob);
  EXPECT_TRUE(bytes);
  return bytes ? *bytes : Bytes{};
}
SceneBlob skin_sample() {
  SceneBlob blob = sample();
  blob.scene.meshes = kBindMeshes;
  blob.clips = kClips;
  blob.skins = kSkins;
  return blob;
}
Bytes skin_bytes() {
  const Result<Bytes> bytes = to_scene_blob(skin_sample());
  EXPECT_TRUE(bytes);
  return bytes ? *bytes : Bytes{};
}
SceneBlob morph_sample() {
  SceneBlob blob = skin_sample();
  blob.clips = kMorphClips;
  blob.morphs.meshes = kMovedMorphs;
  blob.events = kEvents;
  return blob;
}
Bytes morph_bytes() {
  const Result<Bytes> bytes = to_scene_blob(morph_sample());
  EXPECT_TRUE(bytes);
  return bytes ? *bytes : Bytes{};
}
Bytes turn_bytes() { return bytes_with_lines(kTurn, &kTurningCamera, effect::depth_24); }

}  // namespace zstrip::sim::test
