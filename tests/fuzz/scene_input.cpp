// A scene read from the fuzzer's bytes; see scene_input.hpp.
#include "scene_input.hpp"

#include <algorithm>
#include <span>

#include "zstrip/base/math.hpp"
#include "zstrip/scene/validate.hpp"

namespace fuzz {
namespace {

using namespace zstrip;

constexpr std::uint32_t kMaxVertices = 24;
constexpr std::uint32_t kMaxInputTriangles = 24;
constexpr std::uint32_t kMaxPixels = 128 * 128;  // a hostile view may have any shape, not any area

Fixed within(Fixed value, Fixed limit) { return std::clamp(value, -limit, limit); }

/// Zero bytes are white, so that a simple scene can be seen.
Colour read_colour(Input& input) {
  const auto channel = [&input] { return static_cast<std::uint8_t>(~input.any<std::uint8_t>()); };
  const std::uint8_t r = channel();
  const std::uint8_t g = channel();
  const std::uint8_t b = channel();
  return {r, g, b, 255};
}

Vec3 read_vector(Input& input, Fixed usual) {
  const Fixed x = input.number(usual);
  const Fixed y = input.number(usual);
  const Fixed z = input.number(usual);
  return {x, y, z};
}

/// Rotation about one axis with a uniform scale.
Transform rotation(Input& input) {
  const std::uint32_t axis = input.below(3);
  const Angle angle = input.any<std::uint16_t>();
  const Fixed scale = within(input.number(kFixedOne), detail::kMaxScale);
  const auto scaled = [scale](std::int32_t unit) { return static_cast<Fixed>((std::int64_t{unit} * scale) >> 30); };
  Transform t{};
  const std::uint32_t u = (axis + 1) % 3;
  const std::uint32_t v = (axis + 2) % 3;
  t.m[axis][axis] = scale;
  t.m[u][u] = t.m[v][v] = scaled(cosine(angle));
  t.m[u][v] = scaled(-sine(angle));
  t.m[v][u] = scaled(sine(angle));
  return t;
}

}  // namespace

SceneInput::SceneInput(Input& input) : hostile_(read_hostile(input)) {
  read_view(input);
  read_camera(input);
  textures_.resize(input.below(3));
  texels_.resize(textures_.size());
  for (std::size_t i = 0; i < textures_.size(); ++i) read_texture(input, i);
  materials_.resize(hostile_.materials ? input.below(4) : 1 + input.below(3));
  for (Material& material : materials_) read_material(input, material);
  meshes_.resize(hostile_.meshes ? input.below(4) : 1 + input.below(3));
  arrays_.resize(meshes_.size());
  for (std::size_t i = 0; i < meshes_.size(); ++i) read_mesh(input, arrays_[i], meshes_[i]);
  instances_.resize(hostile_.instances ? input.below(5) : 1 + input.below(4));
  for (Instance& instance : instances_) read_instance(input, instance);
  lights_.resize(input.below(hostile_.lights ? 7 : kMaxLights + 1));
  for (DirectionalLight& light : lights_) {
    light.x = input.any<std::int16_t>();
    light.y = input.any<std::int16_t>();
    light.z = input.any<std::int16_t>();
    light.colour = read_colour(input);
  }
  scene_ = {.meshes = meshes_,
            .materials = materials_,
            .textures = textures_,
            .instances = instances_,
            .lights = lights_,
            .ambient = read_colour(input),
            .background = {input.any<std::uint8_t>(), input.any<std::uint8_t>(), input.any<std::uint8_t>(), 255}};
  // Last, so that older inputs keep their meaning.
  for (Mesh& mesh : meshes_) {
    mesh.billboard = static_cast<Billboard>(hostile_.meshes ? input.any<std::uint8_t>() : input.below(3));
  }
  outlines_.resize(input.below(hostile_.meshes ? 4 : 3));
  for (Outline& outline : outlines_) {
    outline.colour = read_colour(input);
    const auto choice = input.any<std::uint16_t>();
    outline.width = static_cast<std::uint16_t>(hostile_.meshes ? choice : 1 + choice % kMaxOutlineWidth);
    outline.hull = input.any<std::uint16_t>();
    if (!hostile_.meshes) outline.hull = outline.hull % 2 == 0 ? kOwnMesh : outline.hull % meshes_.size();
  }
  for (Mesh& mesh : meshes_) {
    const auto outlines = static_cast<std::uint32_t>(outlines_.size());
    mesh.outline = static_cast<std::uint8_t>(hostile_.meshes ? input.any<std::uint8_t>() : input.below(outlines + 1));
  }
  scene_.outlines = outlines_;
  if (!input.flag()) {
    read_products(input);
    return;
  }
  const std::uint32_t lights = static_cast<std::uint32_t>(lights_.size());
  shadow_.light =
      static_cast<std::uint8_t>(hostile_.lights || lights == 0 ? input.any<std::uint8_t>() : input.below(lights));
  shadow_.log2_size = static_cast<std::uint8_t>(hostile_.lights ? input.below(8) : 4 + input.below(3));
  shadow_.bias = input.any<std::uint16_t>();
  shadow_.slope_bias = input.number(kFixedOne);
  if (!hostile_.lights) shadow_.slope_bias = std::max(shadow_.slope_bias, 0);
  shadow_.pool = input.flag() ? input.any<std::uint16_t>() : 0;
  for (Mesh& mesh : meshes_) {
    mesh.shadow = static_cast<ShadowRole>(hostile_.meshes ? input.any<std::uint8_t>() : input.below(4));
  }
  scene_.shadow = &shadow_;
}

/// No scene has shadows, too.
void SceneInput::read_products(Input& input) {
  operands_.resize(input.below(6));
  std::uint32_t product = 0;
  const auto instances = static_cast<std::uint32_t>(instances_.size());
  for (CsgOperand& operand : operands_) {
    const bool is_next = input.flag();
    if (is_next) ++product;
    operand.product = static_cast<std::uint8_t>(product);
    const bool is_hostile = hostile_.instances || instances == 0;
    operand.instance = static_cast<std::uint16_t>(is_hostile ? input.any<std::uint16_t>() : input.below(instances));
    operand.use = static_cast<CsgUse>(is_hostile ? input.any<std::uint8_t>() : input.below(2));
  }
  scene_.csg = operands_;
}

SceneInput::Hostile SceneInput::read_hostile(Input& input) {
  const auto bits = input.any<std::uint8_t>();
  const auto bit = [bits](int i) { return ((bits >> i) & 1) != 0; };
  return {bit(0), bit(1), bit(2), bit(3), bit(4), bit(5), bit(6)};
}

void SceneInput::read_view(Input& input) {
  view_.format = static_cast<PixelFormat>(input.below(7));
  if (hostile_.view) {
    view_.width = input.any<std::uint16_t>();
    view_.height = input.any<std::uint16_t>();
    if (std::uint32_t{view_.width} * view_.height > kMaxPixels && view_.width <= kMaxViewSize) view_.height = 4;
    budget_ = {.bytes = input.any<std::uint32_t>(), .strip_rows = input.any<std::uint16_t>()};
    budget_.strip_columns = static_cast<std::uint16_t>(budget_.bytes >> 7);
    budget_.split_columns = budget_.bytes % 2 != 0;
    budget_.modes = static_cast<Modes>(budget_.bytes / 2 % 3);
    return;
  }
  view_.width = static_cast<std::uint16_t>(1 + input.below(64));
  view_.height = static_cast<std::uint16_t>(1 + input.below(64));
  budget_.bytes = input.any<std::uint16_t>();
  budget_.strip_rows = static_cast<std::uint16_t>(input.below(view_.height + 1U));
  // From bits that are there already, so that older inputs keep their meaning.
  budget_.strip_columns = static_cast<std::uint16_t>(std::min<std::uint32_t>(budget_.bytes / 8 % 9 * 8, view_.width));
  budget_.split_columns = budget_.bytes % 2 != 0;
  budget_.modes = static_cast<Modes>(budget_.bytes / 2 % 3);
}

void SceneInput::read_camera(Input& input) {
  const std::uint32_t placement = input.below(3);
  // What the three ways refuse leaves the default camera, which is fine too.
  if (placement == 0) {
    const Fixed radius = 3 * kFixedOne - input.any<std::int16_t>() * 4;
    const Angle phi = input.any<std::uint16_t>();
    const Angle theta = input.any<std::uint16_t>() + kFullTurn / 4;
    static_cast<void>(orbit(camera_, {0, 0, 0}, radius, phi, theta));
  } else if (placement == 1) {
    const Vec3 eye = read_vector(input, kFixedOne);
    const Vec3 target = read_vector(input, 0);
    static_cast<void>(look_at(camera_, eye, target, read_vector(input, 0)));
  } else {
    constexpr std::int32_t kUnit = 1 << 30;
    for (Vec3* axis : {&camera_.right, &camera_.up, &camera_.back}) {
      *axis = read_vector(input, kUnit);
      if (!hostile_.camera) *axis = {within(axis->x, kUnit), within(axis->y, kUnit), within(axis->z, kUnit)};
    }
    camera_.eye = read_vector(input, 0);
  }
  camera_.focal = input.number(camera_.focal);
  camera_.near_plane = input.number(camera_.near_plane);
  camera_.far_plane = input.number(camera_.far_plane);
  camera_.projection = input.flag() ? Projection::orthographic : Projection::perspective;
  if (hostile_.camera) return;
  camera_.focal = std::max(camera_.focal, 1);
  camera_.near_plane = std::clamp(camera_.near_plane, 1, 0x7FFFFFFE);
  camera_.far_plane = std::max(camera_.far_plane, camera_.near_plane + 1);
}

void SceneInput::read_texture(Input& input, std::size_t index) {
  Texture& texture = textures_[index];
  std::vector<std::uint16_t>& texels = texels_[index];
  texture.log2_width = static_cast<std::uint8_t>(input.below(hostile_.textures ? 256 : 5));
  texture.log2_height = static_cast<std::uint8_t>(input.below(hostile_.textures ? 256 : 5));
  const bool other_size = hostile_.textures && input.flag();
  // A hostile texture of the right size is drawn; one of another size must be refused.
  const std::size_t log2 = std::min(std::size_t{12}, std::size_t{texture.log2_width} + texture.log2_height);
  texels.assign(other_size ? input.below(300) : std::size_t{1} << log2, std::uint16_t{0});
  for (std::size_t i = 0; i < std::min<std::size_t>(texels.size(), 16); ++i) texels[i] = input.any<std::uint16_t>();
  for (std::size_t i = 16; i < texels.size(); ++i) texels[i] = static_cast<std::uint16_t>(texels[i % 16] + i);
  texture.texels = texels;
}

void SceneInput::read_material(Input& input, Material& material) const {
  material.colour = read_colour(input);
  const auto choice = input.any<std::uint16_t>();
  const auto textures = static_cast<std::uint32_t>(textures_.size());
  if (hostile_.materials) {
    material.texture = choice;
  } else {
    material.texture = choice % (textures + 1) == 0 ? kNoTexture : static_cast<std::uint16_t>(choice % textures);
  }
  const auto flags = input.any<std::uint8_t>();
  material.lit = (flags & 1) != 0;
  material.smooth = (flags & 2) != 0;
  material.double_sided = (flags & 4) == 0;
  if ((flags & 24) == 24)
    material.smooth = static_cast<Shading::Kind>(Shading::pixel + (hostile_.materials ? flags >> 7 : 0));
}

void SceneInput::read_mesh(Input& input, MeshArrays& arrays, Mesh& mesh) const {
  arrays.positions.resize(hostile_.meshes ? input.below(kMaxVertices) : 3 + input.below(kMaxVertices - 3));
  for (Position& p : arrays.positions) {
    p = {input.any<std::int16_t>(), input.any<std::int16_t>(), input.any<std::int16_t>()};
  }
  const auto arrays_present = input.any<std::uint8_t>();
  const auto size_of = [&](int bit) -> std::size_t {
    if (((arrays_present >> bit) & 1) == 0) return 0;
    return hostile_.meshes && input.flag() ? input.below(kMaxVertices) : arrays.positions.size();
  };
  arrays.normals.resize(size_of(0));
  for (Normal& n : arrays.normals) {
    n = {input.any<std::int8_t>(), input.any<std::int8_t>(), input.any<std::int8_t>(), 0};
  }
  arrays.colours.resize(size_of(1));
  for (Colour& colour : arrays.colours) colour = read_colour(input);
  arrays.texcoords.resize(size_of(2));
  for (TexCoord& t : arrays.texcoords) t = {input.any<std::int16_t>(), input.any<std::int16_t>()};
  mesh.texcoord_bits = static_cast<std::uint8_t>(hostile_.meshes ? input.any<std::uint8_t>() : 4 + input.below(12));
  read_triangles(input, arrays);
  read_meshlets(input, arrays);
  mesh.positions = arrays.positions;
  mesh.normals = arrays.normals;
  mesh.colours = arrays.colours;
  mesh.texcoords = arrays.texcoords;
  mesh.triangles = arrays.triangles;
  mesh.meshlets = arrays.meshlets;
  mesh.centre = read_vector(input, 0);
  mesh.half_extent = read_vector(input, kFixedOne);
  if (hostile_.meshes) return;
  constexpr Fixed kMax = detail::kMaxMeshLength;
  for (Fixed* length : {&mesh.centre.x, &mesh.centre.y, &mesh.centre.z}) *length = within(*length, kMax);
  for (Fixed* length : {&mesh.half_extent.x, &mesh.half_extent.y, &mesh.half_extent.z}) {
    *length = std::clamp(*length, 0, kMax);
  }
}

void SceneInput::read_triangles(Input& input, MeshArrays& arrays) const {
  arrays.triangles.resize(input.below(kMaxInputTriangles));
  const auto vertices = static_cast<std::uint32_t>(arrays.positions.size());
  const auto index = [&] {
    return static_cast<std::uint16_t>(hostile_.meshes && input.flag() ? input.any<std::uint16_t>()
                                                                      : input.below(vertices));
  };
  for (Triangle& triangle : arrays.triangles) triangle = {index(), index(), index()};
}

void SceneInput::read_meshlets(Input& input, MeshArrays& arrays) const {
  const std::uint32_t count = input.below(4);
  if (count == 0 || (arrays.triangles.empty() && !hostile_.meshes)) return;
  arrays.meshlets.resize(count);
  std::uint32_t first = 0;
  for (Meshlet& meshlet : arrays.meshlets) {
    const auto left = static_cast<std::uint32_t>(arrays.triangles.size()) - first;
    const bool last = &meshlet == &arrays.meshlets.back();
    const std::uint32_t triangles = last ? left : input.below(left + 1);
    // The tightest run of vertices that the triangles allow.
    std::uint16_t low = triangles == 0 ? std::uint16_t{0} : std::uint16_t{0xFFFF};
    std::uint16_t high = 0;
    for (const Triangle& t : std::span(arrays.triangles).subspan(first, triangles)) {
      low = std::min({low, t.a, t.b, t.c});
      high = std::max({high, t.a, t.b, t.c});
    }
    meshlet = {first,
               low,
               static_cast<std::uint16_t>(high - low + 1),
               static_cast<std::uint16_t>(triangles),
               input.any<std::uint16_t>(),
               {input.any<std::int16_t>(), input.any<std::int16_t>(), input.any<std::int16_t>()}};
    first += triangles;
    if (!hostile_.meshes) continue;
    meshlet.first_triangle += static_cast<std::uint32_t>(input.number(0));
    meshlet.first_vertex = static_cast<std::uint16_t>(meshlet.first_vertex + input.any<std::int8_t>());
    meshlet.vertex_count = static_cast<std::uint16_t>(meshlet.vertex_count + input.any<std::int8_t>());
    meshlet.triangle_count = static_cast<std::uint16_t>(meshlet.triangle_count + input.any<std::int8_t>());
  }
}

void SceneInput::read_instance(Input& input, Instance& instance) const {
  if (hostile_.instances && input.flag()) {
    instance.mesh = input.any<std::uint16_t>();
    instance.material = input.any<std::uint16_t>();
  } else {
    instance.mesh = static_cast<std::uint16_t>(input.below(static_cast<std::uint32_t>(meshes_.size())));
    instance.material = static_cast<std::uint16_t>(input.below(static_cast<std::uint32_t>(materials_.size())));
  }
  if (input.flag()) {
    for (auto& row : instance.transform.m) {
      for (int column = 0; column < 3; ++column) {
        const Fixed value = input.number(kFixedOne);
        row[column] = hostile_.instances ? value : within(value, detail::kMaxScale);
      }
    }
  } else {
    instance.transform = rotation(input);
  }
  for (auto& row : instance.transform.m) row[3] = input.number(0);
}

}  // namespace fuzz
