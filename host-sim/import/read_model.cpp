// Reads a model file of any format that Assimp reads.
#include "import/read_model.hpp"

#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cmath>
#include <iostream>
#include <map>
#include <memory>
#include <span>
#include <streambuf>
#include <string>
#include <system_error>
#include <tuple>
#include <utility>

#include "import/bones.hpp"
#include "import/crash_guard.hpp"
#include "import/lights_and_cameras.hpp"
#include "import/materials.hpp"
#include "import/model_files.hpp"
#include "import/moved_nodes.hpp"
#include "import/read_file.hpp"
#include "report/number.hpp"
#include "report/text.hpp"

namespace zstrip::sim {
namespace {

bool finite(const aiVector3D& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// Adding zero turns -0 into 0, so that equal vertices are equal bytes.
std::array<float, 3> components(const aiVector3D& v) { return {v.x + 0.0F, v.y + 0.0F, v.z + 0.0F}; }

/// Unit length, or zero where there is no direction.
aiVector3D direction(const aiVector3D& v) {
  const float length = v.Length();
  return std::isfinite(length) && length > 1e-20F ? v / length : aiVector3D();
}

/// The rotation that turns an axis to +y.
aiMatrix4x4 turn_up(UpAxis up) {
  // clang-format off
  switch (up) {
    case UpAxis::plus_x:  return { 0, -1, 0, 0,   1,  0,  0, 0,   0, 0, 1, 0,   0, 0, 0, 1};
    case UpAxis::minus_x: return { 0,  1, 0, 0,  -1,  0,  0, 0,   0, 0, 1, 0,   0, 0, 0, 1};
    case UpAxis::plus_y:  return {};
    case UpAxis::minus_y: return {-1,  0, 0, 0,   0, -1,  0, 0,   0, 0, 1, 0,   0, 0, 0, 1};
    case UpAxis::plus_z:  return { 1,  0, 0, 0,   0,  0,  1, 0,   0, -1, 0, 0,  0, 0, 0, 1};
    case UpAxis::minus_z: return { 1,  0, 0, 0,   0,  0, -1, 0,   0, 1, 0, 0,   0, 0, 0, 1};
  }
  // clang-format on
  return {};
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

/// While it lives, what is written to std::cout and std::cerr is lost: some of Assimp's readers write there, and
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

/// Walks the nodes and collects their meshes, transformed.
class Collector {
 public:
  Collector(const aiScene& scene, const aiMatrix4x4& turn, const MaterialReader& materials, const MovedNodes& moved,
            Texcoords texcoords, SourceModel& model)
      : scene_(scene),
        turn_(turn),
        materials_(materials),
        moved_(moved),
        texcoords_(texcoords),
        model_(model),
        bones_(scene, turn, moved, model) {}

  Result<Done> collect();

 private:
  void add(const aiMesh& mesh, const aiMatrix4x4& transform, const aiNode& on);
  SourceMesh& mesh_for(std::uint32_t material, bool has_colours, bool has_texcoords, std::int32_t node, bool has_skin);
  void note_alpha(const aiMesh& mesh, const SourceMaterial& material);
  SourceVertex vertex(const aiMesh& mesh, unsigned index, const aiMatrix4x4& transform,
                      const aiMatrix3x3& normal_transform, const SourceMesh& group);

  const aiScene& scene_;
  const aiMatrix4x4& turn_;
  const MaterialReader& materials_;
  const MovedNodes& moved_;
  Texcoords texcoords_;
  SourceModel& model_;
  BoneReader bones_;
  /// By material, colours, texture coordinates, node, skin; and a number where meshes must stay apart.
  std::map<std::tuple<std::uint32_t, bool, bool, std::int32_t, bool, std::uint32_t>, std::size_t> groups_;
  std::uint64_t vertices_ = 0;
  std::uint64_t triangles_seen_ = 0;
  std::uint64_t triangles_kept_ = 0;
  std::uint64_t not_finite_ = 0;
  std::uint64_t bad_index_ = 0;
  std::uint64_t vertex_alpha_ = 0;
  std::uint64_t deformed_ = 0;
};

Result<Done> Collector::collect() {
  std::vector<std::pair<const aiNode*, aiMatrix4x4>> open;
  if (scene_.mRootNode != nullptr) open.emplace_back(scene_.mRootNode, turn_ * scene_.mRootNode->mTransformation);
  while (!open.empty()) {
    const auto [node, transform] = open.back();
    open.pop_back();
    for (const unsigned index : std::span(node->mMeshes, node->mNumMeshes)) {
      if (index >= scene_.mNumMeshes) continue;
      add(*scene_.mMeshes[index], transform, *node);
      if (triangles_seen_ > kMaxTriangles || vertices_ > 3 * kMaxTriangles) {
        return Failure{ExitStatus::input, fmt::format("has more than {} triangles; simplify the model", kMaxTriangles)};
      }
    }
    // In reverse, so that children come off the stack in the file's order.
    for (unsigned child = node->mNumChildren; child-- > 0;) {
      open.emplace_back(node->mChildren[child], transform * node->mChildren[child]->mTransformation);
    }
  }
  if (triangles_kept_ == 0 && triangles_seen_ > 0) {
    return Failure{ExitStatus::input,
                   "has no drawable triangle: none with finite corners and an area; repair the model"};
  }
  if (triangles_kept_ == 0) {
    return Failure{ExitStatus::input, "has no triangles, only points, lines or nothing; export it as a surface"};
  }
  if (not_finite_ > 0) {
    model_.warnings.push_back(
        fmt::format("{} left out: corners not finite (NaN or infinite)", counted(not_finite_, "triangle")));
  }
  if (bad_index_ > 0) {
    model_.warnings.push_back(
        fmt::format("{} left out: with vertices that do not exist", counted(bad_index_, "triangle")));
  }
  if (vertex_alpha_ > 0) {
    model_.warnings.push_back(
        fmt::format("{} drawn without the alpha of its vertex colours", counted(vertex_alpha_, "mesh")));
  }
  if (deformed_ > 0 && scene_.mNumAnimations > 0) {
    model_.warnings.push_back(fmt::format("{} with morph targets drawn at rest: only nodes and skins are animated",
                                          counted(deformed_, "mesh")));
  }
  bones_.warn();
  return Done{};
}

/// What blends is sorted by instances, so that each stays one.
SourceMesh& Collector::mesh_for(std::uint32_t material, bool has_colours, bool has_texcoords, std::int32_t node,
                                bool has_skin) {
  const bool blends = model_.materials[material].alpha_mode == AlphaMode::blend;
  const auto apart = static_cast<std::uint32_t>(blends ? model_.meshes.size() + 1 : 0);
  const auto [at, is_new] =
      groups_.try_emplace({material, has_colours, has_texcoords, node, has_skin, apart}, model_.meshes.size());
  if (is_new) {
    SourceMesh& mesh = model_.meshes.emplace_back();
    mesh.material = material;
    mesh.node = node;
    mesh.has_skin = has_skin;
    mesh.has_colours = has_colours;
    mesh.has_texcoords = has_texcoords;
  }
  return model_.meshes[at->second];
}

SourceVertex Collector::vertex(const aiMesh& mesh, unsigned index, const aiMatrix4x4& transform,
                               const aiMatrix3x3& normal_transform, const SourceMesh& group) {
  SourceVertex to;
  to.position = components(transform * mesh.mVertices[index]);
  if (mesh.HasNormals()) to.normal = components(direction(normal_transform * mesh.mNormals[index]));
  if (group.has_colours) {
    const aiColor4D& colour = mesh.mColors[0][index];
    const bool linear = materials_.linear_colours();
    to.colour = {to_screen_channel(colour.r, linear), to_screen_channel(colour.g, linear),
                 to_screen_channel(colour.b, linear), 255};
  }
  if (group.has_texcoords) {
    const aiVector3D& texcoord = mesh.mTextureCoords[materials_.texcoord_set(mesh.mMaterialIndex)][index];
    // Assimp's v grows upwards.
    if (std::isfinite(texcoord.x) && std::isfinite(texcoord.y)) to.texcoord = {texcoord.x + 0.0F, 1.0F - texcoord.y};
  }
  return to;
}

void Collector::note_alpha(const aiMesh& mesh, const SourceMaterial& material) {
  if (material.alpha_mode == AlphaMode::opaque || !mesh.HasVertexColors(0)) return;
  const std::span<const aiColor4D> colours(mesh.mColors[0], mesh.mNumVertices);
  if (std::any_of(colours.begin(), colours.end(), [](const aiColor4D& colour) { return colour.a < 1; }))
    ++vertex_alpha_;
}

void Collector::add(const aiMesh& mesh, const aiMatrix4x4& transform, const aiNode& on) {
  if ((mesh.mPrimitiveTypes & aiPrimitiveType_TRIANGLE) == 0 || !mesh.HasPositions()) return;
  const std::uint32_t material = mesh.mMaterialIndex;
  if (material >= model_.materials.size()) return;
  const unsigned set = materials_.texcoord_set(material);
  const bool wants_texcoords = texcoords_ == Texcoords::all || model_.materials[material].texture != kNoSourceTexture;
  const bool has_texcoords = wants_texcoords && set < AI_MAX_NUMBER_OF_TEXTURECOORDS && mesh.HasTextureCoords(set);
  const MeshBones bones = bones_.read(mesh, transform, on);
  SourceMesh& group = mesh_for(material, mesh.HasVertexColors(0), has_texcoords,
                               mesh.HasBones() ? kNoNode : moved_.mover_of(on), !bones.joints.empty());

  note_alpha(mesh, model_.materials[material]);
  if (mesh.mNumAnimMeshes > 0) ++deformed_;

  const auto of_normals = [](const aiMatrix4x4& of_positions) {
    aiMatrix3x3 linear(of_positions);
    if (linear.Determinant() != 0) linear.Inverse().Transpose();
    return linear;
  };
  const aiMatrix3x3 normal_transform = of_normals(bones.modelled);
  const bool mirrored = aiMatrix3x3(bones.modelled).Determinant() < 0;

  const auto first = static_cast<std::uint32_t>(group.vertices.size());
  vertices_ += mesh.mNumVertices;
  for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
    if (!bones.at_rest.empty()) {
      group.vertices.push_back(vertex(mesh, i, bones.at_rest[i], of_normals(bones.at_rest[i]), group));
      continue;
    }
    group.vertices.push_back(vertex(mesh, i, bones.modelled, normal_transform, group));
    if (bones.joints.empty()) continue;
    group.vertices.back().joints = bones.joints[i].joints;
    group.vertices.back().weights = bones.joints[i].weights;
  }
  for (const aiFace& face : std::span(mesh.mFaces, mesh.mNumFaces)) {
    if (face.mNumIndices != 3) continue;
    ++triangles_seen_;
    unsigned a = face.mIndices[0];
    unsigned b = face.mIndices[1];
    unsigned c = face.mIndices[2];
    if (std::max({a, b, c}) >= mesh.mNumVertices) {
      ++bad_index_;
      continue;
    }
    const auto finite_corner = [&](unsigned index) {
      const auto& position = group.vertices[first + index].position;
      return finite({position[0], position[1], position[2]});
    };
    if (!finite_corner(a) || !finite_corner(b) || !finite_corner(c)) {
      ++not_finite_;
      continue;
    }
    if (!has_area(group.vertices[first + a], group.vertices[first + b], group.vertices[first + c])) continue;
    if (mirrored) std::swap(b, c);
    ++triangles_kept_;
    group.indices.insert(group.indices.end(), {first + a, first + b, first + c});
  }
}

}  // namespace

Result<SourceModel> read_model(const std::filesystem::path& path, UpAxis up, Texcoords texcoords) {
  const auto named = [&](const std::string& message) {
    return Failure{ExitStatus::input, fmt::format("'{}' {}", path.string(), message)};
  };
  if (const Result<Done> readable = check_readable(path); !readable) return named(readable.failure().message);

  Assimp::Importer importer;
  SourceModel model;
  std::error_code error;
  const std::uint64_t bytes = std::filesystem::file_size(path, error);
  if (error) return named("cannot be read: " + error.message());
  const std::chrono::seconds limit = reading_limit(bytes);
  const std::string shown = printable(path.string());
  CrashGuard guard(
      fmt::format(
          "zstrip: '{}' crashed the model reader: it is damaged, or not as the reader expects it; export it again",
          shown),
      fmt::format("zstrip: '{}' is not read after {} s: the file is damaged, or too intricate; export it again", shown,
                  limit.count()),
      limit, reading_memory(bytes));
  importer.SetIOHandler(std::make_unique<ModelFiles>().release());  // which it owns
  const aiScene* const scene = [&] {
    const SilentStreams silent;
    return importer.ReadFile(path.string(), aiProcess_Triangulate | aiProcess_TransformUVCoords);
  }();
  if (scene == nullptr) {
    std::string reason = importer.GetErrorString();
    std::replace(reason.begin(), reason.end(), '\n', ' ');
    return named(fmt::format("is no readable model ({}); export it again, for example as .glb", reason));
  }
  guard.lift_limits();
  const aiMatrix4x4 turn = turn_up(up);
  MaterialReader materials(*scene, path.parent_path(), model);
  materials.read_all();
  const MovedNodes moved(*scene, turn, materials.linear_colours() ? path : std::filesystem::path(), model);
  if (const Result<Done> collected = Collector(*scene, turn, materials, moved, texcoords, model).collect();
      !collected) {
    return named(collected.failure().message);
  }
  // Outside glTF, vertex colours stand for the material's colour and are not multiplied with it.
  if (!materials.linear_colours()) {
    for (SourceMesh& mesh : model.meshes) {
      if (!mesh.has_colours) continue;
      SourceMaterial white = model.materials[mesh.material];
      white.colour = {255, 255, 255};
      mesh.material = static_cast<std::uint32_t>(model.materials.size());
      model.materials.push_back(white);
    }
  }
  std::erase_if(model.meshes, [](const SourceMesh& mesh) { return mesh.indices.empty(); });
  read_lights(*scene, turn, materials.linear_colours(), model);
  if (materials.linear_colours()) read_cameras(*scene, turn, model);
  return model;
}

}  // namespace zstrip::sim
