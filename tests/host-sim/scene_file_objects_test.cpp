// Scene files: ellipsoids, lines, billboards, outlines, shadows, CSG, sprites, labels.
#include <gtest/gtest.h>

#include <string>

#include "scene_text.hpp"

namespace zstrip::sim::test {
namespace {

/// The renderer knows neither for ellipsoids, and says so only when the frame begins.
TEST(SceneFile, FinishOfAnEllipsoid) {
  for (const char* key : {"emissive = [9, 9, 9]", "specular = [9, 9, 9]", "shininess = 3", "alpha_mode = 'blend'",
                          "alpha_cutoff = 0.5", "filter = 'bilinear'"}) {
    const std::string message =
        failure(std::string("[[material]]\nname = 'a'\n") + key + "\n[[ellipsoid]]\nmaterial = 'a'\n");
    EXPECT_TRUE(message.starts_with("'scene.toml' line 4: [[ellipsoid]]: the material 'a' must do without")) << message;
  }
  const std::string palette =
      failure("[[material]]\nname = 'a'\ntexture = 't.png'\npalette = 8\n[[ellipsoid]]\nmaterial = 'a'\n");
  EXPECT_NE(palette.find("filter, palette, mipmaps and environment: ellipsoids have none"), std::string::npos)
      << palette;
}

TEST(SceneFile, PointLightOnAnEllipsoid) {
  const std::string light = "[[light]]\ntype = 'point'\nposition = [0, 2, 0]\n";
  const std::string ellipsoid = "[[ellipsoid]]\nmaterial = 'a'\n";
  EXPECT_NE(failure("[[material]]\nname = 'a'\n" + ellipsoid + light).find("line 3: [[ellipsoid]]: point and spot"),
            std::string::npos);
  EXPECT_EQ(parsed("[[material]]\nname = 'a'\nlit = false\n" + ellipsoid + light).ellipsoids.size(), 1U);
}

TEST(SceneFile, ClipsOfAModel) {
  const std::string model = "[[model]]\nname = 'a'\nfile = 'a.glb'\n", use = "[[instance]]\nmodel = 'a'\n";
  const SceneFile file =
      parsed(model + "clip = [{ animation = 'Walk', seconds = 2 }, { animation = 'Run', fade = 0.4 }]\n" + use);
  ASSERT_EQ(file.models[0].clips.size(), 2U);
  EXPECT_EQ(file.models[0].clips[0].animation, "Walk");
  EXPECT_EQ(file.models[0].clips[0].seconds, 2);
  EXPECT_EQ(file.models[0].clips[0].fade, 0.25);
  EXPECT_EQ(file.models[0].clips[1].seconds, 0) << "as long as the animation";
  EXPECT_EQ(file.models[0].clips[1].fade, 0.4);
  EXPECT_EQ(failure(model + "animation = 'Walk'\nclip = [{ animation = 'Run' }]\n" + use),
            "'scene.toml' line 4: [[model]]: give either 'animation' or 'clip'");
  EXPECT_EQ(failure(model + "clip = [{ seconds = 2 }]\n" + use),
            "'scene.toml' line 4: [[model.clip]]: 'animation' is missing: the name of one of the file");
  EXPECT_NE(failure(model + "clip = [{ animation = 'Run', fade = -1 }]\n" + use).find("'fade' must be"),
            std::string::npos);
}

TEST(SceneFile, ModelsThatAreMadeSmaller) {
  const std::string model = "[[model]]\nname = 'a'\nfile = 'a.glb'\n", use = "[[instance]]\nmodel = 'a'\n";
  const SceneFile file = parsed(model + "texture_size = 64\ntriangles = 500\n" + use);
  EXPECT_EQ(file.models[0].reduction.texture_side, 64U);
  EXPECT_EQ(file.models[0].reduction.triangles, 500U);
  EXPECT_TRUE(parsed(model + "texture_size = 0\n" + use).models[0].reduction.fold_textures);
  EXPECT_EQ(failure(model + "texture_size = 100\n" + use),
            "'scene.toml' line 4: [[model]]: 'texture_size' must be 0 or a power of two");
  for (const char* wrong : {"texture_size = -1", "texture_size = 4096", "texture_size = '64'", "triangles = 0",
                            "triangles = -1", "triangles = 1.5", "triangles = 9223372036854775807"}) {
    EXPECT_TRUE(failure(model + wrong + "\n" + use).starts_with("'scene.toml' line 4: [[model]]: 't")) << wrong;
  }
  EXPECT_EQ(failure("[[model]]\nname = 'a'\nbuilt_in = 'teapot'\ntriangles = 50\n" + use),
            "'scene.toml' line 4: [[model]]: 'triangles' goes with 'file'");
}

/// It was told that 'end' is less than 'start'.
TEST(SceneFile, FogWithoutItsEnd) {
  EXPECT_EQ(failure(kCube + "[fog]\nstart = 2\n"),
            "'scene.toml' line 6: [fog]: 'end' is missing, the distance where all is fog");
  EXPECT_EQ(failure(kCube + "[fog]\ndensity = 0.1\n"),
            "'scene.toml' line 7: [fog]: 'density' goes with the exponential modes");
  EXPECT_EQ(failure(kCube + "[fog]\nstart = 2\nend = 1\n"),
            "'scene.toml' line 8: [fog]: 'end' must be greater than 'start': all is fog there");
}

TEST(SceneFile, EventsHaveATimeAndANumber) {
  EXPECT_EQ(failure(kCube + "[[event]]\ntime = 2\n"), "'scene.toml' line 6: [[event]]: 'number' is missing");
  EXPECT_EQ(failure(kCube + "[[event]]\nnumber = 2\n"), "'scene.toml' line 6: [[event]]: 'time' is missing");
}

const std::string kWire = "[[material]]\nname = 'w'\n";  // 2 lines

TEST(SceneFile, LinesAndPoints) {
  const SceneFile file =
      parsed(kWire +
             "[[model]]\nname = 'cube'\nbuilt_in = 'cube'\n"
             "[[points]]\nmaterial = 'w'\nwidth = 4\nvertices = [[0, 0, 0], [1, 2.5, -3]]\ntranslation = [1, 2, 3]\n"
             "[[lines]]\nmaterial = 'w'\nmodel = 'cube'\nscale = 2\n"
             "[[lines]]\nmaterial = 'w'\nvertices = [[0, 0, 0], [1, 0, 0], [1, 1, 0]]\n"
             "[[lines]]\nmaterial = 'w'\nvertices = [[0, 0, 0], [1, 0, 0], [1, 1, 0]]\nsegments = [[2, 0]]\n");
  ASSERT_EQ(file.lines.size(), 4U);  // lines first
  const FileLines &wire = file.lines[0], &open = file.lines[1], &own = file.lines[2], &points = file.lines[3];
  EXPECT_EQ(wire.model, "cube");
  EXPECT_EQ(wire.width, 1);
  EXPECT_EQ(wire.placement.scale, (Vector{2, 2, 2}));
  EXPECT_TRUE(wire.segments.empty());
  ASSERT_EQ(open.segments.size(), 2U);
  EXPECT_EQ(open.segments[1].a, 1);
  EXPECT_EQ(open.segments[1].b, 2);
  ASSERT_EQ(own.segments.size(), 1U);
  EXPECT_EQ(own.segments[0].a, 2);
  EXPECT_EQ(own.segments[0].b, 0);
  EXPECT_TRUE(points.are_points);
  EXPECT_EQ(points.line, 6);
  EXPECT_EQ(points.width, 4);
  EXPECT_EQ(points.vertices[1], (Vector{1, 2.5, -3}));
  ASSERT_EQ(points.segments.size(), 2U);
  EXPECT_EQ(points.segments[1].a, points.segments[1].b);
  EXPECT_EQ(points.placement.translation, (Vector{1, 2, 3}));
}

TEST(SceneFile, LinesThatCannotBe) {
  const std::string lines = kWire + "[[lines]]\nmaterial = 'w'\n", ends = "vertices = [[0, 0, 0], [1, 0, 0]]\n";
  EXPECT_EQ(failure(lines), "'scene.toml' line 3: [[lines]]: give either 'model' or 'vertices'");
  EXPECT_EQ(failure(lines + ends + "widht = 2\n"),
            "'scene.toml' line 6: [[lines]] has no key 'widht'; did you mean 'width'?");
  EXPECT_EQ(failure(lines + ends + "width = 65\n"),
            "'scene.toml' line 6: [[lines]]: 'width' must be a whole number from 1 to 64");
  EXPECT_EQ(failure(lines + "vertices = [[0, 0, 0]]\n"),
            "'scene.toml' line 5: [[lines]]: 'vertices' must be two or more");
  EXPECT_EQ(failure(lines + "vertices = [[0, 0], [1, 0]]\n"),
            "'scene.toml' line 5: [[lines]]: 'vertices' must be a list of lists of 3 numbers");
  EXPECT_EQ(failure(lines + ends + "segments = [[0, 2]]\n"),
            "'scene.toml' line 6: [[lines]]: 'segments' must be a number from 0 to 1");
  for (const char* segment : {"[1, 1]", "[0.5, 1]"}) {
    EXPECT_EQ(failure(lines + ends + "segments = [" + segment + "]\n"),
              "'scene.toml' line 6: [[lines]]: 'segments' must be pairs of two different vertices, counted from 0");
  }
  EXPECT_EQ(failure(kWire + "[[points]]\nmaterial = 'v'\n" + ends),
            "'scene.toml' line 4: [[points]]: 'material' names no material 'v'; did you mean 'w'?");
  EXPECT_EQ(failure(lines + "model = 'cube'\n"),
            "'scene.toml' line 5: [[lines]]: 'model' names no model 'cube'; there is none");
  for (const char* key : {"texture = 'a.png'", "shininess = 3", "alpha_mode = 'blend'"}) {
    const std::string message = failure(kWire + key + "\n[[lines]]\nmaterial = 'w'\n" + ends);
    EXPECT_TRUE(message.starts_with("'scene.toml' line 4: [[lines]]: the material 'w' must do without")) << message;
  }
}

TEST(SceneFile, Billboards) {
  EXPECT_EQ(parsed(kCube).instances[0].billboard, Billboard::none);
  EXPECT_EQ(parsed(kCube + "billboard = 'viewer'\n").instances[0].billboard, Billboard::viewer);
  const SceneFile upright = parsed(kCube + "billboard = 'upright'\nrotation = [0, 0, 30]\n");
  EXPECT_EQ(upright.instances[0].billboard, Billboard::upright);
  EXPECT_NE(failure(kCube + "billboard = 'up'\n").find("line 6: [[instance]]: 'billboard' names no word 'up'"),
            std::string::npos);
  EXPECT_EQ(failure(kCube + "billboard = 'viewer'\nrotation = [0, 0, 30]\n"),
            "'scene.toml' line 7: [[instance]]: a billboard that faces the viewer has no rotation of its own");
  EXPECT_EQ(failure(kCube + "billboard = 'viewer'\nquaternion = [0, 0, 0, 1]\n"),
            "'scene.toml' line 7: [[instance]]: a billboard that faces the viewer has no rotation of its own");
  EXPECT_EQ(failure(kCube + "billboard = 'viewer'\n[[instance.keyframe]]\ntime = 0\nrotation = [0, 0, 30]\n"),
            "'scene.toml' line 9: [[instance.keyframe]]: a billboard that faces the viewer has no rotation of its own");
  EXPECT_EQ(failure(kCube + "billboard = 'upright'\nturntable = {}\n"),
            "'scene.toml' line 7: [[instance]]: a billboard rotates with the camera: it has no 'turntable'");
}

TEST(SceneFile, Outlines) {
  EXPECT_FALSE(parsed(kCube).instances[0].outline);
  const FileOutline plain = *parsed(kCube + "outline = {}\n").instances[0].outline;
  EXPECT_EQ(plain.width, 2);
  EXPECT_EQ(plain.colour, (Colour{0, 0, 0, 255}));
  const FileOutline own = *parsed(kCube + "outline = { width = 0.5, colour = '#102030' }\n").instances[0].outline;
  EXPECT_EQ(own.width, 0.5);
  EXPECT_EQ(own.colour, (Colour{0x10, 0x20, 0x30, 255}));
  for (const char* width : {"0", "16.1", "-1"}) {
    EXPECT_NE(
        failure(kCube + "outline = { width = " + width + " }\n").find("line 6: [instance.outline]: 'width' must be"),
        std::string::npos)
        << width;
  }
  EXPECT_NE(failure(kCube + "outline = { thickness = 1 }\n").find("[instance.outline] has no key 'thickness'"),
            std::string::npos)
      << failure(kCube + "outline = { thickness = 1 }\n");
}

TEST(SceneFile, Shadows) {
  const std::string light = kCube + "[[light]]\ndirection = [0, -1, 0]\n";
  EXPECT_FALSE(parsed(light).lights[0].shadow);
  const FileShadow plain = *parsed(light + "shadow = {}\n").lights[0].shadow;
  EXPECT_EQ(plain.log2_size, 8);
  EXPECT_EQ(plain.bias, Shadow{}.bias);
  EXPECT_EQ(plain.slope_bias * 65536, Shadow{}.slope_bias);
  EXPECT_EQ(plain.pool, 0U);
  const FileShadow own =
      *parsed(light + "shadow = { size = 64, bias = 5, slope_bias = 2.5, pool = 7000 }\n").lights[0].shadow;
  EXPECT_EQ(own.log2_size, 6);
  EXPECT_EQ(own.bias, 5);
  EXPECT_EQ(own.slope_bias, 2.5);
  EXPECT_EQ(own.pool, 7000U);
  const auto fails_with = [](const std::string& text, const char* what) {
    EXPECT_NE(failure(text).find(what), std::string::npos) << failure(text);
  };
  fails_with(light + "shadow = { size = 100 }\n", "[light.shadow]: 'size' must be a power of two");
  fails_with(light + "shadow = { size = 8 }\n", "'size' must be");
  fails_with(light + "shadow = { slope_bias = -1 }\n", "'slope_bias' must be");
  fails_with(light + "shadow = { pol = 1 }\n", "[light.shadow] has no key 'pol'");
  fails_with(kCube + "[[light]]\ntype = 'point'\nposition = [0, 1, 0]\nshadow = {}\n",
             "only a directional light has a shadow");
  EXPECT_EQ(parsed(kCube).instances[0].shadow, ShadowRole::casts_and_receives);
  EXPECT_EQ(parsed(kCube + "shadow = 'receives'\n").instances[0].shadow, ShadowRole::only_receives);
  EXPECT_EQ(parsed(kCube + "shadow = 'casts'\n").instances[0].shadow, ShadowRole::only_casts);
  EXPECT_EQ(parsed(kCube + "shadow = 'none'\n").instances[0].shadow, ShadowRole::none);
  fails_with(kCube + "shadow = 'recieves'\n", "receives");
}

/// Each was multiplied out, however many there were.
TEST(SceneFile, MoreProductsThanCanBeDrawnAreNotReadAtAll) {
  std::string text = kCube + "name = 'a'\n";
  for (int i = 0; i < 65; ++i) text += "[[csg]]\nexpression = '('\n";
  EXPECT_EQ(failure(text), "'scene.toml' line 135: more than 64 [[csg]]; all of them together have 64 solids at most");
}

TEST(SceneFile, ProductsOfSolids) {
  const std::string solids =
      "[[model]]\nname = 'cube'\nbuilt_in = 'cube'\n"
      "[[instance]]\nmodel = 'cube'\nname = 'block'\n"
      "[[instance]]\nmodel = 'cube'\nname = 'left drill'\n[[csg]]\n";
  const SceneFile file = parsed(solids + "expression = \"block - 'left drill'\"\n");
  ASSERT_EQ(file.csg.size(), 1U);
  EXPECT_EQ(file.csg[0].line, 11);
  EXPECT_EQ(file.csg[0].products,
            (std::vector<CsgProduct>{{{"block", CsgUse::intersected}, {"left drill", CsgUse::subtracted}}}));
  const auto fails_with = [&](const std::string& text, const char* what) {
    EXPECT_NE(failure(solids + text).find(what), std::string::npos) << failure(solids + text);
  };
  fails_with("expression = 'block - blok'\n",
             "line 11: [[csg]]: 'expression' names no instance 'blok'; did you mean 'block'?");
  fails_with("expression = 'block -'\n", "line 11: [[csg]]: 'expression' is not one: a name is missing at its end");
  fails_with("", "[[csg]]: 'expression' is missing");
  fails_with("expression = 'block'\nexpresion = 'block'\n", "has no key 'expresion'; did you mean 'expression'?");
  // They were drawn by themselves.
  fails_with("expression = \"block | block & 'left drill'\"\n",
             "line 11: [[csg]]: 'expression' is the same without 'left drill': leave it out");
  fails_with("expression = \"block - ('left drill' - block)\"\n", "the same without 'left drill'");
  fails_with("expresion = 'block'\n", "[[csg]]: 'expression' is missing, but there is 'expresion'");
  fails_with("expression = 'block - left'\n", "names no instance 'left'; 'left drill' would stand in ' ' there");
  fails_with("expression = 'block - " + std::string(500, 'x') + "'\n", ("'" + std::string(80, 'x') + "...';").c_str());
  fails_with("expression = 'block'\n[[instance]]\nmodel = 'cube'\nname = 'block'\n",
             "there are several instances 'block'");
}

TEST(SceneFile, SpritesAndLabels) {
  const SceneFile file = parsed(kCube +
                                "[[sprite]]\nimage = 'a.png'\nx = -5\ny = 300\nalpha = 9\n"
                                "[[sprite]]\nimage = 'b.png'\ncoverage = 4\ncolour = '#102030'\n"
                                "[[label]]\ntext = 'a\u00C4'\n"
                                "[[label]]\ntext = 'b'\nx = 7\nfont = 'large'\nalign = 'right'\n"
                                "background = [1, 2, 3]\nbackground_alpha = 4\n");
  ASSERT_EQ(file.sprites.size(), 2U);
  EXPECT_EQ(file.sprites[0].line, 6);
  EXPECT_EQ(file.sprites[0].x, -5);
  EXPECT_EQ(file.sprites[0].y, 300);
  EXPECT_EQ(file.sprites[0].colour, (Colour{255, 255, 255, 9}));
  EXPECT_EQ(file.sprites[0].coverage_bits, 0);
  EXPECT_EQ(file.sprites[1].coverage_bits, 4);
  EXPECT_EQ(file.sprites[1].colour, (Colour{16, 32, 48, 255}));
  ASSERT_EQ(file.labels.size(), 2U);
  EXPECT_EQ(file.labels[0].text, "a\u00C4");
  EXPECT_EQ(file.labels[0].background.a, 0);
  EXPECT_EQ(file.labels[1].font, FileFont::large);
  EXPECT_EQ(file.labels[1].alignment, Alignment::right);
  EXPECT_EQ(file.labels[1].background, (Colour{1, 2, 3, 4}));
  const auto fails_with = [](const std::string& text, const char* what) {
    EXPECT_NE(failure(kCube + text).find(what), std::string::npos) << failure(kCube + text);
  };
  fails_with("[[sprite]]\nx = 1\n", "line 6: [[sprite]]: 'image' is missing");
  fails_with("[[sprite]]\nimage = 'a.png'\ncoverage = 2\n", "line 8: [[sprite]]: 'coverage' must be 1, 4 or 8 bits");
  fails_with("[[sprite]]\nimage = 'a.png'\ncolour = '#000000'\n", "line 8: [[sprite]]: 'colour' goes with 'coverage'");
  fails_with("[[sprite]]\nimage = 'a.png'\nx = 32768\n", "line 8: [[sprite]]: 'x' must be");
  fails_with("[[label]]\nx = 1\n", "line 6: [[label]]: 'text' is missing");
  fails_with("[[label]]\ntext = 'a'\nfont = 'big'\n", "'font'");
  fails_with("[[label]]\ntext = \"a\\u0000b\"\n", "line 7: [[label]]: 'text' must not have U+0000");
  fails_with("[[sprite]]\nimage = \"a.png\\u0000.jpg\"\n", "line 7: [[sprite]]: 'image' must not have U+0000");
  fails_with("[[label]]\ntext = 'a'\nbackground_alpha = 9\n", "'background_alpha' goes with 'background'");
  fails_with("[[label]]\ntext = 'a'\nalign = 'center'\n", "did you mean 'centre'?");
  fails_with("[[label]]\ntext = '" + std::string(65536, 'a') + "'\n", "'text' must have 65,535 bytes at most");
}

}  // namespace
}  // namespace zstrip::sim::test
