// The character's tables, computed by the formulas of this folder; made for zstrip.
#include "zstrip_scenes/character.hpp"

#include "../bounding_sphere.hpp"
#include "shape.hpp"
#include "texture.hpp"
#include "walk.hpp"
#include "zstrip/scene/validate.hpp"

namespace zstrip::scenes {
namespace {

using character_shape::Vector, character_shape::Vertex;

constexpr character_shape::Cut kCut = character_shape::cut();

template <class T, class Make>
consteval std::array<T, kCharacterVertices> of_each_vertex(const Make& make) {
  std::array<T, kCharacterVertices> result{};
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = make(kCut.vertices[i]);
  return result;
}

consteval Position position(const Vertex& vertex) {
  const auto on_grid = [](double value) consteval {
    return compile_time::grid_step(compile_time::nearest(value * 32768 * kFixedOne / kCharacterHalfExtent));
  };
  return {on_grid(vertex.position.x), on_grid(vertex.position.y), on_grid(vertex.position.z)};
}
consteval Normal normal(const Vertex& vertex) {
  const auto rounded = [](double c) consteval { return static_cast<std::int8_t>(compile_time::nearest(127 * c)); };
  return {rounded(vertex.normal.x), rounded(vertex.normal.y), rounded(vertex.normal.z), 0};
}
consteval TexCoord texcoord(const Vertex& vertex) {
  constexpr double kTexel = 1 << (kCharacterTexcoordBits - kCharacterTextureLog2);
  return {static_cast<std::int16_t>(compile_time::nearest(vertex.u * kTexel)),
          static_cast<std::int16_t>(compile_time::nearest(vertex.v * kTexel))};
}

consteval std::array<Meshlet, kCharacterMeshletCount> meshlets(
    const std::array<Position, kCharacterVertices>& positions) {
  std::array<Meshlet, kCharacterMeshletCount> result = kCut.meshlets;
  for (Meshlet& meshlet : result) {
    const BoundingSphere bounds =
        bounding_sphere(std::span(positions).subspan(meshlet.first_vertex, meshlet.vertex_count),
                        {kCharacterHalfExtent, kCharacterHalfExtent, kCharacterHalfExtent});
    meshlet.radius = bounds.radius;
    meshlet.centre = bounds.centre;
  }
  return result;
}

consteval std::array<Joint, kCharacterJoints> joints() {
  std::array<Joint, kCharacterJoints> result{};
  for (std::size_t i = 0; i < result.size(); ++i) {
    const Vector& place = character_shape::kJointPlaces[i].place;
    result[i].parent = character_shape::kJointPlaces[i].parent;
    result[i].inverse_bind.m[0][3] = -fixed(place.x);
    result[i].inverse_bind.m[1][3] = -fixed(place.y - character_shape::kMiddle);
    result[i].inverse_bind.m[2][3] = -fixed(place.z);
  }
  return result;
}

consteval std::array<JointPose, kCharacterJoints> rest() {
  std::array<JointPose, kCharacterJoints> result{};
  for (std::size_t i = 0; i < result.size(); ++i) result[i].translation = character_shape::offset_of(i, 0);
  return result;
}

/// Returns zeros, so that the poses take no flash; they are written before they are read.
consteval std::array<JointPose, kCharacterJoints> no_poses() {
  std::array<JointPose, kCharacterJoints> result{};
  for (JointPose& pose : result) pose = {.rotation = {0, 0, 0, 0}, .translation = {0, 0, 0}, .scale = {0, 0, 0}};
  return result;
}

/// True if the front of every triangle is outside, on the side of its corners' normals.
consteval bool fronts_are_outside() {
  for (const Triangle& t : kCut.triangles) {
    const Vertex &a = kCut.vertices[t.a], &b = kCut.vertices[t.b], &c = kCut.vertices[t.c];
    const Vector front = cross(b.position - a.position, c.position - a.position);
    if (dot(front, a.normal + b.normal + c.normal) <= 0) return false;
  }
  return true;
}
static_assert(fronts_are_outside());

}  // namespace

constexpr std::array<Position, kCharacterVertices> kCharacterPositions = of_each_vertex<Position>(position);
constexpr std::array<Normal, kCharacterVertices> kCharacterNormals = of_each_vertex<Normal>(normal);
constexpr std::array<TexCoord, kCharacterVertices> kCharacterTexcoords = of_each_vertex<TexCoord>(texcoord);
constexpr std::array<VertexJoints, kCharacterVertices> kCharacterVertexJoints =
    of_each_vertex<VertexJoints>([](const Vertex& vertex) consteval { return vertex.joints; });
constexpr std::array<Triangle, kCharacterTriangleCount> kCharacterTriangles = kCut.triangles;
constexpr std::array<Meshlet, kCharacterMeshletCount> kCharacterMeshlets = meshlets(kCharacterPositions);
constexpr std::array<Joint, kCharacterJoints> kCharacterJointTable = joints();
constexpr std::array<JointPose, kCharacterJoints> kCharacterRest = rest();
constexpr std::array<Track, kCharacterJoints> kCharacterTracks = character_shape::tracks();
constexpr std::array<Keyframe, kCharacterJoints* kCharacterKeys> kCharacterKeyframes = character_shape::keyframes();
constexpr std::array<std::uint16_t, kCharacterTexelCount> kCharacterTexels = character_shape::texels();

static_assert(validate(kCharacterSkin));

constinit CharacterInRam character_in_ram{.joints = no_poses(), .matrices = {}, .positions = {}, .normals = {}};
constinit Skinning character_skinning{.skin = &kCharacterSkin,
                                      .matrices = character_in_ram.matrices,
                                      .positions = character_in_ram.positions,
                                      .normals = character_in_ram.normals};

Status pose_character(std::uint32_t frame) {
  character_in_ram.joints = kCharacterRest;
  pose(kCharacterWalk, frame * kCharacterFrameTime, character_in_ram.joints);
  return pose_skin(character_skinning, character_in_ram.joints);
}

}  // namespace zstrip::scenes
