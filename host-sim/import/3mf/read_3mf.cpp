// Reads a 3MF package: all objects that are built, from all its parts.
#include "import/3mf/read_3mf.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "image/decode.hpp"
#include "import/3mf/package.hpp"
#include "import/3mf/xml_tags.hpp"
#include "import/3mf/zip_archive.hpp"
#include "import/mesh_groups.hpp"
#include "import/unreadable.hpp"
#include "text/number.hpp"
#include "text/text.hpp"

namespace zstrip::sim {
namespace {

/// The path of the first part, of which the relations of the package tell.
std::string path_of_root(ZipArchive& archive) {
  const Result<std::string> relations = archive.read("_rels/.rels");
  if (relations) {
    XmlTags tags(*relations);
    while (const std::optional<XmlTag> tag = tags.next()) {
      if (tag->name == "Relationship" && tag->value("Type").ends_with("/3dmodel")) return tag->value("Target");
    }
  }
  return "3D/3dmodel.model";
}

class PackageReader {
 public:
  PackageReader(ZipArchive archive, const Affine& turn, Texcoords texcoords)
      : archive_(std::move(archive)), turn_(turn), texcoords_(texcoords), groups_(model_) {}

  Result<Done> read_all();
  SourceModel& model() { return model_; }

 private:
  /// Finds the property of a triangle: path of the part, number of the group, index in it.
  using Key = std::tuple<std::string, std::uint32_t, std::uint32_t>;

  /// Returns the part of a path, read once.
  Result<const PrintPart*> part(const std::string& path);
  Result<Done> add_object(const std::string& path, std::uint32_t id, const Affine& place, int depth);
  Result<Done> add_triangles(const std::string& path, const PrintPart& part, const PrintObject& object,
                             const Affine& place);
  /// Returns the material of a triangle, added once.
  std::uint32_t material_of(const std::string& path, const PrintPart& part, const PrintTriangle& triangle);
  std::uint32_t texture_of(const PrintPart& part, const PrintGroup& group);

  ZipArchive archive_;
  Affine turn_;
  Texcoords texcoords_;
  SourceModel model_;
  MeshGroups groups_;
  std::map<std::string, PrintPart> parts_;
  std::map<Key, std::uint32_t> materials_;
  std::map<std::string, std::uint32_t> textures_;  ///< by path; also those that failed
  std::size_t uses_ = 0, lost_ = 0;
};

Result<const PrintPart*> PackageReader::part(const std::string& path) {
  const auto known = parts_.find(path);
  if (known != parts_.end()) return &known->second;
  const Result<std::string> xml = archive_.read(path);
  if (!xml) return unreadable_model(xml.failure().message);
  Result<PrintPart> read = read_print_part(*xml);
  if (!read) return unreadable_model(read.failure().message);
  return &parts_.emplace(path, std::move(*read)).first->second;
}

std::uint32_t PackageReader::texture_of(const PrintPart& part, const PrintGroup& group) {
  const auto named = part.textures.find(group.texture);
  if (named == part.textures.end()) return kNoSourceTexture;
  const auto [at, is_new] = textures_.try_emplace(named->second, kNoSourceTexture);
  if (!is_new) return at->second;
  const Result<std::string> bytes = archive_.read(named->second);
  Result<RgbImage> picture = bytes ? decode_image({reinterpret_cast<const std::uint8_t*>(bytes->data()), bytes->size()})
                                   : Result<RgbImage>(bytes.failure());
  if (!picture) {
    model_.warnings.push_back(fmt::format("texture '{}' cannot be read: {}; its surfaces are drawn without it",
                                          printable(named->second), picture.failure().message));
    return kNoSourceTexture;
  }
  at->second = static_cast<std::uint32_t>(model_.textures.size());
  model_.textures.push_back(std::move(*picture));
  model_.texture_names.push_back(named->second);
  return at->second;
}

std::uint32_t PackageReader::material_of(const std::string& path, const PrintPart& part,
                                         const PrintTriangle& triangle) {
  const auto found = part.groups.find(triangle.group);
  const PrintGroup* const group = found == part.groups.end() ? nullptr : &found->second;
  const bool is_base = group != nullptr && group->kind == PrintGroupKind::materials;
  const Key key =
      group == nullptr ? Key{"", kNoProperty, 0} : Key{path, triangle.group, is_base ? triangle.properties[0] : 0};
  const auto [at, is_new] = materials_.try_emplace(key, static_cast<std::uint32_t>(model_.materials.size()));
  if (!is_new) return at->second;
  SourceMaterial material;
  if (group == nullptr) material.colour = kDefaultColour;
  const std::size_t base = triangle.properties[0];
  if (is_base && base < group->colours.size() && base < group->names.size()) {
    const auto& [r, g, b, a] = group->colours[base];
    material.name = group->names[base];
    material.colour = {r, g, b};
  }
  if (group != nullptr && group->kind == PrintGroupKind::texture) material.texture = texture_of(part, *group);
  model_.materials.push_back(std::move(material));
  return at->second;
}

Result<Done> PackageReader::add_triangles(const std::string& path, const PrintPart& part, const PrintObject& object,
                                          const Affine& place) {
  std::map<std::uint32_t, SourcePrimitive> by_material;
  for (const PrintTriangle& triangle : object.triangles) {
    const std::uint32_t material = material_of(path, part, triangle);
    SourcePrimitive& to = by_material[material];
    to.material = material;
    const auto found = part.groups.find(triangle.group);
    const PrintGroup* const group = found == part.groups.end() ? nullptr : &found->second;
    to.has_colours = group != nullptr && group->kind == PrintGroupKind::colours;
    to.has_texcoords = group != nullptr && group->kind == PrintGroupKind::texture &&
                       (texcoords_ == Texcoords::all || model_.materials[material].texture != kNoSourceTexture);
    for (std::size_t k = 0; k < 3; ++k) {
      SourceVertex vertex;
      const std::uint32_t property = triangle.properties[k];
      if (to.has_colours && property < group->colours.size()) vertex.colour = group->colours[property];
      vertex.colour[3] = 255;
      if (to.has_texcoords && property < group->texcoords.size()) {
        const auto& [u, v] = group->texcoords[property];
        const bool usable = std::isfinite(u) && std::isfinite(v);
        if (usable) vertex.texcoord = {static_cast<float>(u) + 0.0F, static_cast<float>(1 - v) + 0.0F};
        if (!usable) ++to.bad_texcoords;
      }
      const std::uint32_t corner = triangle.corners[k];
      const bool exists = corner < object.vertices.size();
      to.indices.push_back(exists ? static_cast<std::uint32_t>(to.vertices.size()) : kNoProperty);
      if (!exists) continue;
      to.vertices.push_back(vertex);
      to.positions.push_back(place * object.vertices[corner]);
    }
  }
  for (auto& [material, primitive] : by_material) {
    primitive.mirrored = determinant(place) < 0;
    if (const Result<Done> added = groups_.add(std::move(primitive)); !added) return added.failure();
  }
  return Done{};
}

Result<Done> PackageReader::add_object(const std::string& path, std::uint32_t id, const Affine& place, int depth) {
  constexpr int kMaxDepth = 64;
  constexpr std::size_t kMaxUses = 1'000'000;
  if (depth > kMaxDepth || ++uses_ > kMaxUses) return unreadable_model("its components are nested too deeply");
  const Result<const PrintPart*> found = part(path);
  if (!found) return found.failure();
  const auto object = (*found)->objects.find(id);
  if (object == (*found)->objects.end()) {
    ++lost_;
    return Done{};
  }
  if (const Result<Done> added = add_triangles(path, **found, object->second, place); !added) return added.failure();
  for (const PrintUse& use : object->second.components) {
    const Result<Done> added = add_object(use.part.empty() ? path : use.part, use.object, place * use.place, depth + 1);
    if (!added) return added.failure();
  }
  return Done{};
}

Result<Done> PackageReader::read_all() {
  const std::string root = path_of_root(archive_);
  const Result<const PrintPart*> found = part(root);
  if (!found) return found.failure();
  std::vector<PrintUse> built = (*found)->built;
  if (built.empty()) {
    for (const auto& [id, object] : (*found)->objects) built.push_back({"", id, {}});
  }
  for (const PrintUse& item : built) {
    const Result<Done> added = add_object(item.part.empty() ? root : item.part, item.object, turn_ * item.place, 0);
    if (!added) return added.failure();
  }
  if (lost_ > 0) model_.warnings.push_back(fmt::format("{} left out: not in the file", counted(lost_, "object")));
  std::set<std::string> undrawn;
  for (const auto& [path, each] : parts_) undrawn.insert(each.undrawn.begin(), each.undrawn.end());
  const std::string names = fmt::format("{}", fmt::join(undrawn, ", "));
  if (!names.empty()) model_.warnings.push_back("drawn without: " + names);
  Result<Done> finished = groups_.finish();
  if (!finished && !names.empty() && model_.meshes.empty()) {
    return Failure{ExitStatus::input, fmt::format("has no triangles, but {}: export it as a surface", names)};
  }
  return finished;
}

}  // namespace

Result<SourceModel> read_3mf(std::string_view file, const Affine& turn, Texcoords texcoords) {
  Result<ZipArchive> archive = ZipArchive::open(file);
  if (!archive) return unreadable_model(archive.failure().message);
  PackageReader reader(std::move(*archive), turn, texcoords);
  if (const Result<Done> read = reader.read_all(); !read) return read.failure();
  return std::move(reader.model());
}

}  // namespace zstrip::sim
