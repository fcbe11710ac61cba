// Writes a scene as a blob, value by value: no padding of a structure ever gets into a file.
#include "bake/scene_blob.hpp"

#include <zlib.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <span>
#include <utility>

namespace zstrip::sim {
namespace {

constexpr std::size_t kMeshBytes = 76;
constexpr std::size_t kTextureBytes = 12;
constexpr std::size_t kLineSetRecordBytes = 64;
constexpr std::size_t kEdgeSetRecordBytes = 12;
constexpr std::size_t kMaxLineSets = 255;

class Writer {
 public:
  void byte(std::uint32_t value) { bytes_.push_back(static_cast<std::uint8_t>(value)); }
  void half_word(std::uint32_t value) {
    byte(value & 0xFF);
    byte(value >> 8 & 0xFF);
  }
  void half_word(std::int16_t value) { half_word(std::uint32_t{static_cast<std::uint16_t>(value)}); }
  void word(std::uint32_t value) {
    half_word(value & 0xFFFF);
    half_word(value >> 16);
  }
  void word(std::int32_t value) { word(static_cast<std::uint32_t>(value)); }
  void zeros(std::size_t count) { bytes_.insert(bytes_.end(), count, 0); }

  void put(const Vec3& v) {
    word(v.x);
    word(v.y);
    word(v.z);
  }
  void put(const Colour& c) {
    for (const std::uint8_t channel : {c.r, c.g, c.b, c.a}) byte(channel);
  }
  void put(const Position& p) {
    for (const std::int16_t coordinate : {p.x, p.y, p.z}) half_word(coordinate);
  }
  void put(const Normal& n) {
    for (const std::int8_t component : {n.x, n.y, n.z, n.unused}) byte(static_cast<std::uint8_t>(component));
  }
  void put(const TexCoord& t) {
    half_word(t.u);
    half_word(t.v);
  }
  void put(const Triangle& t) {
    for (const std::uint32_t index : {t.a, t.b, t.c}) half_word(index);
  }
  void put(const Segment& s) {
    for (const std::uint32_t index : {s.a, s.b}) half_word(index);
  }
  void put(const Edge& e) {
    for (const std::uint32_t index : {e.a, e.b, e.left, e.right}) half_word(index);
  }
  void put(std::uint16_t texel) { half_word(std::uint32_t{texel}); }
  void put(const Meshlet& m) {
    word(m.first_triangle);
    for (const std::uint32_t value : {m.first_vertex, m.vertex_count, m.triangle_count, m.radius}) half_word(value);
    put(m.centre);
    zeros(2);
  }
  void put(const Material& m) {
    put(m.colour);
    half_word(std::uint32_t{m.texture});
    byte(m.lit ? 1 : 0);
    byte(m.smooth.kind);
    byte(m.double_sided ? 1 : 0);
    byte(static_cast<std::uint8_t>(m.depth_test));
    byte(m.depth_write ? 1 : 0);
    byte(m.finish);
    for (const std::int32_t bias : {m.depth_bias, m.depth_slope_bias, m.depth_bias_clamp}) word(bias);
  }
  void put(const Transform& transform) {
    for (const auto& row : transform.m) {
      for (const Fixed value : row) word(value);
    }
  }
  void put(const Instance& instance) {
    half_word(std::uint32_t{instance.mesh});
    half_word(std::uint32_t{instance.material});
    put(instance.transform);
  }
  void put(const DirectionalLight& light) {
    for (const std::int16_t component : {light.x, light.y, light.z}) half_word(component);
    put(light.colour);
  }
  void put(const Quadric& quadric) {
    half_word(std::uint32_t{quadric.material});
    zeros(2);
    put(quadric.transform);
  }
  void put(const Track& track) {
    for (const std::uint32_t value : {track.instance, track.count}) half_word(value);
    word(track.first);
  }
  void put(const Keyframe& keyframe) {
    word(keyframe.time);
    for (const std::int16_t component : keyframe.rotation) half_word(component);
    put(keyframe.translation);
    put(keyframe.scale);
  }
  void put(const Finish& finish) {
    put(finish.emissive);
    put(finish.specular);
    byte(finish.shininess);
    byte(static_cast<std::uint8_t>(finish.alpha_mode));
    byte(finish.alpha_cutoff);
    byte(static_cast<std::uint8_t>(finish.filter));
  }
  void put(const PunctualLight& light) {
    byte(static_cast<std::uint8_t>(light.type));
    put(light.colour);
    zeros(3);
    put(light.position);
    word(light.intensity);
    word(light.range);
    for (const std::int16_t value : {light.x, light.y, light.z, light.cosine_inner, light.cosine_outer})
      half_word(value);
    zeros(2);
  }
  void put(const Fog& fog) {
    put(fog.colour);
    byte(static_cast<std::uint8_t>(fog.mode));
    zeros(3);
    for (const Fixed value : {fog.start, fog.end, fog.density}) word(value);
  }
  void put(const BspNode& node) {
    for (const std::int32_t value : {node.x, node.y, node.z, node.distance}) word(value);
    for (const std::uint32_t value : {node.first_triangle, node.front, node.back, node.parent}) word(value);
  }
  void put(const Outline& outline) {
    put(outline.colour);
    half_word(std::uint32_t{outline.width});
    half_word(std::uint32_t{outline.hull});
  }
  void put(const CsgOperand& operand) {
    half_word(std::uint32_t{operand.instance});
    byte(operand.product);
    byte(static_cast<std::uint8_t>(operand.use));
  }
  void put(const Shadow& shadow) {
    byte(shadow.light);
    byte(shadow.log2_size);
    half_word(std::uint32_t{shadow.bias});
    word(shadow.slope_bias);
    word(shadow.pool);
  }
  void put(const Camera& camera) {
    for (const Vec3& vector : {camera.right, camera.up, camera.back, camera.eye}) put(vector);
    for (const Fixed value : {camera.focal, camera.near_plane, camera.far_plane}) word(value);
    byte(camera.projection == Projection::orthographic ? 1 : 0);
    byte(camera.fixed_depth_range ? 1 : 0);
    zeros(2);
  }
  void put(const View& view, std::uint32_t effects) {
    half_word(std::uint32_t{view.width});
    half_word(std::uint32_t{view.height});
    byte(static_cast<std::uint8_t>(view.format) | effects << 4);
    byte(view.dither ? 1 : 0);
    byte(view.samples == 1 ? std::uint8_t{0} : view.samples);
    zeros(1);
  }

  /// Writes the array here, and its offset and count at `entry`.
  template <class Record>
  void array(std::size_t entry, std::span<const Record> records) {
    if (records.empty()) return;
    const auto [known, is_new] = arrays_.try_emplace({records.data(), records.size()}, bytes_.size());
    word_at(entry, static_cast<std::uint32_t>(known->second));
    word_at(entry + 4, static_cast<std::uint32_t>(records.size()));
    if (!is_new) return;  // meshes of other sizes share their vertices
    for (const Record& record : records) put(record);
    align();
  }
  /// Room for `count` records of `size` bytes, named at `entry`; where they begin.
  std::size_t reserve(std::size_t entry, std::size_t count, std::size_t size) {
    const std::size_t at = bytes_.size();
    if (count > 0) {
      word_at(entry, static_cast<std::uint32_t>(at));
      word_at(entry + 4, static_cast<std::uint32_t>(count));
    }
    zeros(count * size);
    return at;
  }
  void word_at(std::size_t at, std::uint32_t value) {
    for (std::size_t i = 0; i < 4; ++i) bytes_[at + i] = static_cast<std::uint8_t>(value >> 8 * i);
  }
  void half_word_at(std::size_t at, std::uint16_t value) {
    for (std::size_t i = 0; i < 2; ++i) bytes_[at + i] = static_cast<std::uint8_t>(value >> 8 * i);
  }
  void byte_at(std::size_t at, std::uint8_t value) { bytes_[at] = value; }

  std::vector<std::uint8_t>& bytes() { return bytes_; }

 private:
  void align() { zeros((kSceneBlobAlignment - bytes_.size() % kSceneBlobAlignment) % kSceneBlobAlignment); }

  std::vector<std::uint8_t> bytes_;
  std::map<std::pair<const void*, std::size_t>, std::size_t> arrays_;  ///< where those begin that are written
};

void write_mesh(Writer& writer, std::size_t at, const Mesh& mesh) {
  writer.array(at, mesh.positions);
  writer.array(at + 8, mesh.normals);
  writer.array(at + 16, mesh.colours);
  writer.array(at + 24, mesh.texcoords);
  writer.array(at + 32, mesh.triangles);
  writer.array(at + 40, mesh.meshlets);
  std::size_t member = at + 48;
  for (const Vec3& vector : {mesh.centre, mesh.half_extent}) {
    for (const std::int32_t component : {vector.x, vector.y, vector.z}) {
      writer.word_at(member, static_cast<std::uint32_t>(component));
      member += 4;
    }
  }
  writer.byte_at(at + 72, mesh.texcoord_bits);
  writer.byte_at(at + 73, static_cast<std::uint8_t>(mesh.billboard));
  writer.byte_at(at + 74, mesh.outline);
  writer.byte_at(at + 75, static_cast<std::uint8_t>(mesh.shadow));
}

void write_texture(Writer& writer, std::size_t at, const Texture& texture) {
  writer.array(at, texture.texels);
  writer.byte_at(at + 8, texture.log2_width);
  writer.byte_at(at + 9, texture.log2_height);
  writer.byte_at(at + 10, static_cast<std::uint8_t>(texture.format));
  writer.byte_at(at + 11, texture.smaller_levels);
}

/// Of one of kPictureEffects.
std::uint32_t number_of(Effects effects) {
  return static_cast<std::uint32_t>(std::ranges::find(kPictureEffects, effects) - std::begin(kPictureEffects));
}

/// The animation's duration, or what turns without one; 0 is what blobs from before turns have.
std::uint32_t motion_word(const SceneBlob& content) {
  if (!content.animation.tracks.empty()) return content.animation.duration;
  if (content.turn == Turn{} && content.turning_camera == nullptr) return 0;
  const std::uint32_t has_turn = content.turning_camera != nullptr ? 0x81 : 0x80;
  return content.turn.still_instances | static_cast<std::uint32_t>(content.turn.what) << 16 | has_turn << 24;
}

void write_lines(Writer& writer, std::size_t at, const LineSet& lines) {
  writer.array(at, lines.segments);
  writer.half_word_at(at + 8, lines.mesh);
  writer.half_word_at(at + 10, lines.material);
  std::size_t member = at + 12;
  for (const auto& row : lines.transform.m) {
    for (const Fixed value : row) {
      writer.word_at(member, static_cast<std::uint32_t>(value));
      member += 4;
    }
  }
  writer.byte_at(at + 60, lines.width);
}

}  // namespace

Result<std::vector<std::uint8_t>> to_scene_blob(const SceneBlob& content) {
  const Scene& scene = content.scene;
  if (scene.lines.size() > kMaxLineSets) {
    return Failure{ExitStatus::input,
                   "has more than 255 sets of lines and points, which a scene blob cannot hold; bake a header (.hpp)"};
  }
  if (scene.edges.size() > kMaxBlobEdgeSets) {
    return Failure{ExitStatus::input,
                   "has edges of more than 190 meshes, which a scene blob cannot hold; bake a header (.hpp)"};
  }
  const int one_of_these =
      (scene.shadow != nullptr ? 1 : 0) + (scene.csg.empty() ? 0 : 1) + (scene.edges.empty() ? 0 : 1);
  if (one_of_these > 1) {
    return Failure{ExitStatus::input,
                   "has two of a shadow, products of solids and smooth edges: a scene blob holds one of them, as "
                   "nothing draws them together"};
  }
  Writer writer;
  for (const char letter : {'z', 's'}) writer.byte(static_cast<std::uint8_t>(letter));
  const bool has_palettes =
      std::ranges::any_of(scene.textures, [](const Texture& texture) { return has_palette(texture.format); });
  writer.byte(has_palettes ? kSceneBlobVersion : kOldestSceneBlobVersion);
  writer.byte('s');
  writer.zeros(48);  // size, checksum and arrays: set below
  writer.put(scene.ambient);
  writer.put(scene.background);
  writer.put(content.camera);
  writer.put(content.view, number_of(content.effects));
  writer.zeros(16);  // arrays of tracks and keyframes: set below
  writer.word(motion_word(content));
  writer.zeros(40);  // more arrays: set below

  // Right behind the header.
  for (const Outline& outline : scene.outlines) writer.put(outline);
  writer.byte_at(122, static_cast<std::uint8_t>(scene.outlines.size()));
  if (scene.shadow != nullptr) writer.put(*scene.shadow);
  for (const CsgOperand& operand : scene.csg) writer.put(operand);
  const std::size_t operands = scene.csg.empty() ? 0 : 1 + scene.csg.size();
  const std::size_t edges = writer.bytes().size();
  writer.zeros(scene.edges.size() * kEdgeSetRecordBytes);  // set below
  writer.byte_at(131, static_cast<std::uint8_t>(scene.shadow != nullptr ? 1
                                                : scene.edges.empty()   ? operands
                                                                        : 256 - scene.edges.size()));
  const std::size_t lines = writer.bytes().size();
  writer.zeros(scene.lines.size() * kLineSetRecordBytes);  // set below
  writer.byte_at(123, static_cast<std::uint8_t>(scene.lines.size()));
  if (content.turning_camera != nullptr && content.animation.tracks.empty()) writer.put(*content.turning_camera);

  const std::size_t meshes = writer.reserve(12, scene.meshes.size(), kMeshBytes);
  writer.array(20, scene.materials);
  const std::size_t textures = writer.reserve(28, scene.textures.size(), kTextureBytes);
  writer.array(36, scene.instances);
  writer.array(44, scene.lights);
  writer.array(132, content.animation.tracks);
  writer.array(140, content.animation.keyframes);
  writer.array(152, scene.finishes);
  writer.array(160, scene.punctual_lights);
  if (scene.fog != nullptr) writer.array(168, std::span(scene.fog, 1));
  writer.array(176, scene.quadrics);
  writer.array(184, content.tree.nodes);
  for (std::size_t i = 0; i < scene.meshes.size(); ++i) write_mesh(writer, meshes + i * kMeshBytes, scene.meshes[i]);
  for (std::size_t i = 0; i < scene.textures.size(); ++i) {
    write_texture(writer, textures + i * kTextureBytes, scene.textures[i]);
  }
  for (std::size_t i = 0; i < scene.lines.size(); ++i)
    write_lines(writer, lines + i * kLineSetRecordBytes, scene.lines[i]);
  for (std::size_t i = 0; i < scene.edges.size(); ++i) {
    writer.array(edges + i * kEdgeSetRecordBytes, scene.edges[i].edges);
    writer.half_word_at(edges + i * kEdgeSetRecordBytes + 8, scene.edges[i].mesh);
  }

  std::vector<std::uint8_t>& bytes = writer.bytes();
  if (bytes.size() > 0xFFFFFFFF) return Failure{ExitStatus::input, "takes more than 4 GB; simplify the model"};
  writer.word_at(4, static_cast<std::uint32_t>(bytes.size()));
  constexpr std::size_t kChecked = 12;
  writer.word_at(
      8, static_cast<std::uint32_t>(crc32_z(crc32_z(0, nullptr, 0), bytes.data() + kChecked, bytes.size() - kChecked)));
  return std::move(bytes);
}

}  // namespace zstrip::sim
