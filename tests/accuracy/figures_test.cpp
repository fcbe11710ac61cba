// The renderer against the truth: what the figures must say where it is known beforehand.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "accuracy/campaign.hpp"
#include "accuracy/measure.hpp"
#include "accuracy/perceived.hpp"
#include "accuracy/variant.hpp"
#include "opened_scene.hpp"

namespace zstrip::sim {
namespace {

Errors errors(const AccuracyScene& scene, const char* settings) { return *scene.errors(*parse_settings(settings)); }

// Scenes of which nothing is clipped: corners that clipping makes are snapped again, each side in its own way.
TEST(Figures, DepthIsWithinACodeOfThePlanesThroughSnappedCorners) {
  for (const char* name : {"knot", "teapot", "cube", "spheres", "wires"}) {
    const auto opened = scene(name);
    for (const char* format : {"z16", "float"}) {
      const std::string settings = std::string("depth=") + format;
      EXPECT_LT(errors(*opened, settings.c_str())[Figure::depth_codes], 1.6) << name << ' ' << format;
    }
  }
}

TEST(Figures, SurfacesAreTheTruthsButAtSomeEdges) {
  for (const char* name : {"knot", "teapot", "cube", "room", "terrain"}) {
    EXPECT_LT(errors(*scene(name), "default")[Figure::wrong_pixels], 1.0) << name;
  }
}

// Nothing of a sphere is snapped: every pixel is right, and so are its texture coordinates.
TEST(Figures, SpheresAreTheTruths) {
  const Errors spheres = errors(*scene("spheres"), "default");
  EXPECT_EQ(spheres[Figure::wrong_surface], 0);
  EXPECT_EQ(spheres[Figure::texture], 0);
  EXPECT_LT(spheres[Figure::colour_mean], 3);
}

TEST(Figures, DepthFormatsDifferWhereNearAndFarAreFarApart) {
  const auto terrain = scene("terrain");
  EXPECT_GT(errors(*terrain, "default")[Figure::depth_view], 3 * errors(*terrain, "depth=float")[Figure::depth_view]);
}

TEST(Figures, CoarserDepthShowsMoreWrongSurfaces) {
  const auto decal = scene(ZSTRIP_ROOT "/tests/accuracy/decal.toml");
  const auto wrong = [&](const char* settings) { return errors(*decal, settings)[Figure::wrong_surface]; };
  EXPECT_EQ(wrong("depth=z24,fit=fixed"), 0);
  EXPECT_EQ(wrong("depth=z16,fit=fitted"), 0);
  const double z16 = wrong("depth=z16,fit=fixed");
  EXPECT_GT(z16, 300);
  EXPECT_GT(wrong("depth=ranges,fit=fixed"), 1.5 * z16);
}

TEST(Figures, PerspectiveAtMorePixelsIsCloserToThePlaceInTheTexture) {
  const auto opened = scene("room");
  const double affine = errors(*opened, "perspective=affine")[Figure::texture];
  const double sixteen = errors(*opened, "default")[Figure::texture];
  const double eight = errors(*opened, "perspective=8")[Figure::texture];
  const double one = errors(*opened, "perspective=1")[Figure::texture];
  EXPECT_GT(affine, sixteen);
  EXPECT_GT(sixteen, eight);
  EXPECT_GT(eight, one);
}

// The truth lights at each sample: what is nearer to that is nearer to the truth.
TEST(Figures, LightAtMorePlacesIsCloserToTheTruth) {
  for (const char* name : {"teapot", "teapot_meshlets"}) {
    const auto opened = scene(name);
    const Errors flat = errors(*opened, "shading=flat"), gouraud = errors(*opened, "default");
    const Errors pixel = errors(*opened, "shading=pixel");
    for (const Figure figure : {Figure::colour_mean, Figure::perceived, Figure::flip, Figure::flicker}) {
      EXPECT_GT(flat[figure], gouraud[figure]) << name;
      EXPECT_GT(gouraud[figure], pixel[figure]) << name;
    }
    EXPECT_EQ(pixel[Figure::wrong_pixels], gouraud[Figure::wrong_pixels]) << name;
  }
}

TEST(Figures, BilinearTexelsChangeColoursAlone) {
  const auto opened = scene("room");
  const Errors nearest = errors(*opened, "default"), bilinear = errors(*opened, "filter=bilinear");
  EXPECT_EQ(bilinear[Figure::wrong_pixels], nearest[Figure::wrong_pixels]);
  EXPECT_TRUE(std::isnan(bilinear[Figure::texture]));
  EXPECT_NE(bilinear[Figure::colour_mean], nearest[Figure::colour_mean]);
}

TEST(Figures, MipmapsFlickerLessAndTakeMoreFlash) {
  for (const char* name : {"cube", "room"}) {
    const auto opened = scene(name);
    for (const auto& [without, with] :
         {std::pair{"default", "filter=mipmapped"}, std::pair{"filter=bilinear", "filter=mipmapped_bilinear"}}) {
      const Errors plain = errors(*opened, without), mipmapped = errors(*opened, with);
      EXPECT_LT(mipmapped[Figure::flicker], plain[Figure::flicker]) << name;
      EXPECT_LT(mipmapped[Figure::perceived], plain[Figure::perceived]) << name;
      EXPECT_EQ(mipmapped[Figure::wrong_pixels], plain[Figure::wrong_pixels]) << name;
      EXPECT_TRUE(std::isnan(mipmapped[Figure::texture])) << name;
      EXPECT_GT(opened->memory(*parse_settings(with))->scene_bytes,
                opened->memory(*parse_settings(without))->scene_bytes)
          << name;
    }
  }
}

TEST(Figures, DitheringLooksMoreLikeTheTruthWhereShadesAreFew) {
  for (const char* name : {"teapot", "spheres", "terrain"}) {
    const auto opened = scene(name);
    for (const auto& [without, with] :
         {std::pair{"format=mono", "format=mono,dither=on"}, std::pair{"format=gray4", "format=gray4,dither=on"},
          std::pair{"default", "dither=on"}}) {
      const Errors plain = errors(*opened, without), dithered = errors(*opened, with);
      EXPECT_EQ(dithered[Figure::wrong_pixels], plain[Figure::wrong_pixels]) << name;
      EXPECT_EQ(dithered[Figure::depth_codes], plain[Figure::depth_codes]) << name;
      EXPECT_NE(dithered[Figure::colour_mean], plain[Figure::colour_mean]) << name << ' ' << with;
      if (std::string(without) == "format=mono") {
        EXPECT_LT(dithered[Figure::perceived], plain[Figure::perceived]) << name;
      }
    }
  }
}

TEST(Figures, MoreSamplesLookMoreLikeTheTruthAndTakeMoreMemory) {
  for (const char* name : {"cube", "wires"}) {
    const auto opened = scene(name);
    std::vector<Errors> seen;
    std::vector<std::uint64_t> ram;
    for (const char* samples : {"samples=1", "samples=2", "samples=4"}) {
      seen.push_back(errors(*opened, samples));
      ram.push_back(opened->memory(*parse_settings(samples))->ram_bytes);
    }
    for (std::size_t i = 1; i < 3; ++i) {
      EXPECT_LT(seen[i][Figure::perceived], seen[i - 1][Figure::perceived]) << name;
      EXPECT_GT(seen[i][Figure::psnr_16x], seen[i - 1][Figure::psnr_16x] + 1) << name;
      // Surfaces are those of the pixel's middle.
      EXPECT_EQ(seen[i][Figure::wrong_pixels], seen[0][Figure::wrong_pixels]) << name;
      // 16 rows of samples: their depth, and RGB565 beside the strip's pixels.
      EXPECT_EQ(ram[i], ram[0] + 96 * 16 * (i == 1 ? 2 * 2 - 2 + 2 * 2 : 2 * 4 - 2 + 2 * 4)) << name;
    }
  }
}

TEST(Figures, BlendedEdgesLookMoreLikeTheTruthAndTakeMoreFlash) {
  for (const char* name : {"knot", "teapot", "cube", "terrain", "spheres"}) {
    const auto opened = scene(name);
    const Errors plain = errors(*opened, "default"), blended = errors(*opened, "samples=edges");
    EXPECT_LT(blended[Figure::perceived], plain[Figure::perceived]) << name;
    EXPECT_GT(blended[Figure::psnr_16x], plain[Figure::psnr_16x]) << name;
    for (const Figure figure : {Figure::wrong_pixels, Figure::silhouette, Figure::depth_codes}) {
      EXPECT_EQ(blended[figure], plain[figure]) << name;
    }
    const MemoryCost memory = *opened->memory(*parse_settings("samples=edges"));
    EXPECT_GT(memory.scene_bytes, opened->memory(*parse_settings("default"))->scene_bytes) << name;
    EXPECT_LT(memory.ram_bytes, opened->memory(*parse_settings("samples=2"))->ram_bytes) << name;
  }
}

// Simplified meshes have other edges, flat ones have one wherever two faces meet.
TEST(Figures, EdgesAreThoseOfTheMeshThatIsDrawn) {
  const auto opened = scene("knot");
  const auto edges_of = [&](const char* settings) {
    const SceneVariant variant(opened->staged()[0].scene, *parse_settings(settings));
    std::size_t edges = 0;
    for (const EdgeSet& set : variant.apply(opened->staged()[0]).scene.edges) edges += set.edges.size();
    return edges;
  };
  EXPECT_EQ(edges_of("default"), 0U);
  EXPECT_GT(edges_of("samples=edges"), 2 * edges_of("samples=edges,detail=25"));
  EXPECT_GT(edges_of("samples=edges,detail=25"), 0U);
  EXPECT_TRUE(opened->errors(*parse_settings("samples=edges,detail=25,shading=flat,strips=bins16")));
}

// Samples and edges of the scene itself are no figure of the default: the knob says which there are.
TEST(Figures, AntiAliasingIsTheKnobsMatter) {
  const auto own = scene(ZSTRIP_ROOT "/host-sim/scenes/edges.toml");
  EXPECT_FALSE(own->effects().has(effect::edges));
  for (const char* samples : {"samples=1", "samples=2", "samples=edges"}) {
    EXPECT_TRUE(own->errors(*parse_settings(samples))) << samples;
  }
  EXPECT_LT(errors(*own, "samples=edges")[Figure::perceived], errors(*own, "default")[Figure::perceived]);
}

TEST(Figures, StripsChangeNoPixel) {
  const auto opened = scene("knot_meshlets");
  const Errors standard = errors(*opened, "default");
  for (const char* strips : {"4", "64", "whole", "bins16"}) {
    const Errors other = errors(*opened, (std::string("strips=") + strips).c_str());
    for (std::size_t i = 0; i < kFigures; ++i) {
      EXPECT_TRUE(other.value[i] == standard.value[i] || (std::isnan(other.value[i]) && std::isnan(standard.value[i])))
          << strips << figures()[i].name;
    }
  }
}

TEST(Figures, FewerTrianglesAreFartherFromTheTruthAndTakeLessMemory) {
  const auto opened = scene("knot");
  double last = 0;
  std::uint64_t bytes = UINT64_MAX;
  for (const char* detail : {"default", "detail=50", "detail=25", "detail=10"}) {
    const double wrong = errors(*opened, detail)[Figure::wrong_pixels];
    EXPECT_GT(wrong, last) << detail;
    last = wrong;
    const Result<MemoryCost> memory = opened->memory(*parse_settings(detail));
    EXPECT_LT(memory->scene_bytes, bytes) << detail;
    bytes = memory->scene_bytes;
  }
}

TEST(Figures, EqualPicturesLookTheSame) {
  const std::vector<std::array<float, 3>> grey(64, {90, 90, 90});
  std::vector<std::array<float, 3>> other = grey;
  EXPECT_EQ(perceived_difference(8, 8, grey, other), std::vector<float>(64, 0));
  other[8 * 4 + 4] = {255, 255, 255};
  const std::vector<float> difference = perceived_difference(8, 8, grey, other);
  EXPECT_GT(difference[8 * 4 + 4], 10);
  EXPECT_GT(difference[8 * 4 + 5], 0);
  EXPECT_EQ(difference[0], 0);
  // White and black are 100 units of lightness apart.
  const std::vector<std::array<float, 3>> black(64, {0, 0, 0}), white(64, {255, 255, 255});
  EXPECT_NEAR(perceived_difference(8, 8, black, white)[20], 100, 0.1);
}

TEST(Campaign, TargetsShareWhatDoesNotDependOnThem) {
  const auto host = scene("teapot");
  const AccuracyScene board = host->on("m3");
  EXPECT_EQ(board.request().target, "m3");
  EXPECT_EQ(host->request().target, "host");
  AccuracyPictures first, again;
  const Errors seen = *host->errors(*parse_settings("depth=z24"), &first);
  EXPECT_EQ(board.errors(*parse_settings("depth=z24,strips=4"), &again)->value[0], seen.value[0]);
  EXPECT_EQ(again.drawn, first.drawn);
  EXPECT_EQ(again.heat, first.heat);
  EXPECT_NE(errors(board, "depth=ranges")[Figure::depth_codes], seen[Figure::depth_codes]);
}

TEST(Campaign, DithersWithEachFormat) {
  const CampaignOptions options{.knobs = *parse_knobs("format,dither"), .only = {}};
  const std::vector<Settings> wanted = first_settings(*scene("teapot"), options);
  std::vector<std::string> words;
  for (const Settings& settings : wanted) words.push_back(to_text(settings));
  EXPECT_EQ(words, (std::vector<std::string>{"default", "format=gray4", "format=mono", "dither=on",
                                             "format=gray4,dither=on", "format=mono,dither=on"}));
}

TEST(Campaign, CombinationsTurnSeveralKnobsAndCanAllBeDrawn) {
  const auto opened = scene("room");
  CampaignOptions options{.knobs = *parse_knobs("depth,perspective,filter,dither,samples"), .only = {}, .jobs = 2};
  const std::vector<Settings> all = all_settings(*opened, options.knobs);
  for (const Settings& settings : all) {
    EXPECT_TRUE(opened->errors(settings)) << to_text(settings);
  }
  EXPECT_GT(all.size(), 40U);
}

TEST(Campaign, PresetsAreMeasuredAsFarAsTheyChangeAnything) {
  const auto has = [](const std::vector<Settings>& list, const char* text) {
    return std::find(list.begin(), list.end(), *parse_settings(text)) != list.end();
  };
  CampaignOptions options{.knobs = *parse_knobs("strips"), .only = {}, .presets = true};
  const std::vector<Settings> teapot = first_settings(*scene("teapot"), options);
  EXPECT_EQ(teapot.size(), 7U);  // six strips and tiny; balanced and exact are the default
  EXPECT_TRUE(has(teapot, "tiny"));
  const std::vector<Settings> cube = first_settings(*scene("cube"), options);
  EXPECT_EQ(cube.size(), 7U);  // tiny changes its strips alone, which are there already
  EXPECT_TRUE(has(cube, "exact"));
  EXPECT_FALSE(has(cube, "tiny"));
}

}  // namespace
}  // namespace zstrip::sim
