// The types of a glTF file's members: those that the reader uses, object by object.
#include "import/gltf/types.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "import/gltf/document.hpp"
#include "text/text.hpp"

namespace zstrip::sim {
namespace {

enum class Type : std::uint8_t { whole, number, text, flag, wholes, numbers, texts, object, objects, map };

struct Field {
  std::string_view key;
  Type type;
  std::size_t count = 0;             ///< of an array's elements; 0: any
  std::span<const Field> members{};  ///< of an object, or of the objects of an array or map
};

constexpr std::array kTextureTransform{Field{"offset", Type::numbers, 2}, Field{"scale", Type::numbers, 2},
                                       Field{"rotation", Type::number}, Field{"texCoord", Type::whole}};
constexpr std::array kUseExtensions{Field{"KHR_texture_transform", Type::object, 0, kTextureTransform}};
constexpr std::array kTextureUse{Field{"index", Type::whole}, Field{"texCoord", Type::whole},
                                 Field{"extensions", Type::object, 0, kUseExtensions}};
constexpr std::array kLitTexture{Field{"index", Type::whole}, Field{"texCoord", Type::whole},
                                 Field{"scale", Type::number}, Field{"strength", Type::number}};
constexpr std::array kBase{Field{"metallicFactor", Type::number}, Field{"roughnessFactor", Type::number},
                           Field{"baseColorFactor", Type::numbers, 4},
                           Field{"baseColorTexture", Type::object, 0, kTextureUse},
                           Field{"metallicRoughnessTexture", Type::object, 0, kTextureUse}};
constexpr std::array kDiffuse{
    Field{"diffuseFactor", Type::numbers, 4}, Field{"diffuseTexture", Type::object, 0, kTextureUse},
    Field{"specularFactor", Type::numbers, 3}, Field{"specularGlossinessTexture", Type::object, 0, kTextureUse}};
constexpr std::array kStrength{Field{"emissiveStrength", Type::number}};
constexpr std::array kIor{Field{"ior", Type::number}};
constexpr std::array kSpecular{Field{"specularFactor", Type::number}, Field{"specularColorFactor", Type::numbers, 3}};
constexpr std::array<Field, 0> kNoMembers{};
constexpr std::array kMaterialExtensions{Field{"KHR_materials_emissive_strength", Type::object, 0, kStrength},
                                         Field{"KHR_materials_ior", Type::object, 0, kIor},
                                         Field{"KHR_materials_specular", Type::object, 0, kSpecular},
                                         Field{"KHR_materials_pbrSpecularGlossiness", Type::object, 0, kDiffuse},
                                         Field{"KHR_materials_unlit", Type::object, 0, kNoMembers}};
constexpr std::array kMaterial{Field{"name", Type::text},
                               Field{"normalTexture", Type::object, 0, kLitTexture},
                               Field{"occlusionTexture", Type::object, 0, kLitTexture},
                               Field{"pbrMetallicRoughness", Type::object, 0, kBase},
                               Field{"emissiveFactor", Type::numbers, 3},
                               Field{"emissiveTexture", Type::object, 0, kTextureUse},
                               Field{"alphaMode", Type::text},
                               Field{"alphaCutoff", Type::number},
                               Field{"doubleSided", Type::flag},
                               Field{"extensions", Type::object, 0, kMaterialExtensions}};
constexpr std::array kTexture{Field{"name", Type::text}, Field{"source", Type::whole}, Field{"sampler", Type::whole}};
constexpr std::array kImage{Field{"name", Type::text}, Field{"uri", Type::text}, Field{"bufferView", Type::whole}};
constexpr std::array kSampler{Field{"wrapS", Type::whole}, Field{"wrapT", Type::whole}};
constexpr std::array kSparsePart{Field{"bufferView", Type::whole}, Field{"byteOffset", Type::whole},
                                 Field{"componentType", Type::whole}};
constexpr std::array kSparse{Field{"count", Type::whole}, Field{"indices", Type::object, 0, kSparsePart},
                             Field{"values", Type::object, 0, kSparsePart}};
constexpr std::array kAccessor{Field{"bufferView", Type::whole},
                               Field{"byteOffset", Type::whole},
                               Field{"componentType", Type::whole},
                               Field{"count", Type::whole},
                               Field{"type", Type::text},
                               Field{"normalized", Type::flag},
                               Field{"sparse", Type::object, 0, kSparse}};
constexpr std::array kCompressedView{Field{"buffer", Type::whole},     Field{"byteOffset", Type::whole},
                                     Field{"byteLength", Type::whole}, Field{"byteStride", Type::whole},
                                     Field{"count", Type::whole},      Field{"mode", Type::text},
                                     Field{"filter", Type::text}};
constexpr std::array kViewExtensions{Field{"EXT_meshopt_compression", Type::object, 0, kCompressedView}};
constexpr std::array kView{Field{"buffer", Type::whole}, Field{"byteOffset", Type::whole},
                           Field{"byteLength", Type::whole}, Field{"byteStride", Type::whole},
                           Field{"extensions", Type::object, 0, kViewExtensions}};
constexpr std::array kBuffer{Field{"uri", Type::text}, Field{"byteLength", Type::whole}};
constexpr std::array kDraco{Field{"bufferView", Type::whole}, Field{"attributes", Type::map}};
constexpr std::array kPrimitiveExtensions{Field{"KHR_draco_mesh_compression", Type::object, 0, kDraco}};
constexpr std::array kTarget{Field{"POSITION", Type::whole}, Field{"NORMAL", Type::whole}};
constexpr std::array kPrimitive{Field{"attributes", Type::map},
                                Field{"indices", Type::whole},
                                Field{"material", Type::whole},
                                Field{"mode", Type::whole},
                                Field{"targets", Type::objects, 0, kTarget},
                                Field{"extensions", Type::object, 0, kPrimitiveExtensions}};
constexpr std::array kMesh{Field{"name", Type::text}, Field{"primitives", Type::objects, 0, kPrimitive},
                           Field{"weights", Type::numbers}};
constexpr std::array kLightOfNode{Field{"light", Type::whole}};
constexpr std::array kVisibility{Field{"visible", Type::flag}};
constexpr std::array kInstancing{Field{"attributes", Type::map}};
constexpr std::array kNodeExtensions{Field{"KHR_lights_punctual", Type::object, 0, kLightOfNode},
                                     Field{"KHR_node_visibility", Type::object, 0, kVisibility},
                                     Field{"EXT_mesh_gpu_instancing", Type::object, 0, kInstancing}};
constexpr std::array kNode{Field{"name", Type::text},
                           Field{"mesh", Type::whole},
                           Field{"skin", Type::whole},
                           Field{"camera", Type::whole},
                           Field{"children", Type::wholes},
                           Field{"matrix", Type::numbers, 16},
                           Field{"translation", Type::numbers, 3},
                           Field{"rotation", Type::numbers, 4},
                           Field{"scale", Type::numbers, 3},
                           Field{"weights", Type::numbers},
                           Field{"extensions", Type::object, 0, kNodeExtensions}};
constexpr std::array kScene{Field{"name", Type::text}, Field{"nodes", Type::wholes}};
constexpr std::array kPerspective{Field{"yfov", Type::number}, Field{"znear", Type::number}};
constexpr std::array kOrthographic{Field{"ymag", Type::number}};
constexpr std::array kCamera{Field{"name", Type::text}, Field{"type", Type::text},
                             Field{"perspective", Type::object, 0, kPerspective},
                             Field{"orthographic", Type::object, 0, kOrthographic}};
constexpr std::array kSkin{Field{"joints", Type::wholes}, Field{"inverseBindMatrices", Type::whole}};
constexpr std::array kTargetOfChannel{Field{"node", Type::whole}, Field{"path", Type::text}};
constexpr std::array kChannel{Field{"sampler", Type::whole}, Field{"target", Type::object, 0, kTargetOfChannel}};
constexpr std::array kCurve{Field{"input", Type::whole}, Field{"output", Type::whole},
                            Field{"interpolation", Type::text}};
constexpr std::array kAnimation{Field{"name", Type::text}, Field{"channels", Type::objects, 0, kChannel},
                                Field{"samplers", Type::objects, 0, kCurve}};
constexpr std::array kSpot{Field{"innerConeAngle", Type::number}, Field{"outerConeAngle", Type::number}};
constexpr std::array kLight{Field{"type", Type::text}, Field{"color", Type::numbers, 3},
                            Field{"intensity", Type::number}, Field{"range", Type::number},
                            Field{"spot", Type::object, 0, kSpot}};
constexpr std::array kLights{Field{"lights", Type::objects, 0, kLight}};
constexpr std::array kExtensions{Field{"KHR_lights_punctual", Type::object, 0, kLights}};
constexpr std::array kRoot{Field{"scene", Type::whole},
                           Field{"scenes", Type::objects, 0, kScene},
                           Field{"nodes", Type::objects, 0, kNode},
                           Field{"meshes", Type::objects, 0, kMesh},
                           Field{"materials", Type::objects, 0, kMaterial},
                           Field{"textures", Type::objects, 0, kTexture},
                           Field{"images", Type::objects, 0, kImage},
                           Field{"samplers", Type::objects, 0, kSampler},
                           Field{"accessors", Type::objects, 0, kAccessor},
                           Field{"bufferViews", Type::objects, 0, kView},
                           Field{"buffers", Type::objects, 0, kBuffer},
                           Field{"cameras", Type::objects, 0, kCamera},
                           Field{"skins", Type::objects, 0, kSkin},
                           Field{"animations", Type::objects, 0, kAnimation},
                           Field{"extensionsUsed", Type::texts},
                           Field{"extensionsRequired", Type::texts},
                           Field{"extensions", Type::object, 0, kExtensions}};

bool is_whole(const GltfJson& json) { return to_index(json).has_value(); }
bool is_text(const GltfJson& json) { return json.is_string(); }
bool is_number(const GltfJson& json) { return json.is_number(); }

template <class Test>
bool is_array_of(const GltfJson& json, std::size_t count, const Test& test) {
  if (!json.is_array() || (count != 0 && json.size() != count)) return false;
  for (const GltfJson& element : json) {
    if (!test(element)) return false;
  }
  return true;
}

bool is_map(const GltfJson& json) {
  if (!json.is_object()) return false;
  for (const GltfJson& value : json) {
    if (!is_whole(value)) return false;
  }
  return true;
}

/// Checks the type, except inside objects.
bool fits(const GltfJson& json, const Field& field) {
  switch (field.type) {
    case Type::whole: return is_whole(json);
    case Type::number: return json.is_number();
    case Type::text: return json.is_string();
    case Type::flag: return json.is_boolean();
    case Type::wholes: return is_array_of(json, field.count, is_whole);
    case Type::numbers: return is_array_of(json, field.count, is_number);
    case Type::texts: return is_array_of(json, field.count, is_text);
    case Type::object: return json.is_object();
    case Type::objects: return is_array_of(json, 0, [](const GltfJson& each) { return each.is_object(); });
    case Type::map: return is_map(json);
  }
  return false;
}

/// Checks as deep as the tables above. Returns the place of the first member with a wrong type, or an empty text.
std::string misfit_in(const GltfJson& object, std::span<const Field> fields) {
  for (const Field& field : fields) {
    const auto at = object.find(field.key);
    if (at == object.end()) continue;
    if (!fits(*at, field)) return std::string(field.key);
    if (field.type == Type::object) {
      if (const std::string inside = misfit_in(*at, field.members); !inside.empty()) {
        return fmt::format("{}.{}", field.key, inside);
      }
    }
    if (field.type != Type::objects) continue;
    for (std::size_t i = 0; i < at->size(); ++i) {
      const std::string inside = misfit_in((*at)[i], field.members);
      if (!inside.empty()) return fmt::format("{}[{}].{}", field.key, i, inside);
    }
  }
  return {};
}

}  // namespace

Result<Done> check_gltf_types(const GltfJson& json) {
  const std::string misfit = misfit_in(json, kRoot);
  if (misfit.empty()) return Done{};
  return gltf_damaged(fmt::format("{} is not of the type that it should have", printable(misfit)));
}

}  // namespace zstrip::sim
