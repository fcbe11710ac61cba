// Reads a model file of any format that Assimp knows.
#include "import/assimp/read_assimp.hpp"

#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cmath>
#include <cstdint>
#include <exception>
#include <iostream>
#include <limits>
#include <memory>
#include <new>
#include <span>
#include <streambuf>
#include <string>
#include <utility>
#include <vector>

#include "import/assimp/bones.hpp"
#include "import/assimp/lights.hpp"
#include "import/assimp/materials.hpp"
#include "import/assimp/obj_text.hpp"
#include "import/assimp/unread.hpp"
#include "import/assimp/up_axis.hpp"
#include "import/ending.hpp"
#include "import/mesh_groups.hpp"
#include "import/model_files.hpp"
#include "import/screen_channel.hpp"
#include "import/triangulate.hpp"
#include "import/turn_up.hpp"
#include "import/unreadable.hpp"
#include "text/number.hpp"
#include "text/text.hpp"

namespace zstrip::sim {
namespace {

/// Adding zero changes -0 to 0, so that equal vertices are equal bytes.
std::array<float, 3> components(const aiVector3D& v) { return {v.x + 0.0F, v.y + 0.0F, v.z + 0.0F}; }

Affine affine_of(const aiMatrix4x4& m) {
  const auto d = [](float value) { return double{value}; };
  return {{{{d(m.a1), d(m.a2), d(m.a3), d(m.a4)},
            {d(m.b1), d(m.b2), d(m.b3), d(m.b4)},
            {d(m.c1), d(m.c2), d(m.c3), d(m.c4)}}}};
}

/// Returns a vector of unit length, or zero if there is no direction.
aiVector3D direction(const aiVector3D& v) {
  const float length = v.Length();
  return std::isfinite(length) && length > 1e-20F ? v / length : aiVector3D();
}

aiMatrix4x4 to_matrix(const Affine& from) {
  const auto at = [&](std::size_t row, std::size_t column) { return static_cast<float>(from.m[row][column]); };
  return {at(0, 0), at(0, 1), at(0, 2), at(0, 3), at(1, 0), at(1, 1), at(1, 2), at(1, 3),
          at(2, 0), at(2, 1), at(2, 2), at(2, 3), 0,        0,        0,        1};
}

aiMatrix3x3 map_of_normals(const aiMatrix4x4& of_positions) {
  aiMatrix3x3 linear(of_positions);
  if (linear.Determinant() != 0) linear.Inverse().Transpose();
  return linear;
}

/// During its lifetime, text written to std::cout and std::cerr is discarded: some of Assimp's readers write there, and
/// failures of the command are one line.
class SilentStreams {
 public:
  SilentStreams() : out_(std::cout.rdbuf(nullptr)), err_(std::cerr.rdbuf(nullptr)) {}
  ~SilentStreams() {
    std::cout.rdbuf(out_);
    std::cerr.rdbuf(err_);
  }
  SilentStreams(const SilentStreams&) = delete;
  SilentStreams& operator=(const SilentStreams&) = delete;

 private:
  std::streambuf *out_, *err_;
};

/// True if the vertex has a colour, in a file where other vertices have one. In AMF Assimp makes vertices without a
/// colour transparent black.
bool has_colour(const aiColor4D& colour, bool of_amf) {
  if (of_amf) return colour != aiColor4D(0, 0, 0, 0);
  return colour.r != kNoColour || colour.g != kNoColour || colour.b != kNoColour;
}

unsigned most_corners(const aiScene& scene) {
  unsigned most = 0;
  for (const aiMesh* mesh : std::span(scene.mMeshes, scene.mNumMeshes)) {
    for (const aiFace& face : std::span(mesh->mFaces, mesh->mNumFaces)) most = std::max(most, face.mNumIndices);
  }
  return most;
}

/// Throws the exception again if memory was missing, because then the file is not at fault.
void rethrow_lack_of_memory(const std::exception_ptr& caught) {
  if (!caught) return;
  try {
    std::rethrow_exception(caught);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (...) {
    return;  // Assimp has words for it
  }
}

/// Returns Assimp's reason without what it quotes from the file, in one line.
std::string without_contents(std::string_view reason) {
  constexpr std::size_t kMaxReason = 160;
  std::string plain;
  char quote = '\0';
  for (const char c : reason.substr(0, kMaxReason)) {
    if (quote != '\0' ? c != quote : c != '"' && c != '`') {
      if (quote == '\0') plain += c;
      continue;
    }
    plain += quote == '\0' ? "'..." : "'";
    quote = quote == '\0' ? c : '\0';
  }
  if (quote != '\0') plain += '\'';
  return "as Assimp says: " + printable(plain);
}

/// Walks the nodes and collects their transformed meshes.
class Collector {
 public:
  Collector(const aiScene& scene, const Affine& turn, bool of_amf, const FilesRead& files,
            const MaterialReader& materials, Texcoords texcoords, SourceModel& model)
      : scene_(scene),
        turn_(turn),
        of_amf_(of_amf),
        files_(files),
        materials_(materials),
        texcoords_(texcoords),
        model_(model),
        groups_(model) {}

  Result<Done> collect();

 private:
  Result<Done> add(const aiMesh& mesh, const Affine& transform);
  SourceVertex vertex(const aiMesh& mesh, unsigned index, const aiMatrix3x3& normal_transform,
                      const SourcePrimitive& to, const TexturePlace& texture) const;

  const aiScene& scene_;
  Affine turn_;
  bool of_amf_;
  const FilesRead& files_;
  const MaterialReader& materials_;
  Texcoords texcoords_;
  SourceModel& model_;
  MeshGroups groups_;
  static constexpr float kFarthest = std::numeric_limits<float>::max();
  aiVector3D low_{kFarthest, kFarthest, kFarthest}, high_ = -low_;  ///< of all corners, as Assimp has them
  double rounding_ = 0;  ///< the most by which it rounded one of their numbers
};

/// A model is coarse if its size is fewer steps of rounding.
constexpr double kCoarsest = 500;

Result<Done> Collector::collect() {
  std::vector<std::pair<const aiNode*, Affine>> open;
  if (scene_.mRootNode != nullptr) {
    open.emplace_back(scene_.mRootNode, turn_ * affine_of(scene_.mRootNode->mTransformation));
  }
  while (!open.empty()) {
    const auto [node, transform] = open.back();
    open.pop_back();
    for (const unsigned index : std::span(node->mMeshes, node->mNumMeshes)) {
      if (index >= scene_.mNumMeshes) continue;
      if (const Result<Done> added = add(*scene_.mMeshes[index], transform); !added) return added.failure();
    }
    // In reverse, so that children are removed from the stack in the file's order.
    for (unsigned child = node->mNumChildren; child-- > 0;) {
      open.emplace_back(node->mChildren[child], transform * affine_of(node->mChildren[child]->mTransformation));
    }
  }
  Result<Done> finished = groups_.finish();
  const double size = std::max({high_.x - low_.x, high_.y - low_.y, high_.z - low_.z, 0.0F});
  if (kCoarsest * rounding_ <= size) return finished;
  if (!finished) {
    return Failure{finished.failure().status,
                   finished.failure().message +
                       "; if it lies so far from the origin that its corners are rounded to one place, move it to the "
                       "origin, or export it as .glb, .obj or .ply"};
  }
  model_.warnings.push_back(fmt::format(
      "corners rounded by up to {:.2g} units: the model lies far from the origin; move it there, or export it as "
      ".glb, .obj or .ply",
      rounding_));
  return finished;
}

SourceVertex Collector::vertex(const aiMesh& mesh, unsigned index, const aiMatrix3x3& normal_transform,
                               const SourcePrimitive& to, const TexturePlace& texture) const {
  SourceVertex vertex;
  if (mesh.HasNormals()) vertex.normal = components(direction(normal_transform * mesh.mNormals[index]));
  if (to.has_colours) {
    const aiColor4D& colour = mesh.mColors[0][index];
    const auto& [r, g, b] = model_.materials[to.material].colour;
    vertex.colour = {r, g, b, 255};
    if (has_colour(colour, of_amf_)) {
      vertex.colour = {to_screen_channel(colour.r, false), to_screen_channel(colour.g, false),
                       to_screen_channel(colour.b, false), 255};
    }
  }
  if (to.has_texcoords) {
    const aiVector3D& texcoord = mesh.mTextureCoords[materials_.texcoord_set(mesh.mMaterialIndex)][index];
    // Assimp's v grows upwards.
    if (std::isfinite(texcoord.x) && std::isfinite(texcoord.y)) {
      const auto placed = [&texture](std::size_t axis, float at) {
        return static_cast<float>(double{at} * texture.scale[axis] + texture.move[axis]);
      };
      vertex.texcoord = {placed(0, texcoord.x) + 0.0F, 1.0F - placed(1, texcoord.y)};
    }
  }
  return vertex;
}

Result<Done> Collector::add(const aiMesh& mesh, const Affine& transform) {
  if (!mesh.HasPositions()) return Done{};
  SourcePrimitive to;
  to.material = mesh.mMaterialIndex;
  if (to.material >= model_.materials.size()) return Done{};
  const unsigned set = materials_.texcoord_set(to.material);
  const bool wants_texcoords =
      texcoords_ == Texcoords::all || model_.materials[to.material].texture != kNoSourceTexture;
  to.has_colours = mesh.HasVertexColors(0) &&
                   std::ranges::any_of(std::span(mesh.mColors[0], mesh.mNumVertices),
                                       [this](const aiColor4D& colour) { return has_colour(colour, of_amf_); });
  to.has_texcoords = wants_texcoords && set < AI_MAX_NUMBER_OF_TEXTURECOORDS && mesh.HasTextureCoords(set);
  to.left_at_rest = mesh.mNumAnimMeshes > 0 && scene_.mNumAnimations > 0;
  to.mirrored = determinant(transform) < 0;
  const std::vector<aiMatrix4x4> at_rest = bones_at_rest(scene_, to_matrix(turn_), mesh, to_matrix(transform));
  const aiMatrix3x3 normal_transform = map_of_normals(to_matrix(transform));
  const auto placed = files_.materials.places.find(model_.materials[to.material].name);
  const TexturePlace texture = placed == files_.materials.places.end() ? TexturePlace{} : placed->second;
  to.vertices.reserve(mesh.mNumVertices);
  for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
    const aiVector3D& at = mesh.mVertices[i];
    for (unsigned axis = 0; axis < 3; ++axis) {
      if (!std::isfinite(at[axis])) continue;
      low_[axis] = std::min(low_[axis], at[axis]);
      high_[axis] = std::max(high_[axis], at[axis]);
      rounding_ = std::max(rounding_, std::abs(double{at[axis]}) * std::numeric_limits<float>::epsilon() / 2);
    }
    const Affine place = at_rest.empty() ? transform : affine_of(at_rest[i]);
    to.positions.push_back(place * Vector{double{at.x} + files_.origin[0], double{at.y} + files_.origin[1],
                                          double{at.z} + files_.origin[2]});
    to.vertices.push_back(
        vertex(mesh, i, at_rest.empty() ? normal_transform : map_of_normals(at_rest[i]), to, texture));
  }
  if (to.has_texcoords) {
    const std::span texcoords(mesh.mTextureCoords[set], mesh.mNumVertices);
    to.bad_texcoords = static_cast<std::uint64_t>(std::ranges::count_if(
        texcoords, [](const aiVector3D& at) { return !std::isfinite(at.x) || !std::isfinite(at.y); }));
  }
  for (const aiFace& face : std::span(mesh.mFaces, mesh.mNumFaces)) {
    if (face.mNumIndices == 0) continue;
    const unsigned* const last = face.mIndices + face.mNumIndices - 1;
    if (face.mNumIndices == 3) to.indices.insert(to.indices.end(), face.mIndices, face.mIndices + 3);
    if (face.mNumIndices < 3) to.segments.insert(to.segments.end(), {*face.mIndices, *last});
  }
  // A point cloud from a scanner.
  for (unsigned i = 0; mesh.mNumFaces == 0 && i < mesh.mNumVertices; ++i) {
    to.segments.insert(to.segments.end(), {i, i});
  }
  return groups_.add(std::move(to));
}

/// Makes vertex colours replace the material's colour, which would otherwise multiply them.
void colour_by_vertices(SourceModel& model) {
  const auto set_white = [&model](auto& coloured) {
    if (!coloured.has_colours) return;
    SourceMaterial white = model.materials[coloured.material];
    white.colour = {255, 255, 255};
    coloured.material = static_cast<std::uint32_t>(model.materials.size());
    model.materials.push_back(white);
  };
  std::ranges::for_each(model.meshes, set_white);
  std::ranges::for_each(model.lines, set_white);
}

}  // namespace

Result<SourceModel> read_assimp(const std::filesystem::path& path, std::optional<UpAxis> up, Texcoords texcoords,
                                const std::function<void()>& parsed) {
  FilesRead files;
  Assimp::Importer importer;
  importer.SetIOHandler(std::make_unique<ModelFiles>(path, files).release());  // the importer owns it
  const SilentStreams silent;
  const aiScene* scene = importer.ReadFile(path.string(), 0);
  if (scene != nullptr) {
    const unsigned corners = most_corners(*scene);
    if (corners > kMaxCorners) {
      return Failure{ExitStatus::input,
                     fmt::format("has a face of {} corners; at most {} are read: cut it into smaller "
                                 "ones",
                                 grouped(corners), grouped(kMaxCorners))};
    }
    scene = importer.ApplyPostProcessing(aiProcess_Triangulate | aiProcess_TransformUVCoords);
  }
  if (scene == nullptr) {
    rethrow_lack_of_memory(importer.GetException());
    return unreadable_model(without_contents(importer.GetErrorString()));
  }
  parsed();
  SourceModel model;
  const Affine turn = turn_up(up.value_or(up_of_format(*scene, path)));
  MaterialReader materials(*scene, path, model);
  materials.read_all();
  if (const Result<Done> collected =
          Collector(*scene, turn, ending_of(path) == ".amf", files, materials, texcoords, model).collect();
      !collected) {
    return collected.failure();
  }
  colour_by_vertices(model);
  read_lights(*scene, to_matrix(turn), model);
  warn_of_unread(path, files, model);
  return model;
}

}  // namespace zstrip::sim
