// The reader of glTF 2.0: buffers, accessors, nodes and names as the file has them, and files that are damaged.
#include <meshoptimizer.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <set>

#include "gltf_file.hpp"
#include "import/model.hpp"
#include "import/read_model.hpp"
#include "support.hpp"

namespace zstrip::sim::test {
namespace {

const std::vector<float> kCorners{0, 0, 0, 4, 0, 0, 0, 2, 0};

class GltfReader : public FolderTest {
 protected:
  SourceModel source(const std::string& name, const std::string& content) const {
    Result<SourceModel> read = read_model(file(name, content), UpAxis::plus_y);
    EXPECT_TRUE(read) << read.failure().message;
    return read ? std::move(*read) : SourceModel();
  }
  std::string failure(const std::string& content) const {
    const Result<SourceModel> read = read_model(file("bad.gltf", content), UpAxis::plus_y);
    EXPECT_FALSE(read);
    return read ? "" : read.failure().message;
  }
  /// A triangle of `attributes` on one node.
  static std::string triangle(const GltfData& data, const std::string& attributes, const std::string& more = "") {
    return gltf_of(R"("nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{)" + attributes + "}" + more +
                   "}]}]," + data.json());
  }
  static std::set<std::array<float, 3>> places(const SourceModel& model) {
    std::set<std::array<float, 3>> found;
    for (const SourceMesh& mesh : model.meshes) {
      for (const std::uint32_t index : mesh.indices) found.insert(mesh.vertices[index].position);
    }
    return found;
  }
};

const std::set<std::array<float, 3>> kTriangle{{0, 0, 0}, {4, 0, 0}, {0, 2, 0}};

TEST_F(GltfReader, BuffersInTheFileBesideItAndInItsText) {
  GltfData data;
  data.add_floats(kCorners, "VEC3");
  const auto with = [&](const std::string& uri) {
    return gltf_of(R"("nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],)" +
                   data.json(uri));
  };
  EXPECT_EQ(places(source("own.gltf", triangle(data, R"("POSITION":0)"))), kTriangle);
  file("two words.bin", data.bytes());
  EXPECT_EQ(places(source("beside.gltf", with(R"(,"uri":"two%20words.bin")"))), kTriangle);
  EXPECT_EQ(places(source("one.glb", glb_of(with(""), data.bytes()))), kTriangle);
  EXPECT_NE(failure(with(R"(,"uri":"gone.bin")")).find("buffer 0 'gone.bin' does not exist"), std::string::npos);
}

/// A file was refused if exporters had left a root of its scene below another node.
TEST_F(GltfReader, RootsOfTheSceneHaveNoParent) {
  GltfData data;
  data.add_floats(kCorners, "VEC3");
  const std::string below = gltf_of(R"("nodes":[{"mesh":0},{"children":[0],"translation":[9,0,0]}],)"
                                    R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],)" +
                                    data.json());
  EXPECT_EQ(places(source("below.gltf", below)), kTriangle);
  const std::string roots = R"("nodes":[0])";
  for (const char* more : {R"("nodes":[1,0])", R"("nodes":[0,1,0])"}) {
    std::string listed = below;
    const SourceModel both = source("listed.gltf", listed.replace(listed.find(roots), roots.size(), more));
    EXPECT_EQ(both.meshes.size(), 1U) << "drawn once";
    EXPECT_EQ(places(both), kTriangle);
  }
}

TEST_F(GltfReader, InterleavedNormalisedAndSparse) {
  // Two unsigned bytes and two of padding, then three shorts and two bytes of padding: 12 bytes a vertex.
  std::string bytes;
  for (const auto& [u, v, x, y] : std::vector<std::array<int, 4>>{{0, 0, 0, 0}, {255, 0, 4, 0}, {0, 51, 0, 2}}) {
    bytes += {static_cast<char>(u), static_cast<char>(v), 0, 0};
    bytes += {static_cast<char>(x), 0, static_cast<char>(y), 0, 0, 0, 0, 0};
  }
  GltfData data;
  data.add(bytes, R"("componentType":5121,"normalized":true,"count":3,"type":"VEC2")", R"(,"byteStride":12)");
  GltfData sparse = data;
  data.add(bytes, R"("byteOffset":4,"componentType":5122,"count":3,"type":"VEC3")", R"(,"byteStride":12)");
  Result<SourceModel> read =
      read_model(file("packed.gltf", triangle(data, R"("POSITION":1,"TEXCOORD_0":0)")), UpAxis::plus_y, Texcoords::all);
  ASSERT_TRUE(read) << read.failure().message;
  EXPECT_EQ(places(*read), kTriangle);
  ASSERT_TRUE(read->meshes[0].has_texcoords);
  EXPECT_EQ(read->meshes[0].vertices[1].texcoord, (std::array<float, 2>{1, 0}));
  EXPECT_NEAR(read->meshes[0].vertices[2].texcoord[1], 0.2F, 1e-6F);
  // Of three corners at the origin two are moved.
  const std::size_t values = sparse.add_floats({4, 0, 0, 0, 2, 0}, "VEC3");
  const std::size_t indices = sparse.add_indices({1, 2});
  const std::string text =
      gltf_of(R"("nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":3}}]}],)" + sparse.json());
  const std::string accessor = R"(,{"componentType":5126,"count":3,"type":"VEC3","sparse":{"count":2,"indices":{)"
                               R"("bufferView":)" +
                               std::to_string(indices) + R"(,"componentType":5123},"values":{"bufferView":)" +
                               std::to_string(values) + "}}}";
  std::string whole = text;
  whole.insert(whole.find(R"(],"bufferViews")"), accessor);
  EXPECT_EQ(places(source("sparse.gltf", whole)), kTriangle);
}

TEST_F(GltfReader, StripsAndFansKeepTheirWinding) {
  const std::vector<float> corners{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};
  for (const auto& [mode, indices] : std::vector<std::pair<std::string, std::vector<std::uint16_t>>>{
           {"5", {0, 1, 2, 3}}, {"6", {0, 1, 3, 2}}, {"4", {0, 1, 2, 2, 1, 3}}}) {
    GltfData data;
    data.add_floats(corners, "VEC3");
    data.add_indices(indices);
    const SourceModel model = source("m.gltf", triangle(data, R"("POSITION":0)", R"(,"indices":1,"mode":)" + mode));
    ASSERT_EQ(model.meshes.size(), 1U);
    const SourceMesh& mesh = model.meshes[0];
    ASSERT_EQ(mesh.indices.size(), 6U);
    for (std::size_t i = 0; i < 6; i += 3) {
      const auto& a = mesh.vertices[mesh.indices[i]].position;
      const auto& b = mesh.vertices[mesh.indices[i + 1]].position;
      const auto& c = mesh.vertices[mesh.indices[i + 2]].position;
      EXPECT_GT((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]), 0) << mode << " " << i;
    }
  }
}

TEST_F(GltfReader, NodesMoveTurnAndMirror) {
  GltfData data;
  data.add_floats(kCorners, "VEC3");
  const std::string text = gltf_of(R"("nodes":[{"translation":[1,0,0],"children":[1]},{"mesh":0,"scale":[-1,1,1]}],)"
                                   R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],)" +
                                   data.json());
  const SourceModel model = source("m.gltf", text);
  EXPECT_EQ(places(model), (std::set<std::array<float, 3>>{{1, 0, 0}, {-3, 0, 0}, {1, 2, 0}}));
  const SourceMesh& mesh = model.meshes[0];
  EXPECT_EQ(mesh.vertices[mesh.indices[1]].position, (std::array<float, 3>{1, 2, 0})) << "its outside is kept";
}

/// Only the last of them was lit.
TEST_F(GltfReader, ALightThatTwoNodesHave) {
  const SourceModel model = source(
      "m.gltf",
      GltfFile{.materials = {"{}"},
               .nodes = {R"({"mesh":0})", R"({"translation":[0,0,2],"extensions":{"KHR_lights_punctual":{"light":0}}})",
                         R"({"translation":[0,3,0],"extensions":{"KHR_lights_punctual":{"light":0}}})"},
               .lights = R"({"type":"point"})"}
          .text());
  ASSERT_EQ(model.lights.size(), 2U);
  EXPECT_EQ(model.lights[0].position, (std::array<double, 3>{0, 0, 2}));
  EXPECT_EQ(model.lights[1].position, (std::array<double, 3>{0, 3, 0}));
}

TEST_F(GltfReader, CamerasHaveTheirOwnNameToo) {
  GltfData data;
  data.add_floats(kCorners, "VEC3");
  const SourceModel model =
      source("m.gltf", gltf_of(R"("nodes":[{"mesh":0,"children":[1,2]},{"name":"hall","camera":0},{"camera":1}],)"
                               R"("cameras":[{"name":"wide","type":"perspective","perspective":{"yfov":1}},)"
                               R"({"name":"plan","type":"orthographic","orthographic":{"ymag":2}}],)"
                               R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],)" +
                               data.json()));
  ASSERT_EQ(model.cameras.size(), 2U);
  EXPECT_EQ(model.cameras[0].name, "hall");
  EXPECT_EQ(model.cameras[0].other_name, "wide");
  EXPECT_EQ(model.cameras[1].name, "plan");
}

/// Animated or not, weights of the file's own shape it.
TEST_F(GltfReader, MorphTargetsAtRest) {
  GltfData data;
  data.add_floats({0, 0, 0, 2, 0, 0, 0, 1, 0}, "VEC3");
  data.add_floats({0, 0, 0, 4, 0, 0, 0, 2, 0}, "VEC3");
  const SourceModel model = source(
      "m.gltf", gltf_of(R"("nodes":[{"mesh":0}],"meshes":[{"weights":[0.5],"primitives":[{"attributes":{"POSITION":0},)"
                        R"("targets":[{"POSITION":1}]}]}],)" +
                        data.json()));
  EXPECT_EQ(places(model), kTriangle);
}

TEST_F(GltfReader, ExtensionsThatAreRequired) {
  GltfData data;
  data.add_floats(kCorners, "VEC3");
  const std::string text = triangle(data, R"("POSITION":0)");
  const auto with = [&](const std::string& members) { return "{" + members + "," + text.substr(1); };
  EXPECT_NE(failure(with(R"("extensionsRequired":["ACME_fur"])")).find("ACME_fur"), std::string::npos);
  const SourceModel model =
      source("m.gltf", with(R"("extensionsUsed":["ACME_fur","KHR_materials_transmission","KHR_materials_unlit"])"));
  ASSERT_EQ(model.warnings.size(), 1U);
  EXPECT_EQ(model.warnings[0],
            "drawn without: ACME_fur (not known), KHR_materials_transmission (light through surfaces)");
}

/// Models lost their normal maps, and coats that the file did not list, without a word.
TEST_F(GltfReader, MapsAndCoatsThatAreNotDrawnAreNamedOnce) {
  GltfData data;
  data.add_floats(kCorners, "VEC3");
  const std::string text = triangle(data, R"("POSITION":0)");
  const auto warnings = [&](const std::string& materials) {
    return source("m.gltf", R"({"materials":[)" + materials + "]," + text.substr(1)).warnings;
  };
  const std::string bumpy = R"({"normalTexture":{"index":0},"occlusionTexture":{"index":0}})";
  const std::string coated = R"({"extensions":{"KHR_materials_clearcoat":{"clearcoatFactor":1}}})";
  const std::string unlit = R"({"normalTexture":{"index":0},"extensions":{"KHR_materials_unlit":{}}})";
  EXPECT_EQ(
      warnings(bumpy + "," + coated + "," + bumpy),
      (std::vector<std::string>{"drawn without: KHR_materials_clearcoat (coats of varnish)",
                                "2 materials drawn without normal maps", "2 materials drawn without occlusion maps"}));
  EXPECT_EQ(warnings(unlit), std::vector<std::string>{}) << "its normals light nothing";
}

TEST_F(GltfReader, DamageIsNamed) {
  GltfData data;
  data.add_floats(kCorners, "VEC3");
  data.add_indices({0, 1, 2});
  const std::string good = triangle(data, R"("POSITION":0)", R"(,"indices":1)");
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
  };
  for (const auto& [from, to, mention] : std::vector<std::array<std::string, 3>>{
           {R"("count":3)", R"("count":4)", "accessor 0 reaches beyond its buffer view"},
           {R"("count":3)", R"("count":3,"byteOffset":18446744073709551615)", "accessor 0 reaches beyond"},
           {R"("count":3)", R"("count":4000000000)", "accessor 0 has too many elements"},
           {R"("bufferView":0,"componentType":5126,"count":3)", R"("componentType":5126,"count":1333334)",
            "accessor 0 has too many elements without a buffer view"},
           {R"("componentType":5126)", R"("componentType":5124)", "accessor 0 is missing or damaged"},
           {R"("type":"VEC3")", R"("type":"VEC2")", "accessor 0 does not fit POSITION"},
           {R"("bufferView":0)", R"("bufferView":7)", "there is no buffer view 7"},
           {R"("buffer":0)", R"("buffer":1)", "there is no buffer 1"},
           {R"("byteLength":36)", R"("byteLength":99)", "buffer view 0 reaches beyond its buffer"},
           {R"("byteLength":42)", R"("byteLength":43)", "its buffer 0 has fewer bytes than it says"},
           {R"("indices":1)", R"("indices":9)", "accessor 9 is missing or damaged"},
           {R"("indices":1)", R"("indices":0)", "accessor 0 has no unsigned integers"},
           {R"("mesh":0)", R"("mesh":1)", "there is no mesh 1"},
           {R"({"mesh":0})", R"({"mesh":0,"children":[0]})", "node 0 is its own child"},
           {R"({"mesh":0})", R"({"mesh":0,"children":[1,1]},{})", "node 0 has the child 1 twice"},
           {R"({"mesh":0})", R"({"mesh":0,"children":[1]},{"children":[2]},{"children":[0]})", "is its own ancestor"},
           {R"({"mesh":0})", R"({"mesh":0},{"children":[2]},{"children":[1]})", "node 1 is its own ancestor"},
           {R"({"mesh":0})", R"({"mesh":0,"children":[5]})", "node 0 has a child that does not exist"},
           {R"("nodes":[0])", R"("nodes":[3])", "its scene has a node that does not exist"},
           {";base64,", ";base64,!", "its buffer 0 has a damaged data URI"},
           {R"("version":"2.0")", R"("version":"3.0")", "version of glTF that is not known"},
           {R"("version":"2.0")", R"("generator":"x")", "asset.version is missing"}}) {
    EXPECT_NE(failure(changed(from, to)).find(mention), std::string::npos) << to << ": " << failure(changed(from, to));
  }
}

/// It was drawn without a word.
TEST_F(GltfReader, DamageThatLeavesAPictureIsAWarning) {
  GltfData data;
  data.add_floats(kCorners, "VEC3");
  const std::string good = triangle(data, R"("POSITION":0)"), node = R"({"mesh":0})";
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    return text.replace(text.find(from), from.size(), to);
  };
  const std::string primitive = R"("attributes":{"POSITION":0})";
  EXPECT_TRUE(source("good.gltf", good).warnings.empty());
  for (const auto& [text, warning] : std::vector<std::pair<std::string, std::string>>{
           {with(R"("scene":0)", R"("scene":5)"), "scene 5 does not exist: the first one is drawn"},
           {with(node, R"({"mesh":0,"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],"translation":[9,0,0]})"),
            "1 node drawn by the matrix alone: translation, rotation and scale next to it are left out"},
           {with(primitive, primitive + R"(,"material":7)"),
            "1 part of meshes drawn without material: theirs does not exist"},
           {with(R"("meshes")", R"("materials":[{"name":"leaf","alphaMode":"Blend"}],"meshes")"),
            "material 'leaf' drawn opaque: its alphaMode 'Blend' is not OPAQUE, MASK or BLEND"},
           {with(R"("meshes")", R"("textures":[{"sampler":0}],"meshes")"),
            "1 texture repeated: the sampler does not exist"},
           {with(R"("meshes")", R"("samplers":[{"wrapS":10497,"wrapT":1}],"meshes")"),
            "1 sampler taken as repeating: the wrap does not exist"},
           {with(R"("meshes")", R"("animations":[{"channels":[{"target":{"node":0,"path":"Scale"}}]}],"meshes")"),
            "1 channel of animations left out: the path does not exist"},
           {with(node, R"({"mesh":0,"camera":0})"),
            "1 camera left out: neither perspective nor orthographic, or not in the file"}}) {
    const SourceModel model = source("damaged.gltf", text);
    EXPECT_EQ(places(model), kTriangle) << warning;
    EXPECT_EQ(model.warnings, std::vector{warning});
    EXPECT_TRUE(model.cameras.empty());
  }
}

TEST_F(GltfReader, WrongLengthsOfAGlbAreSaid) {
  GltfData data;
  data.add_floats(kCorners, "VEC3");
  const std::string json =
      gltf_of(R"("nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],)" + data.json(""));
  const std::string whole = glb_of(json, data.bytes());
  EXPECT_TRUE(source("whole.glb", whole).warnings.empty());
  EXPECT_TRUE(source("behind.glb", whole + "12345").warnings.empty()) << "bytes behind the last chunk do no harm";
  for (const int change : {-40, -4, 4, 100}) {
    std::string wrong = whole;
    const std::size_t length = whole.size() + static_cast<std::size_t>(change);
    for (std::size_t i = 0; i < 4; ++i) wrong[8 + i] = static_cast<char>(length >> 8 * i);
    const SourceModel model = source("wrong.glb", wrong);
    EXPECT_EQ(places(model), kTriangle);
    ASSERT_EQ(model.warnings.size(), 1U) << change;
    EXPECT_EQ(model.warnings[0], "the header of the .glb says " + std::to_string(length) + " bytes, and the file has " +
                                     std::to_string(whole.size()) + "; export it again");
  }
}

TEST_F(GltfReader, WhatIsOfAnotherTypeIsNamed) {
  GltfData data;
  data.add_floats(kCorners, "VEC3");
  const std::string text = triangle(data, R"("POSITION":0)");
  const auto with = [&](const std::string& members) { return failure("{" + members + "," + text.substr(1)); };
  EXPECT_NE(with(R"("materials":[{},{"pbrMetallicRoughness":{"baseColorTexture":{"index":"0"}}}])")
                .find("materials[1].pbrMetallicRoughness.baseColorTexture.index is not of the type"),
            std::string::npos);
  EXPECT_NE(with(R"("cameras":[{"name":7}])").find("cameras[0].name"), std::string::npos);
  EXPECT_NE(with(R"("skins":{})").find("skins"), std::string::npos);
  EXPECT_NE(with(R"("materials":[{"emissiveFactor":[1,1]}])").find("emissiveFactor"), std::string::npos);
  EXPECT_NE(with(R"("samplers":[{"wrapS":-1}])").find("samplers[0].wrapS"), std::string::npos);
}

TEST_F(GltfReader, ViewsThatAreCompressed) {
  const auto extension_of = [](const GltfData& data, const std::string& bytes, const std::string& what) {
    return R"(,"extensions":{"EXT_meshopt_compression":{"buffer":0,"byteOffset":)" +
           std::to_string((data.bytes().size() + 3) / 4 * 4) + R"(,"byteLength":)" + std::to_string(bytes.size()) +
           "," + what + "}}";
  };
  std::vector<unsigned char> vertices(meshopt_encodeVertexBufferBound(3, 12));
  vertices.resize(meshopt_encodeVertexBuffer(vertices.data(), vertices.size(), kCorners.data(), 3, 12));
  const std::vector<unsigned> corners{0, 1, 2};
  std::vector<unsigned char> indices(meshopt_encodeIndexBufferBound(3, 3));
  indices.resize(meshopt_encodeIndexBuffer(indices.data(), indices.size(), corners.data(), 3));
  const std::string packed(vertices.begin(), vertices.end()), order(indices.begin(), indices.end());
  GltfData data;
  data.add(packed, R"("componentType":5126,"count":3,"type":"VEC3")",
           extension_of(data, packed, R"("byteStride":12,"count":3,"mode":"ATTRIBUTES")"));
  data.add(order, R"("componentType":5123,"count":3,"type":"SCALAR")",
           extension_of(data, order, R"("byteStride":2,"count":3,"mode":"TRIANGLES")"));
  const std::string text = triangle(data, R"("POSITION":0)", R"(,"indices":1)");
  EXPECT_EQ(places(source("m.gltf", text)), kTriangle);
  for (const auto& [from, to] : std::vector<std::array<std::string, 2>>{
           {R"("byteStride":12)", R"("byteStride":10)"},
           {R"("byteStride":12)", R"("byteStride":256)"},
           {R"("count":3,"mode")", R"("count":4000000000,"mode")"},
           {R"("mode":"ATTRIBUTES")", R"("mode":"ATTRIBUTES","filter":"OCTAHEDRAL")"},
           {R"("mode":"ATTRIBUTES")", R"("mode":"TRIANGLES")"}}) {
    std::string damaged = text;
    damaged.replace(damaged.find(from), from.size(), to);
    EXPECT_NE(failure(damaged).find("a compressed view"), std::string::npos) << to;
  }
}

/// A hostile file must neither crash nor take what does not belong to it; sanitizers look on.
TEST_F(GltfReader, TruncatedAndMutatedFiles) {
  GltfData data;
  data.add_floats(kCorners, "VEC3");
  data.add_indices({0, 1, 2});
  data.add_floats({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}, "MAT4");
  data.add(std::string(12, '\0'), R"("componentType":5121,"count":3,"type":"VEC4")");
  data.add_floats({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, "VEC4");
  data.add_floats({0, 1}, "SCALAR");
  data.add_floats({0, 0, 0, 1, 1, 1}, "VEC3");
  const std::string json = gltf_of(
      R"("nodes":[{"mesh":0,"skin":0,"children":[1]},{"translation":[1,0,0]}],"skins":[{"joints":[1],)"
      R"("inverseBindMatrices":2}],"animations":[{"channels":[{"sampler":0,"target":{"node":1,"path":"translation"}}],)"
      R"("samplers":[{"input":5,"output":6}]}],"meshes":[{"primitives":[{"attributes":{"POSITION":0,"JOINTS_0":3,)"
      R"("WEIGHTS_0":4},"indices":1}]}],)" +
      data.json(""));
  const std::string whole = glb_of(json, data.bytes());
  ASSERT_TRUE(import_model(file("whole.glb", whole)));
  for (std::size_t length = 0; length + 4 < whole.size(); length += 7) {
    EXPECT_FALSE(import_model(file("cut.glb", whole.substr(0, length)))) << length;
  }
  std::uint32_t state = 1;
  const auto random = [&state](std::size_t below) {
    state = state * 1664525 + 1013904223;
    return (state >> 8) % below;
  };
  for (int i = 0; i < 1500; ++i) {
    std::string mutated = whole;
    for (std::size_t k = 0; k <= random(3); ++k) {
      const std::size_t at = random(mutated.size());
      // Digits for digits, so that the text often stays JSON.
      const bool digit = mutated[at] >= '0' && mutated[at] <= '9';
      mutated[at] = static_cast<char>(digit ? '0' + random(10) : random(256));
    }
    const Result<Model> read = import_model(file("mutated.glb", mutated));
    if (read) continue;
    EXPECT_EQ(read.failure().message.find('\n'), std::string::npos) << read.failure().message;
  }
}

}  // namespace
}  // namespace zstrip::sim::test
