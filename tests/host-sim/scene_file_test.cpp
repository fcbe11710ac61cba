// Scene files: what they say is what is read, and what they say wrongly is an error with its line.
#include <gtest/gtest.h>

#include <string>

#include "cli/parse.hpp"
#include "scene_text.hpp"

namespace zstrip::sim::test {
namespace {

TEST(SceneFile, SmallestOne) {
  const SceneFile file = parsed(kCube);
  ASSERT_EQ(file.instances.size(), 1U);
  EXPECT_EQ(file.instances[0].line, 4);
  EXPECT_FALSE(file.instances[0].moves());
  EXPECT_FALSE(file.camera);
}

TEST(SceneFile, EveryTable) {
  const SceneFile file = parsed(
      "ambient = [1, 2, 3]\nbackground = '#0a0B0c'\nduration = 2\n"
      "[picture]\nsize = [64, 48]\nformat = 'gray4'\ndither = true\ndepth_format = 'z24'\nstrip_rows = "
      "8\nstrip_columns = 16\n"
      "ram = 4096\nframes = 12\nvisibility = 'midpoint'\niterations = 4\n"
      "cull = ['small', 'spheres']\nvisible_sets = 'rooms.zpv'\n"
      "[camera]\nr = 5\nphi = 30\ntheta = 60\nlook_at = [0, 1, 0]\nprojection = 'orthographic'\nhalf_height = 2\n"
      "near = 0.5\nfar = 20\norbit = { yaw = [-40, 0], distance = [0.5, 2] }\n"
      "[[model]]\nname = 'pot'\nfile = 'pot.obj'\nup = '-z'\n"
      "[[material]]\nname = 'red'\ncolour = [255, 0, 0]\nlit = false\nsmooth = false\ndouble_sided = true\n"
      "depth_test = 'always'\ndepth_write = false\ndepth_bias = -3\n"
      "[[instance]]\nmodel = 'pot'\nmaterials = { 'lid' = 'red' }\ntranslation = [1, 2, 3]\nrotation = [0, 90, 0]\n"
      "scale = [1, 2, 3]\nlayer = 'static'\n"
      "[[instance]]\nmodel = 'pot'\nmaterial = 'red'\ninterpolation = 'step'\nturntable = { turns = -2, axis = [1, 0, "
      "0] }\n"
      "[[instance.keyframe]]\ntime = 0\nscale = 1\n[[instance.keyframe]]\ntime = 1.5\nscale = 2\n"
      "[[light]]\ndirection = [0, -1, 0]\ncolour = [200, 100, 0]\nintensity = 0.5\n");
  EXPECT_EQ(file.ambient, (Colour{1, 2, 3, 255}));
  EXPECT_EQ(file.background, (Colour{10, 11, 12, 255}));
  EXPECT_EQ(file.duration, 2);
  EXPECT_EQ(file.picture.size, (std::pair<std::uint16_t, std::uint16_t>{64, 48}));
  EXPECT_EQ(file.picture.format, PixelFormat::gray4);
  EXPECT_EQ(file.picture.dither, true);
  EXPECT_EQ(file.picture.depth_format, DepthFormat::z24);
  EXPECT_EQ(file.picture.strip_rows, 8);
  EXPECT_EQ(file.picture.strip_columns, 16);
  EXPECT_EQ(file.picture.ram, 4096U);
  EXPECT_EQ(file.picture.visibility.method, "midpoint");
  EXPECT_EQ(file.picture.visibility.iterations, 4U);
  EXPECT_EQ(file.picture.visibility.cull, (std::vector<std::string>{"small", "spheres"}));
  EXPECT_EQ(file.picture.visibility.sets, "rooms.zpv");
  EXPECT_EQ(file.picture.frames, 12U);
  ASSERT_TRUE(file.camera);
  EXPECT_EQ(file.camera->radius, 5);
  EXPECT_EQ(file.camera->phi, 30);
  EXPECT_EQ(file.camera->theta, 60);
  EXPECT_EQ(file.camera->look_at, (Vector{0, 1, 0}));
  EXPECT_TRUE(file.camera->orthographic);
  EXPECT_EQ(file.camera->projection_line, 22);
  EXPECT_EQ(file.camera->half_height, 2);
  EXPECT_EQ(file.camera->near_plane, 0.5);
  EXPECT_EQ(file.camera->far_plane, 20);
  EXPECT_EQ(file.camera->orbit.yaw.least, -40);
  EXPECT_EQ(file.camera->orbit.yaw.most, 0);
  EXPECT_EQ(file.camera->orbit.pitch.most, 360) << "free";
  EXPECT_EQ(file.camera->orbit.distance.most, 2);
  ASSERT_EQ(file.models.size(), 1U);
  EXPECT_EQ(file.models[0].file, "pot.obj");
  EXPECT_EQ(file.models[0].up, UpAxis::minus_z);
  ASSERT_EQ(file.materials.size(), 1U);
  EXPECT_EQ(file.materials[0].colour, (Colour{255, 0, 0, 255}));
  EXPECT_EQ(file.materials[0].lit, false);
  EXPECT_EQ(file.materials[0].smooth, false);
  EXPECT_EQ(file.materials[0].double_sided, true);
  EXPECT_EQ(file.materials[0].depth_test, DepthTest::always);
  EXPECT_EQ(file.materials[0].depth_write, false);
  EXPECT_EQ(file.materials[0].depth_bias, -3);
  ASSERT_EQ(file.instances.size(), 2U);
  const FileInstance& still = file.instances[0];
  EXPECT_TRUE(still.is_static);
  EXPECT_EQ(still.placement.translation, (Vector{1, 2, 3}));
  EXPECT_EQ(still.placement.scale, (Vector{1, 2, 3}));
  EXPECT_NEAR(still.placement.rotation[1], 0.70710678, 1e-8);
  EXPECT_NEAR(still.placement.rotation[3], 0.70710678, 1e-8);
  ASSERT_EQ(still.materials.size(), 1U);
  EXPECT_EQ(still.materials[0].first, "lid");
  const FileInstance& moving = file.instances[1];
  EXPECT_TRUE(moving.moves());
  ASSERT_TRUE(moving.turntable);
  EXPECT_EQ(moving.turntable->turns, -2);
  EXPECT_EQ(moving.scale.times, (std::vector<double>{0, 1.5}));
  EXPECT_EQ(moving.scale.interpolation, Interpolation::step);
  EXPECT_TRUE(moving.translation.times.empty());
  ASSERT_EQ(file.lights.size(), 1U);
  EXPECT_EQ(file.lights[0].colour, (Colour{100, 50, 0, 255}));
}

/// Each was a stack overflow in the reader of TOML.
TEST(SceneFile, KeysOfThousandsOfNamesAreRefusedWithTheirLine) {
  std::string deep = "a";
  for (int i = 0; i < 40000; ++i) deep += i % 2 == 0 ? ".a" : " . \"a\"";
  const std::string expected = "'scene.toml' line 3: a key has more than 16 names with dots between them";
  for (const std::string& key : {deep + " = 1", "[" + deep + "]", "[[" + deep + "]]", "a = {" + deep + " = 1}"}) {
    EXPECT_EQ(failure("\nduration = 2 # no key\n" + key + "\n"), expected);
  }
  // Behind texts that end in quotes of their own.
  EXPECT_EQ(failure("a = \"\"\"\n\"\"\"\"\"\nb." + deep + " = ''\n"), expected);
  EXPECT_EQ(failure("a = '''\n''''\nb." + deep + " = ''\n"), expected);
}

TEST(SceneFile, DotsOfTextsAndCommentsAreNoKeys) {
  const std::string dots(100, '.');
  const std::string comment = "# " + dots + " '\n";
  EXPECT_EQ(parsed(comment + "[[model]]\nname = '" + dots + "'\nbuilt_in = \"\"\"\ncu\\\n  be\"\"\"\n" +
                   "[[instance]]\nmodel = \"" + dots + "\"\nrotation = [1.5, 2.5, 3.5]\n")
                .instances.size(),
            1U);
}

TEST(SceneFile, ShadingHasThreeNames) {
  const auto shading_of = [](const char* line) {
    const std::string text = std::string("[[material]]\nname = 'a'\n").append(line).append("\n");
    return parsed(text + "[[model]]\nname = 'm'\nbuilt_in = 'knot'\n[[instance]]\nmodel = 'm'\n").materials[0].smooth;
  };
  EXPECT_FALSE(shading_of("").has_value());
  EXPECT_EQ(shading_of("shading = 'flat'"), Shading::flat);
  EXPECT_EQ(shading_of("shading = 'gouraud'"), Shading::gouraud);
  EXPECT_EQ(shading_of("shading = 'pixel'"), Shading::pixel);
  EXPECT_EQ(shading_of("smooth = false"), Shading::flat);
  EXPECT_EQ(shading_of("smooth = true"), Shading::gouraud);
  const auto wrong = [](const char* lines) {
    return failure(std::string("[[material]]\nname = 'a'\n").append(lines).append("\n").append(kCube));
  };
  EXPECT_EQ(wrong("shading = 'pixels'"),
            "'scene.toml' line 3: [[material]]: 'shading' names no word 'pixels'; did you mean 'pixel'?");
  EXPECT_EQ(wrong("shading = 'flat'\nsmooth = false"),
            "'scene.toml' line 4: [[material]]: 'smooth' and 'shading' are one property, and the material has both; "
            "leave out "
            "'smooth'");
}

/// Degrees about x, then y, then z: x, turned by 90 degrees about y, points to -z; about z afterwards it stays there.
TEST(SceneFile, OrderOfRotations) {
  const SceneFile file = parsed(kCube + "rotation = [0, 90, 90]\n");
  const Vector turned = to_affine(file.instances[0].placement) * Vector{1, 0, 0};
  EXPECT_NEAR(turned[0], 0, 1e-12);
  EXPECT_NEAR(turned[1], 0, 1e-12);
  EXPECT_NEAR(turned[2], -1, 1e-12);
}

TEST(SceneFile, ErrorsNameLineAndNearestName) {
  EXPECT_EQ(failure("backgrund = 'x'\n" + kCube),
            "'scene.toml' line 1: a scene has no key 'backgrund'; did you mean 'background'?");
  EXPECT_EQ(failure(kCube + "scael = 2\n"),
            "'scene.toml' line 6: [[instance]] has no key 'scael'; did you mean 'scale'?");
  EXPECT_EQ(failure(kCube + "[[instance]]\nmodel = 'cub'\n"),
            "'scene.toml' line 7: [[instance]]: 'model' names no model 'cub'; did you mean 'cube'?");
  EXPECT_EQ(failure(kCube + "material = 'red'\n"),
            "'scene.toml' line 6: [[instance]]: 'material' names no material 'red'; there is none");
  EXPECT_EQ(failure(kCube + "layer = 'statik'\n"),
            "'scene.toml' line 6: [[instance]]: 'layer' names no word 'statik'; did you mean 'static'?");
  EXPECT_EQ(failure("duration = 'long'\n" + kCube),
            "'scene.toml' line 1: a scene: 'duration' must be a number from 0.001 to 3600");
  EXPECT_EQ(failure(kCube + "[camera]\nr = -1\n"),
            "'scene.toml' line 7: [camera]: 'r' must be a number from 1e-09 to 1e+09");
}

/// What is wrong stands in the line that the message names.
TEST(SceneFile, OutOfRangeOrMissing) {
  const struct {
    const char* lines;
    int line;
    const char* said;
  } cases[] = {
      {"scale = 0\n", 6, "'scale' must be a number"},
      {"scale = nan\n", 6, "'scale' must be a number"},
      {"translation = [1, 2]\n", 6, "3 numbers"},
      {"translation = [1, 2, inf]\n", 6, "must be a number from"},
      {"quaternion = [0, 0, 0, 0]\n", 6, "must have a length"},
      {"rotation = [0, 0, 0]\nquaternion = [0, 0, 0, 1]\n", 7, "either 'rotation' or 'quaternion'"},
      {"layer = 'static'\nturntable = {}\n", 6, "static layer"},
      {"[[instance.keyframe]]\ntime = 1\n[[instance.keyframe]]\ntime = 1\n", 9, "greater than"},
      {"[[instance.keyframe]]\nscale = 1\n", 6, "'time' is missing"},
      {"[camera]\n", 6, "either 'eye'"},
      {"[camera]\nr = 1\neye = [0, 0, 1]\n", 8, "either 'eye'"},
      {"[camera]\neye = [0, 0, 0]\n", 7, "different points"},
      {"[camera]\neye = [0, 0, 1]\nphi = 3\n", 8, "goes with 'r'"},
      {"[camera]\nr = 1\nhalf_height = 1\n", 8, "orthographic"},
      {"[camera]\nr = 1\nnear = 2\nfar = 1\n", 8, "less than"},
      {"[camera]\nr = 1\norbit = { yaw = [10, 40] }\n", 8, "'yaw' must be the least and the most, and 0 between them"},
      {"[camera]\nr = 1\norbit = { distance = [2, 1] }\n", 8, "and 1 between them"},
      {"[picture]\nsize = [0, 5]\n", 7, "from 1 to 4096"},
      {"[picture]\nframes = 1.5\n", 7, "whole number"},
      {"[[light]]\ncolour = '#fff'\ndirection = [0, 1, 0]\n", 7, "must be a colour"},
      {"[[light]]\ndirection = [0, 0, 0]\n", 7, "must have a length"},
      {"[[light]]\n", 6, "'direction' is missing"},
      {"[[material]]\nname = 'a'\nlit = 1\n", 8, "true or false"},
      {"[[material]]\nname = 'a'\n[[material]]\nname = 'a'\n", 8, "a second material 'a'"},
      {"[[model]]\nname = 'b'\n", 6, "either 'file' or 'built_in'"},
      {"[[model]]\nname = 'b'\nbuilt_in = 'cube'\nup = 'z'\n", 9, "goes with 'file'"},
      {"scale = \n", 6, ""},
  };
  for (const auto& each : cases) {
    const std::string message = failure(kCube + each.lines);
    EXPECT_TRUE(message.starts_with("'scene.toml' line " + std::to_string(each.line) + ": ")) << each.lines << message;
    EXPECT_NE(message.find(each.said), std::string::npos) << each.lines << message;
  }
  EXPECT_NE(failure("ambient = [0, 0, 0]\n").find("nothing to draw"), std::string::npos);
  EXPECT_NE(failure("instance = 3\n").find("must be tables"), std::string::npos);
}

TEST(SceneFile, PalettesOfTextures) {
  const auto material = [](const std::string& lines) { return "[[material]]\nname = 'a'\n" + lines + "\n" + kCube; };
  EXPECT_EQ(parsed(material("texture = 't.png'")).materials.at(0).palette, std::nullopt);
  EXPECT_EQ(parsed(material("texture = 't.png'\npalette = 4")).materials.at(0).palette, TextureFormat::palette4);
  EXPECT_EQ(parsed(material("texture = 't.png'\npalette = 8")).materials.at(0).palette, TextureFormat::palette8);
  for (const char* value : {"6", "16", "0", "'8'", "true"}) {
    const std::string message = failure(material(std::string("texture = 't.png'\npalette = ") + value));
    EXPECT_EQ(message.find("'scene.toml' line 4: [[material]]: 'palette' must be "), 0U) << message;
  }
  EXPECT_EQ(failure(material("palette = 8")),
            "'scene.toml' line 3: [[material]]: 'palette' is for the colours of 'texture' or 'environment', which is "
            "missing");
}

TEST(SceneFile, MipmapsOfTextures) {
  const auto material = [](const std::string& lines) { return "[[material]]\nname = 'a'\n" + lines + "\n" + kCube; };
  EXPECT_EQ(parsed(material("texture = 't.png'")).materials.at(0).mipmaps, std::nullopt);
  EXPECT_EQ(parsed(material("mipmaps = true")).materials.at(0).mipmaps, true);
  EXPECT_TRUE(parsed(material("mipmaps = true")).materials.at(0).has_finish());
  EXPECT_EQ(parsed(material("mipmaps = false")).materials.at(0).mipmaps, false);
  EXPECT_FALSE(parsed(material("mipmaps = false")).materials.at(0).has_finish());
  for (const char* value : {"1", "'on'", "4"}) {
    EXPECT_EQ(failure(material(std::string("texture = 't.png'\nmipmaps = ") + value)),
              "'scene.toml' line 4: [[material]]: 'mipmaps' must be true or false");
  }
}

TEST(SceneFile, EnvironmentInPlaceOfATexture) {
  const auto material = [](const std::string& lines) { return "[[material]]\nname = 'a'\n" + lines + "\n" + kCube; };
  EXPECT_FALSE(parsed(material("texture = 't.png'")).materials.at(0).mirrors);
  const FileMaterial mirror = parsed(material("palette = 8\nenvironment = 'e.png'")).materials.at(0);
  EXPECT_TRUE(mirror.mirrors);
  EXPECT_TRUE(mirror.has_finish());
  EXPECT_EQ(mirror.texture, "e.png");
  EXPECT_EQ(mirror.texture_line, 4);
  EXPECT_EQ(mirror.palette, TextureFormat::palette8);
  EXPECT_EQ(failure(material("environment = 'e.png'\ntexture = 't.png'")),
            "'scene.toml' line 3: [[material]]: 'environment' is in the place of 'texture', and the material has both; "
            "leave out one");
  EXPECT_NE(failure(material("enviroment = 'e.png'")).find("environment"), std::string::npos) << "the nearest key";
  EXPECT_NE(failure("[[material]]\nname = 'a'\nenvironment = 'e.png'\n[[ellipsoid]]\nmaterial = 'a'\n")
                .find("line 4: [[ellipsoid]]: the material 'a' must do without"),
            std::string::npos);
}

TEST(SceneFile, WhetherThePictureIsDithered) {
  EXPECT_EQ(parsed(kCube).picture.dither, std::nullopt);
  EXPECT_EQ(parsed("[picture]\ndither = false\n" + kCube).picture.dither, false);
  EXPECT_EQ(failure("[picture]\ndither = 1\n" + kCube),
            "'scene.toml' line 2: [picture]: 'dither' must be true or false");
  EXPECT_EQ(failure("[picture]\nditer = true\n" + kCube),
            "'scene.toml' line 2: [picture] has no key 'diter'; did you mean 'dither'?");
}

TEST(SceneFile, HowOftenTexturesAreExact) {
  EXPECT_EQ(parsed("[picture]\nperspective = 'affine'\n" + kCube).picture.perspective, effect::perspective_affine);
  EXPECT_EQ(parsed("[picture]\nperspective = '1'\n" + kCube).picture.perspective, effect::perspective_1);
  EXPECT_FALSE(parsed(kCube).picture.perspective);
  EXPECT_NE(failure("[picture]\nperspective = 'afine'\n" + kCube).find("line 2: "), std::string::npos);
}

TEST(SceneFile, SamplesOfAPixel) {
  EXPECT_EQ(parsed(kCube).picture.samples, std::nullopt);
  for (const int samples : {1, 2, 4}) {
    EXPECT_EQ(parsed("[picture]\nsamples = " + std::to_string(samples) + "\n" + kCube).picture.samples, samples);
  }
  EXPECT_EQ(failure("[picture]\nsamples = 3\n" + kCube), "'scene.toml' line 2: [picture]: 'samples' must be 1, 2 or 4");
  EXPECT_NE(failure("[picture]\nsamples = 0\n" + kCube), "");
  EXPECT_NE(failure("[picture]\nsamples = 8\n" + kCube), "");
  EXPECT_NE(failure("[picture]\nsamples = '4'\n" + kCube), "");
}

TEST(SceneFile, EdgesAreAFlag) {
  EXPECT_EQ(parsed(kCube).picture.edges, std::nullopt);
  EXPECT_EQ(parsed("[picture]\nedges = true\n" + kCube).picture.edges, true);
  EXPECT_EQ(parsed("[picture]\nedges = false\n" + kCube).picture.edges, false);
  EXPECT_NE(failure("[picture]\nedges = 1\n" + kCube), "");
  EXPECT_NE(failure("[picture]\nedge = true\n" + kCube).find("edges"), std::string::npos);
}

TEST(SceneFile, HowVisibilityIsFound) {
  const auto wrong = [](const std::string& line, const char* part) {
    const std::string message = failure("[picture]\n" + line + "\n" + kCube);
    EXPECT_NE(message.find("line 2: "), std::string::npos) << message;
    EXPECT_NE(message.find(part), std::string::npos) << message;
  };
  wrong("visibility = 'best'", "'visibility' names no method 'best'; there are zbuffer, painter, ");
  wrong("visibility = 'paintr'", "'visibility' names no method 'paintr'; did you mean 'painter'?");
  wrong("iterations = 7", "'iterations' must be a whole number from 0 to 6");
  wrong("sort_key = 'centre'", "'sort_key' is not one of: middle, nearest, farthest");
  for (const char* line : {"cull = 'small'", "cull = []", "cull = ['small', 3]"}) {
    wrong(
        line,
        "must be a list, [\"word\", \"word\"], of one or more of: back-faces, small, spheres, temporal; or [\"none\"]");
  }
  wrong("cull = ['none', 'small']", "'cull' none goes with nothing else");
  wrong("cull = ['fronts']", "'cull' 'fronts' is not one of: back-faces, small, spheres, temporal, none");
  wrong("cull = ['temporal']",
        "'cull' with temporal needs the bounds of visibility = \"hierarchical-z\", and not \"zbuffer\"");
  wrong("visible_sets = 3", "'visible_sets' must be a text in quotes");
  wrong("visible_sets = ''", "'visible_sets' must not be empty");
  wrong("iteration = 3", "did you mean 'iterations'?");
}

/// They were ignored.
TEST(SceneFile, KeysThatTheMethodDoesNotUse) {
  const auto picture = [](const std::string& lines) { return failure("[picture]\n" + lines + "\n" + kCube); };
  EXPECT_NE(picture("iterations = 3")
                .find("line 2: [picture]: 'iterations' means nothing to visibility = \"zbuffer\"; "
                      "leave it out, or choose one of: midpoint, midpoint-safe"),
            std::string::npos);
  EXPECT_NE(
      picture("visibility = 'midpoint'\nsort_key = 'nearest'")
          .find("line 3: [picture]: 'sort_key' means nothing to visibility = \"midpoint\"; leave it out, or choose "
                "one of: painter, front-to-back, front-to-back-hierarchical-z"),
      std::string::npos);
  const auto kept = [](const std::string& lines) {
    return parsed("[picture]\n" + lines + "\n" + kCube).picture.visibility;
  };
  EXPECT_EQ(kept("visibility = 'midpoint-safe'\niterations = 3").iterations, 3U);
  EXPECT_EQ(kept("visibility = 'painter'\nsort_key = 'nearest'").sort_key, "nearest");
  EXPECT_EQ(kept("visibility = 'front-to-back'\nsort_key = 'farthest'").sort_key, "farthest");
  EXPECT_EQ(kept("visibility = 'hierarchical-z'\ncull = ['temporal']").cull, std::vector<std::string>{"temporal"});
}

TEST(SceneFile, SizeOfHalfAPixel) {
  EXPECT_EQ(failure(kCube + "[picture]\nsize = [64.5, 48]\n"),
            "'scene.toml' line 7: [picture]: 'size' must be whole numbers");
}

TEST(SceneFile, EveryFormatOfTheCommandLine) {
  for (const char* name : {"rgb565", "rgb565_swapped", "gray4", "mono", "rgb666", "rgb444", "xrgb8888"}) {
    const Result<PixelFormat> format = parse_format(name);
    ASSERT_TRUE(format) << name;
    EXPECT_EQ(parsed(kCube + "[picture]\nformat = '" + name + "'\n").picture.format, *format) << name;
  }
}

// Plans of them failed as bugs do, and headers of them did not compile.
TEST(SceneFile, TheSmallFloatNeedsPerspective) {
  const std::string text = "[picture]\ndepth_format = 'float'\n[camera]\nr = 7\nprojection = '";
  EXPECT_NE(failure(text + "orthographic'\n" + kCube).find("line 5: [camera]: 'depth_format' of [picture] needs"),
            std::string::npos);
  EXPECT_TRUE(parsed(text + "perspective'\n" + kCube).picture.depth_format);
  EXPECT_TRUE(parsed("[picture]\ndepth_format = 'z24'\n[camera]\nr = 7\nprojection = 'orthographic'\n" + kCube).camera);
}

TEST(SceneFile, NearestNames) {
  EXPECT_EQ(nearest("colr", {"name", "colour", "lit"}), "colour");
  EXPECT_EQ(nearest("zzzzzzzz", {"name", "colour"}), "");
  EXPECT_EQ(nearest("", {}), "");
}

}  // namespace
}  // namespace zstrip::sim::test
