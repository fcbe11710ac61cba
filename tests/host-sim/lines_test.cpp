// Lines and points of model files: which vertices they join, and that pictures have them beside triangles and alone.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "gltf_file.hpp"
#include "import/model.hpp"
#include "import/quantise.hpp"
#include "render/render_frame.hpp"
#include "render/stage.hpp"
#include "support.hpp"

namespace zstrip::sim::test {
namespace {

using Ends = std::array<int, 2>;

class ModelLines : public FolderTest {
 protected:
  Model model(const std::string& path) const {
    Result<Model> imported = import_model(path);
    EXPECT_TRUE(imported) << imported.failure().message;
    return imported ? std::move(*imported) : Model();
  }
  /// Corners of a square in the plane z = 0, drawn with a mode of glTF.
  std::string square(int mode, const std::vector<std::uint16_t>& indices,
                     const std::vector<float>& colours = {}) const {
    GltfData data;
    data.add_floats({-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0}, "VEC3");
    data.add_indices(indices);
    if (!colours.empty()) data.add_floats(colours, "VEC3");
    return file("square.gltf",
                gltf_of(fmt::format(R"("nodes":[{{"mesh":0}}],"materials":[{{"pbrMetallicRoughness":)"
                                    R"({{"baseColorFactor":[1,0,0,1]}}}}],"meshes":[{{"primitives":[{{"mode":{},)"
                                    R"("material":0,"indices":1,"attributes":{{"POSITION":0{}}}}}]}}],{})",
                                    mode, colours.empty() ? "" : R"(,"COLOR_0":2)", data.json())));
  }
  /// Which corners of the square each segment joins, by their positions.
  static std::vector<Ends> joined(const Model& model) {
    std::vector<Ends> ends;
    for (const LineSet& lines : model.lines) {
      const Mesh& mesh = model.meshes[lines.mesh];
      const auto corner = [&](std::uint16_t index) {
        const Position& p = mesh.positions[index];
        return p.y < 0 ? (p.x < 0 ? 0 : 1) : (p.x < 0 ? 3 : 2);
      };
      for (const Segment& segment : lines.segments) ends.push_back({corner(segment.a), corner(segment.b)});
    }
    return ends;
  }
  /// How many pixels of the picture are not black, and the colour of one of them.
  struct Seen {
    std::size_t pixels = 0;
    std::uint16_t colour = 0;
  };
  Seen seen(const std::string& path) const {
    const View view{64, 64};
    const auto stage = open_stage(
        path, {}, {.eye = std::array<double, 3>{0, 0, 6}, .look_at = std::array<double, 3>{0, 0, 0}}, view, 1);
    EXPECT_TRUE(stage) << stage.failure().message;
    if (!stage) return {};
    const Result<Staging> staging = (*stage)->place(0, 1);
    FrameRenderer renderer(view, Budget{});
    const auto report = renderer.render(*staging);
    EXPECT_TRUE(report) << report.failure().message;
    Seen seen;
    for (std::size_t i = 0; i < 64 * 64; ++i) {
      const auto byte = [&](std::size_t k) { return std::to_integer<unsigned>(renderer.pixels()[2 * i + k]); };
      const unsigned word = byte(0) | byte(1) << 8;
      if (word == 0) continue;
      ++seen.pixels;
      seen.colour = static_cast<std::uint16_t>(word);
    }
    return seen;
  }
};

TEST_F(ModelLines, EachModeOfGltf) {
  EXPECT_EQ(joined(model(square(0, {2, 0}))), (std::vector<Ends>{{2, 2}, {0, 0}}));
  EXPECT_EQ(joined(model(square(1, {0, 1, 2, 3, 1}))), (std::vector<Ends>{{0, 1}, {2, 3}}));
  EXPECT_EQ(joined(model(square(2, {0, 1, 2}))), (std::vector<Ends>{{0, 1}, {1, 2}, {2, 0}}));
  EXPECT_EQ(joined(model(square(3, {0, 1, 2}))), (std::vector<Ends>{{0, 1}, {1, 2}}));
}

TEST_F(ModelLines, HaveTheColourOfMaterialAndVertices) {
  const Model plain = model(square(2, {0, 1, 2, 3}));
  ASSERT_EQ(plain.lines.size(), 1U);
  EXPECT_EQ(plain.materials[plain.lines[0].material].colour, (Colour{255, 0, 0, 255}));
  EXPECT_TRUE(plain.meshes[plain.lines[0].mesh].colours.empty());
  const Model coloured = model(square(2, {0, 1, 2, 3}, {1, 1, 1, 0, 1, 0, 0, 1, 0, 0, 1, 0}));
  ASSERT_EQ(coloured.lines.size(), 1U);
  EXPECT_EQ(coloured.meshes[coloured.lines[0].mesh].colours[1], (Colour{0, 255, 0, 255}));
}

TEST_F(ModelLines, AreDrawn) {
  const Seen outline = seen(square(2, {0, 1, 2, 3}));
  EXPECT_EQ(outline.colour, 0xF800);
  EXPECT_GT(outline.pixels, 4U * 15);
  const Seen points = seen(square(0, {0, 1, 2, 3}));
  EXPECT_EQ(points.pixels, 4U);
}

TEST_F(ModelLines, OfOtherFormatsBesideTriangles) {
  const std::string obj = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3\n";
  const std::string path = file("both.obj", obj + "l 3 4 1\np 4\n");
  const Model both = model(path);
  EXPECT_EQ(both.instances.size(), 2U);  // both sides
  std::vector<Ends> ends = joined(both);
  std::ranges::sort(ends);
  EXPECT_EQ(ends, (std::vector<Ends>{{2, 3}, {3, 0}, {3, 3}}));
  EXPECT_TRUE(both.warnings.empty());
  EXPECT_GT(seen(path).pixels, seen(file("alone.obj", obj)).pixels + 20);
}

TEST_F(ModelLines, DamagedOnesAreLeftOut) {
  const Model damaged = model(square(1, {0, 2, 3, 9}));
  EXPECT_EQ(joined(damaged), (std::vector<Ends>{{0, 2}}));
  ASSERT_EQ(damaged.warnings.size(), 1U);
  EXPECT_EQ(damaged.warnings[0], "1 line left out: with vertices that do not exist, or are not finite");
}

/// A triangle and two lines with `attributes`, on node 0, which an animation moves.
std::string triangle_and_lines(const std::string& node, const std::string& attributes, const std::string& skins) {
  GltfData data;
  data.add_floats({-1, -1, 0, 1, -1, 0, 1, 1, 0}, "VEC3");
  data.add_indices({0, 1, 2, 0});
  data.add(std::string(12, '\0'), R"("componentType":5121,"count":3,"type":"VEC4")");
  data.add_floats({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, "VEC4");
  data.add_floats({0, 1}, "SCALAR");
  data.add_floats({0, 0, 0, 1, 0, 0}, "VEC3");
  const std::string primitive = R"("attributes":{"POSITION":0)" + attributes + "}";
  return gltf_of(R"("nodes":[{)" + node + R"(},{}],"meshes":[{"primitives":[{)" + primitive +
                 R"(},{"mode":1,"indices":1,)" + primitive + R"(}]}],)" + skins +
                 R"("animations":[{"channels":[{"sampler":0,"target":{"node":)" + (skins.empty() ? "0" : "1") +
                 R"(,"path":"translation"}}],"samplers":[{"input":4,"output":5}]}],)" + data.json());
}

TEST_F(ModelLines, OfSkinsAreLeftOutAndSaid) {
  const Model bent =
      model(file("bent.gltf", triangle_and_lines(R"("mesh":0,"skin":0,"children":[1])",
                                                 R"(,"JOINTS_0":2,"WEIGHTS_0":3)", R"("skins":[{"joints":[1]}],)")));
  EXPECT_EQ(bent.skins.size(), 1U);
  EXPECT_TRUE(bent.lines.empty());
  EXPECT_EQ(bent.warnings, std::vector<std::string>{"2 lines left out: skins bend triangles only"});
}

TEST_F(ModelLines, OfMovingNodesStandAtRestAndThatIsSaid) {
  const Model moved = model(file("moved.gltf", triangle_and_lines(R"("mesh":0)", "", "")));
  EXPECT_EQ(moved.lines.size(), 1U);
  EXPECT_EQ(moved.tree.animations.size(), 1U);
  EXPECT_EQ(moved.warnings, std::vector<std::string>{"2 lines drawn at rest: animations move triangles only"});
}

/// They were left out.
TEST_F(ModelLines, OfModelsOfSceneFilesStandWhereTheirInstanceDoes) {
  file("both.obj", "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -3 0 2\nf 1 2 3\nl 1 4 2\n");
  const std::string model = "[[model]]\nname = 'plate'\nfile = 'both.obj'\n";
  const std::string still =
      "[[instance]]\nmodel = 'plate'\ntranslation = [2, 0, 0]\nscale = [2, 2, 2]\n"
      "rotation = [0, 90, 0]\n";
  const auto stage = open_stage(file("scene.toml", model + still), {}, {}, {64, 64}, 1);
  ASSERT_TRUE(stage) << stage.failure().message;
  EXPECT_EQ((*stage)->warnings(), std::vector<std::string>{});
  const Result<Staging> staging = (*stage)->place(0, 1);
  ASSERT_TRUE(staging);
  const Scene& scene = staging->scene;
  ASSERT_EQ(scene.lines.size(), 1U);
  const LineSet& set = scene.lines[0];
  ASSERT_EQ(set.segments.size(), 2U);
  // Both ends of the second line, and the triangle's second corner, by the transforms of the scene.
  const auto at = [&](const Transform& transform, const Mesh& mesh, std::uint16_t vertex) {
    const Position& p = mesh.positions[vertex];
    const double q[3] = {static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)};
    const double half[3] = {mesh.half_extent.x / 65536.0, mesh.half_extent.y / 65536.0, mesh.half_extent.z / 65536.0};
    const double centre[3] = {mesh.centre.x / 65536.0, mesh.centre.y / 65536.0, mesh.centre.z / 65536.0};
    Vector result{};
    for (std::size_t row = 0; row < 3; ++row) {
      result[row] = transform.m[row][3] / 65536.0;
      for (std::size_t i = 0; i < 3; ++i) {
        result[row] += transform.m[row][i] / 65536.0 * (centre[i] + half[i] * q[i] / 32767);
      }
    }
    return result;
  };
  const Mesh& lines = scene.meshes[set.mesh];
  const Vector far_end = at(set.transform, lines, set.segments[0].b),
               near_end = at(set.transform, lines, set.segments[1].b);
  // x and z change places and signs by the turn: (-3, 0, 2) becomes 2 * (2, 0, 3), (1, -1, 0) becomes 2 * (0, -1, -1).
  const double units = (far_end[0] - near_end[0]) / 4;
  EXPECT_GT(units, 0);
  EXPECT_NEAR(far_end[2] - near_end[2], 8 * units, 0.01);
  EXPECT_NEAR(far_end[1] - near_end[1], 2 * units, 0.01);
  EXPECT_NEAR(near_end[0], 2 * units, 0.01) << "moved";

  for (const std::string moved : {"turntable = { turns = 1 }\n", "layer = 'static'\n"}) {
    const auto without = open_stage(file("scene.toml", model + still + moved), {}, {}, {64, 64}, 1);
    ASSERT_TRUE(without) << without.failure().message;
    EXPECT_EQ(
        (*without)->warnings(),
        std::vector<std::string>{"model 'plate': its lines and points are left out where an instance of it moves, "
                                 "turns to the camera or is static"});
  }
}

/// It was "the scene is a single point", of no model.
TEST_F(ModelLines, OfSceneFilesWithNothingElseNameTheModel) {
  square(3, {0, 1, 2});
  const std::string model = "[[model]]\nname = 'wire'\nfile = 'square.gltf'\n";
  EXPECT_TRUE(open_stage(file("scene.toml", model + "[[instance]]\nmodel = 'wire'\n"), {}, {}, {64, 64}, 1));
  const char* const use = "[[material]]\nname = 'm'\n[[lines]]\nmaterial = 'm'\nmodel = 'wire'\n";
  const auto stage = open_stage(file("scene.toml", model + use), {}, {}, {64, 64}, 1);
  ASSERT_FALSE(stage);
  EXPECT_EQ(stage.failure().status, ExitStatus::input);
  EXPECT_NE(stage.failure().message.find("line 3: model 'wire' has only lines and points, which an [[instance]]"),
            std::string::npos)
      << stage.failure().message;
}

/// Alpha, emission and textures of lines were left out without a word.
TEST_F(ModelLines, ArePlainAndThatIsSaid) {
  const std::string texture = R"("pbrMetallicRoughness":{"baseColorTexture":{"index":0}})";
  const std::string faint = R"("pbrMetallicRoughness":{"baseColorFactor":[1,0,0,0.3]})";
  const struct {
    std::string material;
    bool is_plain;
  } cases[] = {{R"({"alphaMode":"BLEND",)" + faint + "}", false},
               {R"({"alphaMode":"MASK",)" + faint + "}", false},
               {R"({"emissiveFactor":[0,1,0]})", false},
               {"{" + texture + "}", false},
               {"{" + faint + "}", true},
               {R"({"alphaMode":"BLEND"})", true}};
  for (const auto& [material, is_plain] : cases) {
    std::string text = GltfFile{{material}, {R"({"mesh":0})"}, rgba_png(1, 1, {9, 9, 9, 255})}.text();
    const std::string indices = R"("indices":3)";
    text.replace(text.find(indices), indices.size(), indices + R"(,"mode":1)");
    const Model lines = model(file("lines.gltf", text));
    const std::vector<std::string> said{
        "3 lines drawn in plain colours: textures, emission and alpha are of triangles only"};
    EXPECT_EQ(lines.warnings, is_plain ? std::vector<std::string>() : said) << material;
  }
}

/// An unused vertex was counted for the box: one that is not finite left nothing of the model.
TEST_F(ModelLines, UnusedVerticesDoNotCountForTheBox) {
  const Model damaged = model(file("inf.obj", "v -1 0 0\nv 1 0 0\nv inf 0 0\nl 1 2\nl 2 3\n"));
  ASSERT_EQ(damaged.lines.size(), 1U);
  EXPECT_EQ(damaged.units.scale, 1);
  const Model part = model(square(1, {0, 1}));
  EXPECT_EQ(part.units.origin, (std::array<double, 3>{0, -1, 0}));
}

TEST_F(ModelLines, MoreVerticesThanIndicesReachAreSeveralSets) {
  std::string obj;
  constexpr int kPoints = 70'000;
  for (int i = 0; i < kPoints; ++i) obj += fmt::format("v {} {} {}\n", i % 50, i / 50 % 50, i / 2500);
  obj += "p";
  for (int i = 1; i <= kPoints; ++i) obj += fmt::format(" {}", i);
  const Model many = model(file("many.obj", obj + "\n"));
  ASSERT_EQ(many.lines.size(), 2U);
  EXPECT_EQ(many.lines[0].segments.size() + many.lines[1].segments.size(), std::size_t{kPoints});
  for (const LineSet& lines : many.lines) {
    for (const Segment& segment : lines.segments) {
      ASSERT_LT(segment.a, many.meshes[lines.mesh].positions.size());
      ASSERT_EQ(segment.a, segment.b);
    }
  }
}

TEST_F(ModelLines, ASinglePointHasNoSize) {
  const Model point = model(square(0, {1}));
  EXPECT_EQ(point.units.scale, 1);
  EXPECT_EQ(point.units.origin, (std::array<double, 3>{1, -1, 0}));
}

}  // namespace
}  // namespace zstrip::sim::test
