// The bytes of a scene blob's records, so that padding of structures never gets into a file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "zstrip/scene/blob_sections.hpp"

namespace zstrip::sim {

/// Appends values, the lowest byte first, and records, value by value.
class BlobWriter {
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
  void put(std::uint8_t coverage) { byte(coverage); }
  void put(char letter) { byte(static_cast<std::uint8_t>(letter)); }
  void put(const Glyph& g) {
    word(g.code_point);
    word(g.offset);
    for (const std::uint8_t side : {g.width, g.height}) byte(side);
    for (const std::int16_t place : {g.left, g.top}) half_word(place);
    half_word(std::uint32_t{g.advance});
  }
  void put(const Sprite& s) {
    for (const std::int16_t place : {s.x, s.y}) half_word(place);
    half_word(std::uint32_t{s.image});
    put(s.colour);
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
  void put(const blob_layout::PictureRecord& picture) {
    for (const std::uint32_t side : {picture.width, picture.height}) half_word(side);
    for (const std::uint8_t value : {picture.format, picture.dither, picture.samples, picture.effects}) byte(value);
  }
  void put(const blob_layout::BaseRecord& base) {
    put(base.ambient);
    put(base.background);
  }
  void put(const VertexJoints& vertex) {
    for (const std::uint8_t joint : vertex.joints) byte(joint);
    for (const std::uint8_t weight : vertex.weights) byte(weight);
  }
  void put(const Joint& joint) {
    put(joint.inverse_bind);
    half_word(std::uint32_t{joint.parent});
    zeros(2);
  }
  void put(const JointPose& pose) {
    for (const std::int16_t component : pose.rotation) half_word(component);
    put(pose.translation);
    put(pose.scale);
  }
  void put(const blob_layout::SkinRecord& skin) {
    put(skin.vertices);
    half_word(std::uint32_t{skin.mesh});
    zeros(2);
  }
  void put(const MorphRun& run) {
    for (const std::uint16_t value : {run.first_vertex, run.count, run.first_offset}) half_word(std::uint32_t{value});
  }
  void put(const MorphOffset& offset) {
    for (const std::int16_t component : {offset.x, offset.y, offset.z}) half_word(component);
  }
  void put(const NormalOffset& offset) {
    for (const std::int8_t component : {offset.x, offset.y, offset.z}) byte(static_cast<std::uint8_t>(component));
  }
  void put(const WeightKey& key) {
    word(key.time);
    half_word(key.weight);
    zeros(2);
  }
  void put(const ClipEvent& event) {
    for (const std::uint16_t value : {event.clip, event.number}) half_word(std::uint32_t{value});
    word(event.time);
  }
  void put(const DetailLevel& level) {
    for (const std::uint16_t mesh : {level.mesh, level.coarser}) half_word(std::uint32_t{mesh});
    word(level.distance);
  }
  void put(const blob_layout::MorphRecord& morph) {
    put(morph.targets);
    half_word(std::uint32_t{morph.mesh});
    zeros(2);
  }
  void put(const blob_layout::MorphTargetRecord& target) {
    for (const blob_layout::Range& range : {target.runs, target.positions, target.normals}) put(range);
    half_word(std::uint32_t{target.weight});
    zeros(2);
  }
  void put(const blob_layout::ClipRecord& clip) {
    for (const blob_layout::Range& range : {clip.name, clip.tracks, clip.joint_tracks}) put(range);
    word(clip.duration);
  }
  void put(const blob_layout::AnimationRecord& animation) { word(animation.duration); }
  void put(const blob_layout::TurnRecord& turn) {
    half_word(std::uint32_t{turn.still_instances});
    byte(turn.what);
    zeros(1);
  }
  void put(const blob_layout::Range& range) {
    word(range.first);
    word(range.count);
  }
  void put(const blob_layout::MeshRecord& mesh) {
    for (const blob_layout::Range& range :
         {mesh.positions, mesh.normals, mesh.colours, mesh.texcoords, mesh.triangles, mesh.meshlets}) {
      put(range);
    }
    put(mesh.centre);
    put(mesh.half_extent);
    for (const std::uint8_t value : {mesh.texcoord_bits, mesh.billboard, mesh.outline, mesh.shadow}) byte(value);
  }
  void put(const blob_layout::TextureRecord& texture) {
    put(texture.texels);
    for (const std::uint8_t value : {texture.log2_width, texture.log2_height, texture.format, texture.smaller_levels}) {
      byte(value);
    }
  }
  void put(const blob_layout::LineRecord& lines) {
    put(lines.segments);
    for (const std::uint32_t index : {lines.mesh, lines.material}) half_word(index);
    put(lines.transform);
    byte(lines.width);
    zeros(3);
  }
  void put(const blob_layout::EdgeRecord& set) {
    put(set.edges);
    half_word(std::uint32_t{set.mesh});
    zeros(2);
  }

  void put(const blob_layout::ImageRecord& image) {
    put(image.colours);
    put(image.coverage);
    for (const std::uint32_t side : {image.width, image.height}) half_word(side);
    byte(image.coverage_bits);
    zeros(3);
  }
  void put(const blob_layout::FontRecord& font) {
    put(font.glyphs);
    put(font.coverage);
    word(font.replacement);
    for (const std::uint32_t height : {font.line_height, font.baseline}) half_word(height);
    byte(font.coverage_bits);
    zeros(3);
  }
  void put(const blob_layout::LabelRecord& label) {
    put(label.text);
    for (const std::int16_t place : {label.x, label.y}) half_word(place);
    half_word(std::uint32_t{label.font});
    byte(label.alignment);
    zeros(1);
    put(label.colour);
    put(label.background);
  }

  void align() { zeros((kSceneBlobAlignment - bytes_.size() % kSceneBlobAlignment) % kSceneBlobAlignment); }

  std::vector<std::uint8_t>& bytes() { return bytes_; }
  const std::vector<std::uint8_t>& bytes() const { return bytes_; }

 private:
  std::vector<std::uint8_t> bytes_;
};

}  // namespace zstrip::sim
