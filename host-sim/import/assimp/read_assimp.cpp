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
#include "import/mesh_groups.hpp"
#include "import/model_files.hpp"
#include "import/screen_channel.hpp"
#include "import/turn_up.hpp"
#include "text/number.hpp"

namespace zstrip::sim {
namespace {

/// Adding zero changes -0 to 0, so that equal vertices are equal bytes.
std::array<float, 3> components(const aiVector3D& v) { return {v.x + 0.0F, v.y + 0.0F, v.z + 0.0F}; }

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

/// True if the vertex has a colour, in a file where other vertices have one.
bool has_colour(const aiColor4D& colour) {
  return colour.r != kNoColour || colour.g != kNoColour || colour.b != kNoColour;
}

/// Limit for a face's corners: the time of Assimp's triangulation grows faster than their square.
constexpr unsigned kMaxCorners = 5'000;

unsigned most_corners(const aiScene& scene) {
  unsigned most = 0;
  for (const aiMesh* mesh : std::span(scene.mMeshes, scene.mNumMeshes)) {
    for (const aiFace& face : std::span(mesh->mFaces, mesh->mNumFaces)) most = std::max(most, face.mNumIndices);
  }
  return most;
}

/// Throws the exception again if memory was missing, which is no fault of the file.
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

/// Walks the nodes and collects their transformed meshes.
class Collector {
 public:
  Collector(const aiScene& scene, const aiMatrix4x4& turn, const MaterialReader& materials, Texcoords texcoords,
            SourceModel& model)
      : scene_(scene), turn_(turn), materials_(materials), texcoords_(texcoords), model_(model), groups_(model) {}

  Result<Done> collect();

 private:
  Result<Done> add(const aiMesh& mesh, const aiMatrix4x4& transform);
  SourceVertex vertex(const aiMesh& mesh, unsigned index, const aiMatrix4x4& transform,
                      const aiMatrix3x3& normal_transform, const SourcePrimitive& to) const;

  const aiScene& scene_;
  const aiMatrix4x4& turn_;
  const MaterialReader& materials_;
  Texcoords texcoords_;
  SourceModel& model_;
  MeshGroups groups_;
};

Result<Done> Collector::collect() {
  std::vector<std::pair<const aiNode*, aiMatrix4x4>> open;
  if (scene_.mRootNode != nullptr) open.emplace_back(scene_.mRootNode, turn_ * scene_.mRootNode->mTransformation);
  while (!open.empty()) {
    const auto [node, transform] = open.back();
    open.pop_back();
    for (const unsigned index : std::span(node->mMeshes, node->mNumMeshes)) {
      if (index >= scene_.mNumMeshes) continue;
      if (const Result<Done> added = add(*scene_.mMeshes[index], transform); !added) return added.failure();
    }
    // In reverse, so that children are removed from the stack in the file's order.
    for (unsigned child = node->mNumChildren; child-- > 0;) {
      open.emplace_back(node->mChildren[child], transform * node->mChildren[child]->mTransformation);
    }
  }
  return groups_.finish();
}

SourceVertex Collector::vertex(const aiMesh& mesh, unsigned index, const aiMatrix4x4& transform,
                               const aiMatrix3x3& normal_transform, const SourcePrimitive& to) const {
  SourceVertex vertex;
  vertex.position = components(transform * mesh.mVertices[index]);
  if (mesh.HasNormals()) vertex.normal = components(direction(normal_transform * mesh.mNormals[index]));
  if (to.has_colours) {
    const aiColor4D& colour = mesh.mColors[0][index];
    const auto& [r, g, b] = model_.materials[to.material].colour;
    vertex.colour = {r, g, b, 255};
    if (has_colour(colour)) {
      vertex.colour = {to_screen_channel(colour.r, false), to_screen_channel(colour.g, false),
                       to_screen_channel(colour.b, false), 255};
    }
  }
  if (to.has_texcoords) {
    const aiVector3D& texcoord = mesh.mTextureCoords[materials_.texcoord_set(mesh.mMaterialIndex)][index];
    // Assimp's v grows upwards.
    if (std::isfinite(texcoord.x) && std::isfinite(texcoord.y)) {
      vertex.texcoord = {texcoord.x + 0.0F, 1.0F - texcoord.y};
    }
  }
  return vertex;
}

Result<Done> Collector::add(const aiMesh& mesh, const aiMatrix4x4& transform) {
  if (!mesh.HasPositions()) return Done{};
  SourcePrimitive to;
  to.material = mesh.mMaterialIndex;
  if (to.material >= model_.materials.size()) return Done{};
  const unsigned set = materials_.texcoord_set(to.material);
  const bool wants_texcoords =
      texcoords_ == Texcoords::all || model_.materials[to.material].texture != kNoSourceTexture;
  to.has_colours =
      mesh.HasVertexColors(0) && std::ranges::any_of(std::span(mesh.mColors[0], mesh.mNumVertices), has_colour);
  to.has_texcoords = wants_texcoords && set < AI_MAX_NUMBER_OF_TEXTURECOORDS && mesh.HasTextureCoords(set);
  to.morphs = mesh.mNumAnimMeshes > 0 && scene_.mNumAnimations > 0;
  to.mirrored = aiMatrix3x3(transform).Determinant() < 0;
  const std::vector<aiMatrix4x4> at_rest = bones_at_rest(scene_, turn_, mesh, transform);
  const aiMatrix3x3 normal_transform = map_of_normals(transform);
  to.vertices.reserve(mesh.mNumVertices);
  for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
    to.vertices.push_back(at_rest.empty() ? vertex(mesh, i, transform, normal_transform, to)
                                          : vertex(mesh, i, at_rest[i], map_of_normals(at_rest[i]), to));
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
  return groups_.add(to);
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
    std::string reason = importer.GetErrorString();
    std::replace(reason.begin(), reason.end(), '\n', ' ');
    return Failure{ExitStatus::input,
                   fmt::format("is no readable model ({}); export it again, for example as .glb", reason)};
  }
  parsed();
  SourceModel model;
  const aiMatrix4x4 turn = to_matrix(turn_up(up.value_or(up_of_format(*scene, path))));
  MaterialReader materials(*scene, path, model);
  materials.read_all();
  if (const Result<Done> collected = Collector(*scene, turn, materials, texcoords, model).collect(); !collected) {
    return collected.failure();
  }
  colour_by_vertices(model);
  read_lights(*scene, turn, model);
  warn_of_unread(path, files, model);
  return model;
}

}  // namespace zstrip::sim
