// Primitives of a glTF file's meshes.
#include "import/gltf/primitives.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "import/gltf/document.hpp"
#include "import/read_model.hpp"
#include "import/screen_channel.hpp"
#include "text/number.hpp"

namespace zstrip::sim {
namespace {

/// The interpretation of indices.
enum class Mode : std::size_t { points, lines, line_loop, line_strip, triangles, triangle_strip, triangle_fan };

/// Returns three indices for each triangle, all with the winding of the first one.
std::vector<std::uint32_t> as_triangles(const std::vector<std::uint32_t>& from, Mode mode) {
  std::vector<std::uint32_t> triangles;
  if (mode == Mode::triangles) {
    triangles = from;
    triangles.resize(from.size() / 3 * 3);
    return triangles;
  }
  for (std::size_t i = 0; i + 2 < from.size(); ++i) {
    if (mode == Mode::triangle_fan) {
      triangles.insert(triangles.end(), {from[0], from[i + 1], from[i + 2]});
    } else if (i % 2 == 0) {
      triangles.insert(triangles.end(), {from[i], from[i + 1], from[i + 2]});
    } else {
      triangles.insert(triangles.end(), {from[i], from[i + 2], from[i + 1]});
    }
  }
  return triangles;
}

/// Returns the map of normals: the inverse transposed; `of_positions` itself if it has no inverse.
Affine map_of_normals(const Affine& of_positions) {
  if (determinant(of_positions) == 0) return of_positions;
  const Affine back = inverse(of_positions);
  Affine map;
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) map.m[row][column] = back.m[column][row];
  }
  return map;
}

/// Adding zero changes -0 to 0, so that equal vertices are equal bytes.
std::array<float, 3> as_floats(const Vector& v) {
  return {static_cast<float>(v[0]) + 0.0F, static_cast<float>(v[1]) + 0.0F, static_cast<float>(v[2]) + 0.0F};
}

/// Applies the map without its translation.
Vector direction_by(const Affine& map, const float* direction) {
  Affine linear = map;
  for (auto& row : linear.m) row[3] = 0;
  return linear * Vector{double{direction[0]}, double{direction[1]}, double{direction[2]}};
}

/// Applies the map to an offset, and divides by `size`; zero if the result is not finite.
std::array<float, 3> moved_by(const Affine& map, const std::array<float, 3>& offset, double size) {
  const Vector v = direction_by(map, offset.data());
  const std::array<float, 3> moved = as_floats({v[0] / size, v[1] / size, v[2] / size});
  return std::isfinite(moved[0] + moved[1] + moved[2]) ? moved : std::array<float, 3>{};
}

double length_of_normal(const Affine& map, const float* normal) {
  const Vector v = direction_by(map, normal);
  const double length = std::hypot(v[0], v[1], v[2]);
  return std::isfinite(length) ? length : 0;
}

/// Returns a normal of length 1; zero if there is no direction.
std::array<float, 3> turned_normal(const Affine& map, const float* normal) {
  const Vector v = direction_by(map, normal);
  const double length = std::hypot(v[0], v[1], v[2]);
  if (!std::isfinite(length) || !(length > 1e-20)) return {};
  return as_floats({v[0] / length, v[1] / length, v[2] / length});
}

/// Returns two indices for each line, twice the same for a point.
std::vector<std::uint32_t> as_segments(const std::vector<std::uint32_t>& from, Mode mode) {
  std::vector<std::uint32_t> segments;
  if (mode == Mode::lines) {
    segments = from;
    segments.resize(from.size() / 2 * 2);
    return segments;
  }
  for (std::size_t i = 0; i < from.size(); ++i) {
    if (mode == Mode::points) {
      segments.insert(segments.end(), {from[i], from[i]});
    } else if (i + 1 < from.size()) {
      segments.insert(segments.end(), {from[i], from[i + 1]});
    } else if (mode == Mode::line_loop && from.size() > 1) {
      segments.insert(segments.end(), {from[i], from[0]});
    }
  }
  return segments;
}

}  // namespace

GltfPrimitives::GltfPrimitives(const GltfJson& json, GltfBuffers& buffers, GltfAccessors& accessors,
                               const GltfNodes& nodes, const GltfMaterials& materials, const GltfMorphs& morphs,
                               Texcoords texcoords, SourceModel& model)
    : json_(json),
      buffers_(buffers),
      accessors_(accessors),
      nodes_(nodes),
      materials_(materials),
      morphs_(morphs),
      texcoords_(texcoords),
      model_(model),
      skins_(json, accessors, nodes, model),
      groups_(model) {}

Result<Done> GltfPrimitives::read_all() {
  for (const std::size_t node : nodes_.in_scene()) {
    const GltfJson& json = element(member(json_, "nodes"), node);
    const std::optional<std::size_t> index = index_in(json, "mesh");
    if (!index) continue;
    if (*index >= count_of(json_, "meshes")) return unreadable_model(fmt::format("there is no mesh {}", *index));
    if (!nodes_.is_visible(node)) {
      ++invisible_;
      continue;
    }
    const Result<std::vector<Affine>> copies = copies_on(json);
    if (!copies) return unreadable_model(copies.failure().message);
    for (const Affine& copy : *copies) {
      const Result<Done> added = add_mesh(element(member(json_, "meshes"), *index), node, copy);
      if (!added) return added.failure();
    }
  }
  if (groups_.is_empty() && invisible_ > 0) {
    return Failure{ExitStatus::input, "has only meshes that KHR_node_visibility hides; export it with visible ones"};
  }
  if (const Result<Done> finished = groups_.finish(); !finished) return finished.failure();
  if (bad_offsets_ > 0) {
    model_.warnings.push_back(
        fmt::format("{} of morph targets left out: not finite (NaN or infinite)", counted(bad_offsets_, "offset")));
  }
  skins_.warn();
  return Done{};
}

Result<Done> GltfPrimitives::add_mesh(const GltfJson& mesh, std::size_t node, const Affine& copy) {
  for (std::size_t k = 0; k < count_of(mesh, "primitives"); ++k) {
    Result<SourcePrimitive> read = read_primitive(element(member(mesh, "primitives"), k), node, copy);
    if (!read) return unreadable_model(read.failure().message);
    if (read->vertices.empty()) continue;
    if (const Result<Done> added = groups_.add(std::move(*read)); !added) return added.failure();
  }
  return Done{};
}

Result<std::vector<Affine>> GltfPrimitives::copies_on(const GltfJson& node) {
  const GltfJson& attributes = member(extension(node, "EXT_mesh_gpu_instancing"), "attributes");
  std::optional<std::size_t> count;
  const auto read = [&](const char* key, std::size_t components) -> Result<GltfValues<float>> {
    const std::optional<std::size_t> accessor = index_in(attributes, key);
    if (!accessor) return GltfValues<float>{};
    Result<GltfValues<float>> values = accessors_.floats(*accessor);
    if (!values) return values.failure();
    if (values->components != components || count.value_or(values->count()) != values->count()) {
      return gltf_damaged(fmt::format("{} of EXT_mesh_gpu_instancing does not fit", key));
    }
    count = values->count();
    if (*count > kMaxTriangles) {
      return gltf_damaged(fmt::format("EXT_mesh_gpu_instancing has more than {} copies", grouped(kMaxTriangles)));
    }
    return values;
  };
  const Result<GltfValues<float>> moves = read("TRANSLATION", 3);
  if (!moves) return moves.failure();
  const Result<GltfValues<float>> turns = read("ROTATION", 4);
  if (!turns) return turns.failure();
  const Result<GltfValues<float>> scales = read("SCALE", 3);
  if (!scales) return scales.failure();
  std::vector<Affine> copies;
  copies.reserve(count.value_or(1));
  for (std::size_t i = 0; i < count.value_or(1); ++i) {
    Placement placement;
    for (std::size_t c = 0; c < 3; ++c) {
      if (moves->count() > 0) placement.translation[c] = double{moves->at(i)[c]};
      if (scales->count() > 0) placement.scale[c] = double{scales->at(i)[c]};
    }
    Quaternion turn{};
    for (std::size_t c = 0; turns->count() > 0 && c < 4; ++c) turn[c] = double{turns->at(i)[c]};
    const double square = turn[0] * turn[0] + turn[1] * turn[1] + turn[2] * turn[2] + turn[3] * turn[3];
    if (std::isfinite(square) && square > 1e-12) placement.rotation = turn;
    copies.push_back(to_affine(placement));
  }
  return copies;
}

Result<GltfPrimitives::Vertices> GltfPrimitives::read_vertices(const GltfJson& primitive,
                                                               const GltfAttributes& attributes) {
  Vertices read;
  const auto set = [&](const std::string& name, std::size_t least, GltfValues<float>& values) -> Result<Done> {
    Result<GltfValues<float>> found = attributes.floats(name, read.positions.count(), least);
    if (!found) return found.failure();
    values = std::move(*found);
    return Done{};
  };
  if (const Result<Done> done = set("POSITION", 3, read.positions); !done) return done.failure();
  if (const Result<Done> done = set("NORMAL", 3, read.normals); !done) return done.failure();
  if (const Result<Done> done = set("COLOR_0", 3, read.colours); !done) return done.failure();
  const std::uint32_t material = materials_.material_of(primitive);
  const SourceMaterial& shown = model_.materials[material];
  const bool textured = shown.texture != kNoSourceTexture || shown.emissive_texture != kNoSourceTexture;
  if (!textured && texcoords_ != Texcoords::all) return read;
  const std::string name = fmt::format("TEXCOORD_{}", materials_.texcoords_of(material).set);
  if (const Result<Done> done = set(name, 2, read.texcoords); !done) return done.failure();
  return read;
}

Result<Done> GltfPrimitives::add_morphs(const GltfJson& primitive, std::size_t node, Vertices& vertices) {
  const GltfJson& targets = member(primitive, "targets");
  for (std::size_t k = 0; k < count_of(primitive, "targets"); ++k) {
    const double weight = morphs_.at_rest(node, k);
    const auto add = [&](const char* name, GltfValues<float>& to) -> Result<Done> {
      const std::optional<std::size_t> accessor = index_in(element(targets, k), name);
      if (!accessor || to.count() == 0) return Done{};
      const Result<GltfValues<float>> moved = fitting_floats(accessors_, *accessor, name, to.count(), 3);
      if (!moved) return moved.failure();
      for (std::size_t i = 0; i < to.count(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
          float& value = to.numbers[i * to.components + c];
          value = static_cast<float>(double{value} + weight * double{moved->at(i)[c]});
        }
      }
      return Done{};
    };
    if (const std::optional<GltfMorphs::Moved> moved = morphs_.moved(node, k)) {
      const Result<Done> done = add_moved_target(element(targets, k), *moved, vertices);
      if (!done) return done.failure();
    }
    if (weight == 0) continue;
    if (const Result<Done> done = add("POSITION", vertices.positions); !done) return done.failure();
    if (const Result<Done> done = add("NORMAL", vertices.normals); !done) return done.failure();
  }
  return Done{};
}

Result<Done> GltfPrimitives::add_moved_target(const GltfJson& target, const GltfMorphs::Moved& moved,
                                              Vertices& vertices) {
  const std::size_t count = vertices.positions.count();
  const auto read = [&](const char* name, const GltfValues<float>& base) -> Result<GltfValues<float>> {
    const std::optional<std::size_t> accessor = index_in(target, name);
    if (!accessor || base.count() == 0) return GltfValues<float>{};
    return fitting_floats(accessors_, *accessor, name, count, 3);
  };
  const Result<GltfValues<float>> positions = read("POSITION", vertices.positions);
  if (!positions) return positions.failure();
  const Result<GltfValues<float>> normals = read("NORMAL", vertices.normals);
  if (!normals) return normals.failure();
  vertices.morphs.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    SourceMorphOffset offset{.weight = moved.weight};
    const auto set = [&](const GltfValues<float>& from, std::array<float, 3>& to) {
      if (from.count() == 0) return;
      for (std::size_t c = 0; c < 3; ++c) to[c] = static_cast<float>(moved.scale * double{from.at(i)[c]}) + 0.0F;
      if (std::isfinite(to[0]) && std::isfinite(to[1]) && std::isfinite(to[2])) return;
      to = {};
      ++bad_offsets_;
    };
    set(*positions, offset.position);
    set(*normals, offset.normal);
    constexpr std::array<float, 3> kNone{};
    if (offset.position != kNone || offset.normal != kNone) vertices.morphs[i].push_back(offset);
  }
  return Done{};
}

std::uint32_t GltfPrimitives::morph_of(const std::vector<SourceMorphOffset>& offsets) {
  std::vector<float> key;
  for (const SourceMorphOffset& offset : offsets) {
    key.push_back(static_cast<float>(offset.weight));
    key.insert(key.end(), offset.position.begin(), offset.position.end());
    key.insert(key.end(), offset.normal.begin(), offset.normal.end());
  }
  const auto [at, is_new] =
      known_morphs_.try_emplace(std::move(key), static_cast<std::uint32_t>(model_.morphs.size() + 1));
  if (is_new) model_.morphs.push_back(offsets);
  return at->second;
}

/// An alpha that is common to all vertices becomes the material's.
void GltfPrimitives::set_alpha(const GltfValues<float>& colours, SourcePrimitive& to) {
  if (colours.components != 4 || model_.materials[to.material].alpha_mode == AlphaMode::opaque) return;
  const std::uint8_t alpha = to_screen_channel(double{colours.at(0)[3]}, false);
  for (std::size_t i = 1; i < colours.count(); ++i) {
    if (to_screen_channel(double{colours.at(i)[3]}, false) == alpha) continue;
    to.vertex_alpha = true;
    return;
  }
  if (alpha == 255) return;
  const auto [at, is_new] =
      with_alpha_.try_emplace({to.material, alpha}, static_cast<std::uint32_t>(model_.materials.size()));
  if (is_new) {
    SourceMaterial own = model_.materials[to.material];
    own.alpha = static_cast<std::uint8_t>((own.alpha * alpha + 127) / 255);
    model_.materials.push_back(std::move(own));
  }
  to.material = at->second;
}

/// Exporters often write BLEND for opaque materials. Blended triangles write no depth, so that inner faces would be
/// visible.
void GltfPrimitives::set_opaque(SourcePrimitive& to) {
  const SourceMaterial& shown = model_.materials[to.material];
  const bool textured = to.has_texcoords && shown.texture != kNoSourceTexture;
  const bool has_holes = textured && !model_.textures[shown.texture].alpha.empty();
  if (shown.alpha_mode != AlphaMode::blend || shown.alpha != 255 || has_holes) return;
  const auto [at, is_new] = opaque_.try_emplace(to.material, static_cast<std::uint32_t>(model_.materials.size()));
  if (is_new) {
    SourceMaterial own = shown;
    own.alpha_mode = AlphaMode::opaque;
    model_.materials.push_back(std::move(own));
  }
  to.material = at->second;
}

Result<SourcePrimitive> GltfPrimitives::read_primitive(const GltfJson& primitive, std::size_t node,
                                                       const Affine& copy) {
  const std::size_t number = index_in(primitive, "mode").value_or(4);
  if (number > 6) return gltf_damaged(fmt::format("a mesh has the mode {}", number));
  const auto mode = static_cast<Mode>(number);
  const Result<GltfAttributes> attributes = GltfAttributes::open(primitive, accessors_, buffers_);
  if (!attributes) return attributes.failure();
  Result<Vertices> from = read_vertices(primitive, *attributes);
  if (!from) return from.failure();
  if (const Result<Done> done = add_morphs(primitive, node, *from); !done) return done.failure();
  const std::size_t vertices = from->positions.count();
  const Result<std::vector<std::uint32_t>> indices = attributes->indices(vertices);
  if (!indices) return indices.failure();
  SourcePrimitive to;
  if (vertices == 0) return to;

  to.has_colours = from->colours.count() > 0;
  to.has_texcoords = from->texcoords.count() > 0;
  to.material = materials_.material_of(primitive);
  if (mode < Mode::triangles) {
    to.segments = as_segments(*indices, mode);
  } else {
    to.indices = as_triangles(*indices, mode);
  }
  const Result<SkinnedPrimitive> skin = skins_.read(*attributes, vertices, node);
  if (!skin) return skin.failure();
  to.has_skin = !skin->joints.empty();
  to.node = to.has_skin || !skin->at_rest.empty() ? kNoNode : nodes_.mover_of(node);
  // A skin's place is that of its joints: it has no copies.
  const bool has_skin = to.has_skin || !skin->at_rest.empty();
  const Affine modelled = has_skin ? skin->modelled : skin->modelled * copy;
  to.mirrored = determinant(modelled) < 0;
  const GltfTexcoords texcoords = materials_.texcoords_of(to.material);
  set_alpha(from->colours, to);
  set_opaque(to);
  const Affine normals_as_modelled = map_of_normals(modelled);
  to.vertices.resize(vertices);
  for (std::size_t i = 0; i < vertices; ++i) {
    SourceVertex& vertex = to.vertices[i];
    const bool at_rest = !skin->at_rest.empty();
    const Affine& place = at_rest ? skin->at_rest[i] : modelled;
    const float* const position = from->positions.at(i);
    to.positions.push_back(place * Vector{double{position[0]}, double{position[1]}, double{position[2]}});
    const Affine normal_place = at_rest && from->normals.count() > 0 ? map_of_normals(place) : normals_as_modelled;
    if (from->normals.count() > 0) vertex.normal = turned_normal(normal_place, from->normals.at(i));
    if (!from->morphs.empty() && !from->morphs[i].empty()) {
      const double size = from->normals.count() > 0 ? length_of_normal(normal_place, from->normals.at(i)) : 0;
      for (SourceMorphOffset& offset : from->morphs[i]) {
        offset.position = moved_by(place, offset.position, 1);
        offset.normal = size > 1e-20 ? moved_by(normal_place, offset.normal, size) : std::array<float, 3>{};
      }
      vertex.morph = morph_of(from->morphs[i]);
      to.has_morphs = true;
    }
    if (to.has_colours) {
      const float* const colour = from->colours.at(i);
      for (std::size_t c = 0; c < 3; ++c) vertex.colour[c] = to_screen_channel(double{colour[c]}, true);
    }
    if (to.has_texcoords) {
      const float* const texcoord = from->texcoords.at(i);
      const std::array<float, 2> on = texcoords.on_texture(double{texcoord[0]}, double{texcoord[1]});
      if (std::isfinite(on[0]) && std::isfinite(on[1])) {
        vertex.texcoord = on;
      } else {
        ++to.bad_texcoords;
      }
    }
    if (!to.has_skin) continue;
    vertex.joints = skin->joints[i].joints;
    vertex.weights = skin->joints[i].weights;
  }
  return to;
}

}  // namespace zstrip::sim
