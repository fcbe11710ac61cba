// Collects the surfaces of a file, which a reader finds, in the meshes of a source model.
#include "import/mesh_groups.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "import/read_model.hpp"
#include "text/number.hpp"

namespace zstrip::sim {
namespace {

bool is_finite(const SourceVertex& vertex) {
  return std::ranges::all_of(vertex.position, [](float c) { return std::isfinite(c); });
}

bool has_area(const SourceVertex& a, const SourceVertex& b, const SourceVertex& c) {
  std::array<double, 3> ab{};
  std::array<double, 3> ac{};
  for (std::size_t i = 0; i < 3; ++i) {
    ab[i] = double{b.position[i]} - double{a.position[i]};
    ac[i] = double{c.position[i]} - double{a.position[i]};
  }
  return ab[1] * ac[2] != ab[2] * ac[1] || ab[2] * ac[0] != ab[0] * ac[2] || ab[0] * ac[1] != ab[1] * ac[0];
}

}  // namespace

/// Blended surfaces are sorted by instance, so that each stays a separate mesh.
SourceMesh& MeshGroups::mesh_for(const SourcePrimitive& primitive) {
  const bool blends = model_.materials[primitive.material].alpha_mode == AlphaMode::blend;
  const auto apart = static_cast<std::uint32_t>(blends ? model_.meshes.size() + 1 : 0);
  const auto [at, is_new] = groups_.try_emplace({primitive.material, primitive.has_colours, primitive.has_texcoords,
                                                 primitive.node, primitive.has_skin, primitive.has_morphs, apart},
                                                model_.meshes.size());
  if (is_new) {
    SourceMesh& mesh = model_.meshes.emplace_back();
    mesh.material = primitive.material;
    mesh.node = primitive.node;
    mesh.has_skin = primitive.has_skin;
    mesh.has_morphs = primitive.has_morphs;
    mesh.has_colours = primitive.has_colours;
    mesh.has_texcoords = primitive.has_texcoords;
  }
  return model_.meshes[at->second];
}

/// The middle of the first vertices, if they are so far away that floats would be too coarse.
void MeshGroups::choose_origin(const std::vector<Vector>& positions) {
  constexpr double kFar = 1024;  // times their extent; 13 of 23 bits are left
  if (has_origin_) return;
  Vector low{}, high{};
  for (const Vector& at : positions) {
    if (!std::isfinite(at[0] + at[1] + at[2])) continue;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low[axis] = has_origin_ ? std::min(low[axis], at[axis]) : at[axis];
      high[axis] = has_origin_ ? std::max(high[axis], at[axis]) : at[axis];
    }
    has_origin_ = true;
  }
  double extent = 0, distance = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    extent = std::max(extent, high[axis] - low[axis]);
    distance = std::max(distance, std::abs(high[axis] + low[axis]) / 2);
  }
  if (!(distance > kFar * extent)) return;
  for (std::size_t axis = 0; axis < 3; ++axis) model_.origin[axis] = (high[axis] + low[axis]) / 2;
}

Result<Done> MeshGroups::add(SourcePrimitive primitive) {
  choose_origin(primitive.positions);
  for (std::size_t i = 0; i < primitive.vertices.size(); ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      // Adding zero changes -0 to 0, so that equal vertices are equal bytes.
      primitive.vertices[i].position[axis] =
          static_cast<float>(primitive.positions[i][axis] - model_.origin[axis]) + 0.0F;
    }
  }
  triangles_seen_ += primitive.indices.size() / 3;
  segments_seen_ += primitive.segments.size() / 2;
  vertices_ += primitive.vertices.size();
  if (triangles_seen_ + segments_seen_ > kMaxTriangles || vertices_ > 3 * kMaxTriangles) {
    return Failure{ExitStatus::input,
                   fmt::format("has more than {} triangles, lines and points; simplify the model", kMaxTriangles)};
  }
  if (primitive.vertex_alpha) ++vertex_alpha_;
  if (primitive.left_at_rest) ++morphs_;
  bad_texcoords_ += primitive.bad_texcoords;
  if (!primitive.indices.empty()) {
    const SourceMaterial& material = model_.materials[primitive.material];
    const bool textured = material.texture != kNoSourceTexture || material.emissive_texture != kNoSourceTexture;
    if (textured && !primitive.has_texcoords) ++no_texcoords_;
    add_triangles(primitive);
  }
  if (!primitive.segments.empty()) add_segments(primitive);
  return Done{};
}

void MeshGroups::add_triangles(const SourcePrimitive& primitive) {
  SourceMesh& group = mesh_for(primitive);
  const auto first = static_cast<std::uint32_t>(group.vertices.size());
  group.vertices.insert(group.vertices.end(), primitive.vertices.begin(), primitive.vertices.end());
  for (std::size_t i = 0; i + 2 < primitive.indices.size(); i += 3) {
    const std::uint32_t a = primitive.indices[i];
    std::uint32_t b = primitive.indices[i + 1], c = primitive.indices[i + 2];
    if (std::max({a, b, c}) >= primitive.vertices.size()) {
      ++bad_index_;
      continue;
    }
    const SourceVertex &va = primitive.vertices[a], &vb = primitive.vertices[b], &vc = primitive.vertices[c];
    if (!is_finite(va) || !is_finite(vb) || !is_finite(vc)) {
      ++not_finite_;
      continue;
    }
    if (!has_area(va, vb, vc) && va.morph == 0 && vb.morph == 0 && vc.morph == 0) continue;
    if (primitive.mirrored) std::swap(b, c);
    ++kept_;
    group.indices.insert(group.indices.end(), {first + a, first + b, first + c});
  }
}

void MeshGroups::add_segments(const SourcePrimitive& primitive) {
  if (primitive.has_skin) {
    bent_segments_ += primitive.segments.size() / 2;
    return;
  }
  const auto [at, is_new] =
      line_groups_.try_emplace({primitive.material, primitive.has_colours, primitive.node}, model_.lines.size());
  if (is_new) {
    SourceLines& lines = model_.lines.emplace_back();
    lines.material = primitive.material;
    lines.node = primitive.node;
    lines.has_colours = primitive.has_colours;
  }
  SourceLines& group = model_.lines[at->second];
  const auto first = static_cast<std::uint32_t>(group.vertices.size());
  group.vertices.insert(group.vertices.end(), primitive.vertices.begin(), primitive.vertices.end());
  for (std::size_t i = 0; i + 1 < primitive.segments.size(); i += 2) {
    const std::uint32_t a = primitive.segments[i], b = primitive.segments[i + 1];
    const std::size_t count = primitive.vertices.size();
    if (a >= count || b >= count || !is_finite(primitive.vertices[a]) || !is_finite(primitive.vertices[b])) {
      ++bad_segments_;
      continue;
    }
    ++kept_;
    group.indices.insert(group.indices.end(), {first + a, first + b});
  }
}

Result<Done> MeshGroups::finish() {
  if (kept_ == 0 && triangles_seen_ + segments_seen_ > 0) {
    return Failure{ExitStatus::input,
                   "has no drawable triangle, line or point: corners are not finite, or triangles have no area; "
                   "repair the model"};
  }
  if (kept_ == 0) return Failure{ExitStatus::input, "has no triangles, lines or points; export it as a surface"};
  const auto warn_of = [this](std::uint64_t count, const char* what, const char* words) {
    if (count > 0) model_.warnings.push_back(fmt::format("{} {}", counted(count, what), words));
  };
  warn_of(not_finite_, "triangle", "left out: corners not finite (NaN or infinite)");
  warn_of(bad_index_, "triangle", "left out: with vertices that do not exist");
  warn_of(bad_segments_, "line", "left out: with vertices that do not exist, or are not finite");
  warn_of(bent_segments_, "line", "left out: skins bend triangles only");
  warn_of(bad_texcoords_, "texture coordinate", "not finite (NaN or infinite): drawn as 0");
  warn_of(no_texcoords_, "mesh", "drawn without a texture: no texture coordinates");
  warn_of(vertex_alpha_, "mesh", "drawn without the alpha of its vertex colours, which differs");
  warn_of(morphs_, "mesh", "with morph targets drawn at rest: only those of glTF 2.0 move");
  std::erase_if(model_.meshes, [](const SourceMesh& mesh) { return mesh.indices.empty(); });
  std::erase_if(model_.lines, [](const SourceLines& lines) { return lines.indices.empty(); });
  return Done{};
}

}  // namespace zstrip::sim
