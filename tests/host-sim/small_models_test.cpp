// Small models of which each was refused or drawn wrong: a row a model, with the colours of places in its picture.
#include <array>
#include <string>
#include <vector>

#include "command_fixture.hpp"

namespace zstrip::sim::test {
namespace {

using Rgb = std::array<int, 3>;
constexpr Rgb kRed{255, 0, 0}, kGreen{0, 255, 0}, kLitRed{194, 0, 0}, kLitGreen{0, 194, 0}, kGrey{155, 155, 155},
    kBlack{};

/// A colour of the picture, in units of the model off the place that the camera looks at.
struct Seen {
  double right, up;
  Rgb colour;
};

struct SmallModel {
  std::string sentence, file;
  std::vector<Seen> seen;
  std::string place = "0,0,0";  ///< that the camera looks at, against z
  int frame = 0;                ///< of `frames`; 0: a single picture
  std::vector<std::string> options{};
  int frames = 5;
};

const std::vector<SmallModel>& small_models() {
  static const std::vector<SmallModel> kModels{
      {"ColoursOfBlendersObjAreLinear", "blender.obj", {{0, 0, {43, 56, 35}}}},
      {"LinesOfMtlThatAreNotDrawnAreSkipped", "aniso.obj", {{0, 0, kLitRed}}},
      {"AJointFarFromAMeshThatItDoesNotMoveIsNoError", "skin_small.gltf", {{0, 0, kRed}}, "0,1.65,0", 2},
      {"BlendingWithoutATransparentPlaceIsOpaque", "blend_opaque.gltf", {{0, 0, kRed}}},
      {"ARootOfTheSceneMayHangOutsideOfIt", "root_with_parent.gltf", {{0, 0, kRed}}},
      {"ATexelOfAPaletteKeepsItsColour", "palette3.gltf", {{0, 0, kGreen}}},
      {"TheLineBehindAByteOrderMarkCounts", "bom.obj", {{-.8, -.9, kGrey}}},
      {"ColoursOfBlendersFbxAreLinear", "blender.fbx", {{0, 0, {43, 56, 35}}}},
      {"ColoursOfBlendersColladaAreLinear", "blender.dae", {{0, 0, {43, 56, 35}}}},
      {"NumbersOfObjNeedNoLeadingZero", "dot.obj", {{0, 0, kGrey}, {.97, .9, kBlack}}},
      {"VertexColoursOfObjMayHaveAlpha", "rgba.obj", {{0, 0, kLitGreen}}},
      {"AnObjectWithoutColoursBeforeOneWithKeepsItsOwn", "o_vcs.obj", {{-.5, 0, kGrey}, {.5, 0, kLitGreen}}},
      {"MaterialsAreFoundInAnyCase", "case.obj", {{0, 0, kLitRed}}},
      {"MaterialsAreFoundBehindABackslash", "backslash.obj", {{0, 0, kLitRed}}},
      {"SpacesBehindNamesDoNotCount", "trail.obj", {{-.5, 0, kLitRed}, {.5, 0, kLitGreen}}},
      {"AnAvatarIsAGlb", "c_avatar.vrm", {{0, 0, kRed}}},
      {"LengthsOfChunksCount", "c_unpadded_json_0.glb", {{0, 0, kRed}}},
      {"BytesBehindTheLastChunkDoNotCount", "c_json_only_tail.glb", {{0, 0, kRed}}},
      {"AnAnimationOfOneKeyIsThePose", "one_key.gltf", {{.7, 0, kRed}, {0, 0, kBlack}}},
      {"BytesBehindTheLastTriangleOfStlDoNotCount", "s_t.stl", {{0, 0, kGrey}}, "0,0,0", 0, {"--up", "y"}},
      {"NormalsOfStlMayBeNoNumbers", "s_ni.stl", {{0, 0, kGrey}}, "0,0,0", 0, {"--up", "y"}},
      {"ABlankLineMayStandBeforeSolid", "s_ls.stl", {{0, 0, kGrey}}, "0,0,0", 0, {"--up", "y"}},
      {"MagicsWritesTheColourOfTheWholeIntoTheHeader", "s_mag.stl", {{0, 0, kLitGreen}}, "0,0,0", 0, {"--up", "y"}},
      {"ANodeOfNoSizeAtRestGrows", "scale_zero.gltf", {{-.25, 0, kRed}, {.8, 0, kGreen}}, "0,0,0", 2, {}, 4},
      {"PlacesFarAwayKeepTheirDetails",
       "geo_4e6.gltf",
       {{.15, 0, kRed}, {.3, 0, kGreen}, {.45, 0, kRed}},
       "4000000,0,0"},
      {"GoldOfSpecularAndGlossinessIsNotBlack", "specgloss_gold.gltf", {{0, 0, {194, 170, 118}}}},
      {"MeshesHaveCopies",
       "instancing.gltf",
       {{-.7, 0, kRed}, {0, 0, kRed}, {.7, 0, kRed}, {-.35, 0, kBlack}, {.35, 0, kBlack}}},
      {"NodesThatAreNotVisibleAreNotDrawn", "invisible.gltf", {{-.5, 0, kRed}, {.5, 0, kBlack}}},
      {"PicturesMayHaveInks", "jpeg_cmyk.gltf", {{-.5, 0, kRed}, {.5, 0, kGreen}}},
      {"OptionsOfATextureScaleIt",
       "scale.obj",
       {{-.75, 0, kLitRed}, {-.25, 0, kLitGreen}, {.25, 0, kLitRed}, {.75, 0, kLitGreen}}},
      {"FacesOfPlyHaveColours", "p_face.ply", {{0, 0, kLitGreen}}},
      {"ObjectsOf3mfLieInOtherParts", "m_production.3mf", {{0, 0, kGrey}}, "0,0,0", 0, {"--up", "y"}},
  };
  return kModels;
}

class SmallModels : public Command, public ::testing::WithParamInterface<SmallModel> {};

TEST_P(SmallModels, HaveTheseColours) {
  const SmallModel& model = GetParam();
  const std::string eye = model.place.substr(0, model.place.rfind(',')) + ",5";
  std::vector<std::string> arguments{"render",    ZSTRIP_SMALL_MODELS "/" + model.file,
                                     "--size",    "64x64",
                                     "--ortho",   "--fov",
                                     "30",        "--eye",
                                     eye,         "--look-at",
                                     model.place, "--background",
                                     "000000",    "-o"};
  if (model.frame == 0) {
    arguments.emplace_back("seen.png");
  } else {
    arguments.insert(arguments.end(), {"seen", "--frames", std::to_string(model.frames)});
  }
  arguments.insert(arguments.end(), model.options.begin(), model.options.end());
  const Outcome outcome = zstrip(arguments);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.err.find("warning"), std::string::npos) << outcome.err;
  const RgbImage image = picture(model.frame == 0 ? "seen.png" : files().at(static_cast<std::size_t>(model.frame)));
  ASSERT_EQ(image.width, 64U);
  constexpr double kPixels = 32 / 1.339746;  // a unit: the picture is 10 tan 15 degrees high
  for (const auto& [right, up, colour] : model.seen) {
    const std::uint8_t* const pixel =
        image.pixel(static_cast<std::uint32_t>(32 + right * kPixels), static_cast<std::uint32_t>(32 - up * kPixels));
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(int{pixel[i]}, colour[i], 8) << right << ", " << up << ": " << i;
  }
}

INSTANTIATE_TEST_SUITE_P(, SmallModels, ::testing::ValuesIn(small_models()),
                         [](const auto& row) { return row.param.sentence; });

/// The near plane was a hundredth of the model away at least.
TEST_F(Command, ACameraCloseToALargeGroundSeesIt) {
  for (const std::vector<std::string>& camera :
       {std::vector<std::string>{"--camera", "Cam"}, {"--eye", "0,0,5", "--look-at", "0,0,0", "--fov", "30"}}) {
    std::vector<std::string> arguments{"render", ZSTRIP_SMALL_MODELS "/ground_2000.gltf", "--size", "64x64", "-o",
                                       "g.png"};
    arguments.insert(arguments.end(), camera.begin(), camera.end());
    const Outcome outcome = zstrip(arguments);
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.err.find("warning"), std::string::npos) << outcome.err;
    const RgbImage seen = picture("g.png");
    EXPECT_EQ((Rgb{seen.pixel(32, 32)[0], seen.pixel(32, 32)[1], seen.pixel(32, 32)[2]}), kRed);
    EXPECT_EQ((Rgb{seen.pixel(5, 5)[0], seen.pixel(5, 5)[1], seen.pixel(5, 5)[2]}), kGreen);
  }
}

/// Two of its corners lie on each axis, and four at 0: most of it was said to lie in the middle.
TEST_F(Command, AnOctahedronIsSeenWithoutAWarning) {
  const Outcome outcome = zstrip({"render", ZSTRIP_SMALL_MODELS "/octahedron.obj", "--size", "64x64", "-o", "o.png"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.err.find("warning"), std::string::npos) << outcome.err;
}

using RefusedModels = Command;

TEST_F(RefusedModels, AreNamedByWhatTheyAre) {
  for (const auto& [file, words] : {std::pair{"c_lfs.glb", "is a Git LFS pointer, not the file"},
                                    std::pair{"min21.gltf", "asset.minVersion 2.1 is more than 2.0"}}) {
    const Outcome outcome = zstrip({"render", std::string(ZSTRIP_SMALL_MODELS "/") + file, "-o", "p.png"});
    EXPECT_EQ(outcome.status, 4) << file;
    EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
  }
}

}  // namespace
}  // namespace zstrip::sim::test
