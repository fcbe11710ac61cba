// glTF 2.0 as other programs write it: hidden nodes, copies, nodes without size, places far away, odd URIs.
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "gltf_file.hpp"
#include "import/quantise.hpp"
#include "import_fixture.hpp"
#include "render/stage.hpp"

namespace zstrip::sim::test {
namespace {

const std::string kSquare = R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],)";

/// The accessors of a square of side 2 around the origin, and behind them others.
GltfData square_and() {
  GltfData data;
  data.add_floats({-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0}, "VEC3");
  data.add_indices({0, 1, 2, 0, 2, 3});
  return data;
}

std::string file_of(const std::string& nodes, const GltfData& data, const std::string& roots = "0",
                    const std::string& members = "") {
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[)" + roots + R"(]}],"nodes":[)" + nodes + "]," +
         members + kSquare + data.json() + "}";
}

class GltfWild : public Import {
 protected:
  std::size_t count_of(const std::string& content) const { return triangles(model(file("m.gltf", content))).size(); }
};

TEST_F(GltfWild, NodesBelowAHiddenOneAreHidden) {
  const std::string hides = R"("extensions":{"KHR_node_visibility":{"visible":false}})";
  const std::string shows = R"("extensions":{"KHR_node_visibility":{"visible":true}})";
  const GltfData data = square_and();
  const std::string apart = R"(,{"mesh":0,"translation":[5,0,0]})";
  EXPECT_EQ(count_of(file_of(R"({"children":[1],)" + hides + R"(},{"mesh":0,)" + shows + "}" + apart, data, "0,2")),
            2U);
  EXPECT_EQ(count_of(file_of(R"({"children":[1],)" + shows + R"(},{"mesh":0})" + apart, data, "0,2")), 4U);
  EXPECT_EQ(count_of(file_of(R"({"mesh":0,"extensions":{"KHR_node_visibility":{}}})" + apart, data, "0,1")), 4U);
  EXPECT_NE(failure(file("none.gltf", file_of(R"({"mesh":0,)" + hides + "}", data))).find("KHR_node_visibility hides"),
            std::string::npos);
}

TEST_F(GltfWild, CopiesAreTurnedScaledAndMovedOnTheirNode) {
  GltfData data = square_and();
  const std::size_t moves = data.add_floats({0, 0, 0, 10, 0, 0}, "VEC3");
  const float half = std::sqrt(0.5F);
  const std::size_t turns = data.add_floats({0, 0, 0, 1, half, 0, 0, half}, "VEC4");
  const std::size_t scales = data.add_floats({1, 1, 1, 2, 3, 1}, "VEC3");
  const auto attribute = [](const char* name, std::size_t accessor) {
    return std::string("\"") + name + "\":" + std::to_string(accessor);
  };
  const Model copies = model(file(
      "c.gltf", file_of(R"({"mesh":0,"translation":[0,1,0],"extensions":{"EXT_mesh_gpu_instancing":{"attributes":{)" +
                            attribute("TRANSLATION", moves) + "," + attribute("ROTATION", turns) + "," +
                            attribute("SCALE", scales) + "," + attribute("_ID", 1) + "}}}}",
                        data, "0", R"("extensionsRequired":["EXT_mesh_gpu_instancing"],)")));
  // The second copy stands upright in z: x 8 to 12, y 1, z -3 to 3.
  const Model expected = model(file("e.obj",
                                    "v -1 0 0\nv 1 0 0\nv 1 2 0\nv -1 2 0\nv 8 1 -3\nv 12 1 -3\nv 12 1 3\nv 8 1 3\n"
                                    "f 1 2 3\nf 1 3 4\nf 5 6 7\nf 5 7 8\n"));
  EXPECT_EQ(triangles(copies), triangles(expected));
  EXPECT_TRUE(copies.warnings.empty());
}

TEST_F(GltfWild, CopiesOfDifferentNumbersAreRefused) {
  GltfData data = square_and();
  data.add_floats({0, 0, 0, 10, 0, 0}, "VEC3");
  data.add_floats({1, 1, 1}, "VEC3");
  const std::string attributes = R"({"TRANSLATION":2,"SCALE":3})";
  EXPECT_NE(failure(file("c.gltf", file_of(R"({"mesh":0,"extensions":{"EXT_mesh_gpu_instancing":{"attributes":)" +
                                               attributes + "}}}",
                                           data)))
                .find("SCALE of EXT_mesh_gpu_instancing does not fit"),
            std::string::npos);
}

/// Gigabytes of places were written before the first copy was drawn.
TEST_F(GltfWild, MoreCopiesThanTrianglesAreRefused) {
  constexpr std::size_t kCopies = 10'000'001;
  const GltfData data = square_and();
  std::string content =
      file_of(R"({"mesh":0,"extensions":{"EXT_mesh_gpu_instancing":{"attributes":{"SCALE":2}}}})", data);
  const auto insert = [&](const std::string& before, const std::string& member) {
    content.insert(content.find(before), "," + member);
  };
  const std::string bytes = std::to_string(3 * kCopies);
  insert(R"(],"bufferViews")",
         R"({"bufferView":2,"componentType":5120,"count":)" + std::to_string(kCopies) + R"(,"type":"VEC3"})");
  insert(R"(],"buffers")", R"({"buffer":1,"byteLength":)" + bytes + "}");
  content.insert(content.rfind(']'), R"(,{"byteLength":)" + bytes + R"(,"uri":"scales.bin"})");
  std::filesystem::resize_file(file("scales.bin", ""), 3 * kCopies);
  const std::string said = failure(file("c.gltf", content));
  EXPECT_NE(said.find("EXT_mesh_gpu_instancing has more than 10,000,000 copies"), std::string::npos) << said;
}

TEST_F(GltfWild, LinesOfADataUriMayBreak) {
  GltfData data = square_and();
  const std::string bytes = base64(data.bytes());
  const auto with = [&](const std::string& gap) {
    return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],)" + kSquare +
           data.json(R"(,"uri":"data:application/octet-stream;base64,)" + bytes.substr(0, 7) + gap + bytes.substr(7) +
                     gap + "\"") +
           "}";
  };
  for (const char* gap : {"", "\\n", "\\r\\n", " ", "\\t", "%0A", "%0D%0A"}) EXPECT_EQ(count_of(with(gap)), 2U) << gap;
}

/// The square at (0, 0, 0) of `rest` is animated to grow to `grown`, and another one stands at x 10.
std::string growing(const std::string& rest, float grown, const std::string& more_nodes = "") {
  GltfData data = square_and();
  const std::size_t times = data.add_floats({0, 1}, "SCALAR");
  const std::size_t scales = data.add_floats({0, 0, 0, grown, grown, grown}, "VEC3");
  return file_of("{\"mesh\":0," + rest + R"(},{"mesh":0,"translation":[10,0,0]})" + more_nodes, data, "0,1",
                 R"("animations":[{"name":"grow","channels":[{"sampler":0,"target":{"node":0,"path":"scale"}}],)"
                 R"("samplers":[{"input":)" +
                     std::to_string(times) + R"(,"output":)" + std::to_string(scales) + "}]}],");
}

TEST_F(GltfWild, NodesOfNoSizeAtRestAreStoredAsTheyGrow) {
  for (const char* rest : {R"("scale":[0,0,0])", R"("scale":[1e-6,1e-6,1e-6])", R"("scale":[1,1,0])"}) {
    const Result<std::unique_ptr<Stage>> stage = open_stage(file("g.gltf", growing(rest, 2)), {}, {}, {64, 64}, 4);
    ASSERT_TRUE(stage) << stage.failure().message;
    const Model& read = *(*stage)->model();
    EXPECT_TRUE(read.warnings.empty());
    ASSERT_EQ(read.instances.size(), 2U);
    for (std::uint32_t frame = 0; frame < 4; ++frame) {
      const Result<Staging> staging = (*stage)->place(frame, 4);
      ASSERT_TRUE(staging);
      // Stored twice as large as the square; half of that at half of the time.
      EXPECT_NEAR(from_fixed(staging->scene.instances[0].transform.m[2][2]), frame / 4.0, 0.01) << rest;
      EXPECT_NEAR(from_fixed(staging->scene.instances[1].transform.m[0][0]), 1, 1e-4);
    }
  }
}

TEST_F(GltfWild, NodesThatNeverGrowLeaveTheOthersMoving) {
  GltfData data = square_and();
  const std::size_t times = data.add_floats({0, 1}, "SCALAR");
  const std::size_t moves = data.add_floats({0, 0, 0, 4, 0, 0}, "VEC3");
  const auto channel = [&](int node) {
    return R"({"sampler":0,"target":{"node":)" + std::to_string(node) + R"(,"path":"translation"}})";
  };
  const std::string content = file_of(R"({"scale":[0,0,0],"children":[2]},{"mesh":0},{"mesh":0})", data, "0,1",
                                      R"("animations":[{"channels":[)" + channel(0) + "," + channel(1) + "," +
                                          channel(2) + R"(],"samplers":[{"input":)" + std::to_string(times) +
                                          R"(,"output":)" + std::to_string(moves) + "}]}],");
  const Result<std::unique_ptr<Stage>> stage = open_stage(file("n.gltf", content), {}, {}, {64, 64}, 4);
  ASSERT_TRUE(stage) << stage.failure().message;
  EXPECT_TRUE((*stage)->model()->warnings.empty());
  const Result<Staging> staging = (*stage)->place(2, 4);
  ASSERT_TRUE(staging);
  double farthest = 0;
  for (const Instance& instance : staging->scene.instances) {
    farthest = std::max(farthest, from_fixed(instance.transform.m[0][3]) / (*stage)->model()->units.scale);
  }
  EXPECT_NEAR(farthest, 2, 0.01);
}

TEST_F(GltfWild, PlacesFarAwayKeepTheDetailsOfAModel) {
  const GltfData data = square_and();
  const auto squares = [&](const std::string& place) {
    return model(file("f.gltf", file_of(R"({"translation":)" + place +
                                            R"(,"children":[1,2]},{"mesh":0},{"mesh":0,"translation":[0.125,3,0.5]})",
                                        data)));
  };
  const Model near = squares("[0,0,0]");
  for (const char* place : {"[40000000,-7000000,123456]", "[4e9,0,0]"}) {
    const Model far = squares(place);
    EXPECT_EQ(triangles(far), triangles(near)) << place;
    EXPECT_NEAR(far.accuracy.position, near.accuracy.position, 1e-6) << place;
  }
}

TEST_F(GltfWild, SpecularAndGlossinessBecomeAColour) {
  const GltfData data = square_and();
  const auto colour = [&](const std::string& extension) {
    const std::string mesh = R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1,"material":0}]}],)";
    return model(file("s.gltf", gltf_of(R"("nodes":[{"mesh":0}],"materials":[{"extensions":{)"
                                        R"("KHR_materials_pbrSpecularGlossiness":)" +
                                        extension + "}}]," + mesh + data.json())))
        .materials[0]
        .colour;
  };
  EXPECT_EQ(colour(R"({"diffuseFactor":[0,0,0,1],"specularFactor":[1,1,0]})"), (Colour{255, 255, 0, 255})) << "metal";
  const Colour plastic = colour(R"({"diffuseFactor":[1,0,0,1],"specularFactor":[0.04,0.04,0.04]})");
  EXPECT_NEAR(plastic.r, 255, 1);
  EXPECT_NEAR(plastic.g, 0, 1);
  EXPECT_EQ(colour(R"({"diffuseFactor":[0,1,0,1]})"), (Colour{0, 255, 0, 255})) << "without a specular colour";
}

}  // namespace
}  // namespace zstrip::sim::test
