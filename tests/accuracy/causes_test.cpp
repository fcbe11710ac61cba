// Where the error comes from: each cause does what it is named after and no more, and together they explain what the
// renderer draws.
#include "accuracy/causes.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "accuracy/measure.hpp"
#include "accuracy/truth_stages.hpp"
#include "opened_scene.hpp"

namespace zstrip::sim {
namespace {

Errors errors(const AccuracyScene& scene, Cause cause, const char* settings = "default") {
  return *errors_of(scene, {cause, *parse_settings(settings)});
}
constexpr std::array<Figure, 3> kSurfaces{Figure::wrong_pixels, Figure::wrong_surface, Figure::silhouette};

void expect_exact_surfaces(const Errors& found) {
  for (const Figure figure : kSurfaces) EXPECT_EQ(found[figure], 0);
}
void expect_exact_colours(const Errors& found, double within) {
  EXPECT_LE(found[Figure::colour_worst], within);
  EXPECT_LE(found[Figure::flicker], within);
}

// Without a coarse stage nothing is left: what `aliasing` draws, against itself.
TEST(Causes, AreNothingWhereAllStagesAreExact) {
  for (const char* name : {"teapot", "cube", "spheres", "wires"}) {
    const auto opened = scene(name);
    for (std::size_t i = 0; i < opened->staged().size(); ++i) {
      const Staging& staged = opened->staged()[i];
      const Result<TruthPicture> drawn = draw_truth(staged.scene, staged.camera, {96, 72}, 1, Stages{});
      ASSERT_TRUE(drawn);
      const TruthPicture& centres = opened->truths()[i].centres;
      for (std::size_t k = 0; k < centres.samples.size(); ++k) {
        ASSERT_EQ(drawn->samples[k].triangle, centres.samples[k].triangle);
        ASSERT_EQ(drawn->samples[k].rgb, centres.samples[k].rgb);
        ASSERT_EQ(drawn->samples[k].w, centres.samples[k].w);
      }
    }
    const Errors aliasing = errors(*opened, Cause::aliasing);
    expect_exact_surfaces(aliasing);
    EXPECT_EQ(aliasing[Figure::colour_worst], 0) << name;
    EXPECT_GT(aliasing[Figure::perceived], 0.05) << name;
  }
}

TEST(Causes, SnappingIsWhatWiresSuffer) {
  const Errors wires = errors(*scene("wires"), Cause::snapping), teapot = errors(*scene("teapot"), Cause::snapping);
  EXPECT_GT(wires[Figure::wrong_pixels], 3);
  EXPECT_LT(teapot[Figure::wrong_pixels], 1);
}

TEST(Causes, TheTransformIsFarBelowASubPixel) {
  for (const char* name : {"teapot", "knot"}) {
    const auto opened = scene(name);
    const Errors found = errors(*opened, Cause::transform);
    EXPECT_LT(found[Figure::wrong_pixels], 0.05) << name;
    EXPECT_LT(found[Figure::depth_codes], 0.02) << name;
    EXPECT_GT(found[Figure::depth_codes], 0) << name;
  }
}

TEST(Causes, InterpolationIsNothingWhereLightAndTexelsAreThePixelsOwn) {
  const auto teapot = scene("teapot");
  const Errors vertices = errors(*teapot, Cause::interpolation),
               pixels = errors(*teapot, Cause::interpolation, "shading=pixel");
  const Errors flat = errors(*teapot, Cause::interpolation, "shading=flat");
  EXPECT_GT(flat[Figure::colour_mean], vertices[Figure::colour_mean]);
  EXPECT_GT(vertices[Figure::colour_mean], 0.1);
  expect_exact_surfaces(pixels);
  EXPECT_LT(pixels[Figure::colour_p999], 1e-3);
  EXPECT_LT(pixels[Figure::depth_codes], 1e-3);

  const auto room = scene("room");
  double last = 1e9;
  for (const char* settings : {"perspective=affine", "default", "perspective=8", "perspective=1"}) {
    const double texels = errors(*room, Cause::interpolation, settings)[Figure::texture];
    EXPECT_LT(texels, last) << settings;
    last = texels;
  }
  EXPECT_LT(last, 1e-6);
}

TEST(Causes, DepthChangesWithItsFormatAndFitAlone) {
  const auto opened = scene("terrain");
  const Errors z16 = errors(*opened, Cause::depth), z24 = errors(*opened, Cause::depth, "depth=z24");
  const Errors fixed = errors(*opened, Cause::depth, "fit=fixed");
  EXPECT_LE(z16[Figure::depth_codes], 0.51);
  EXPECT_GT(z16[Figure::depth_view], 100 * z24[Figure::depth_view]);
  EXPECT_GE(fixed[Figure::depth_view], 0.9 * z16[Figure::depth_view]);
  expect_exact_surfaces(z24);
  expect_exact_colours(z24, 1e-4);
  for (const char* format : {"depth=float", "depth=z24", "depth=ranges"}) {
    EXPECT_LT(errors(*opened, Cause::depth, format)[Figure::depth_codes], 1.01) << format;
  }
}

// 888 would be a colour of whole numbers; formats of fewer bits change colours and nothing else.
TEST(Causes, FormatsChangeColoursAlone) {
  const auto opened = scene("teapot");
  double last = 0;
  for (const char* format : {"default", "format=gray4", "format=mono"}) {
    const Errors found = errors(*opened, Cause::colour, format);
    expect_exact_surfaces(found);
    EXPECT_LT(found[Figure::depth_view], 1e-9);
    EXPECT_GT(found[Figure::colour_worst], last) << format;
    last = found[Figure::colour_worst];
  }
  EXPECT_LE(errors(*opened, Cause::colour)[Figure::colour_worst], 8.5);
  // Every texel of the cube has a colour of RGB565; to 8 bits it is widened by repeating bits.
  EXPECT_LT(errors(*scene("cube"), Cause::colour)[Figure::colour_worst], 0.75);
}

TEST(Causes, ExplainWhatTheRendererDraws) {
  for (const char* name : {"teapot", "cube", "room", "knot", "terrain", "wires", "spheres"}) {
    const auto opened = scene(name);
    const Errors drawn = *opened->errors(Settings{});
    Errors sum;
    for (const Cause cause : {Cause::snapping, Cause::transform, Cause::interpolation, Cause::depth, Cause::colour}) {
      const Errors found = errors(*opened, cause);
      for (std::size_t i = 0; i < kFigures; ++i) sum.value[i] += std::isnan(found.value[i]) ? 0 : found.value[i];
    }
    // Light of 8 bits is the renderer's own.
    EXPECT_LT(drawn[Figure::colour_mean], 1.1 * sum[Figure::colour_mean] + 1.5) << name;
    EXPECT_GT(drawn[Figure::colour_mean], 0.3 * sum[Figure::colour_mean]) << name;
    EXPECT_LT(drawn[Figure::wrong_pixels], 1.3 * sum[Figure::wrong_pixels] + 0.1) << name;
    EXPECT_LT(drawn[Figure::depth_view], 1.5 * sum[Figure::depth_view] + 1e-4) << name;
  }
}

// The runs of texels are the renderer's: its error in the texture is theirs.
TEST(Causes, RunsOfTexelsExplainTheErrorInTheTexture) {
  const auto room = scene("room");
  for (const char* settings : {"default", "perspective=8", "perspective=affine"}) {
    const double drawn = (*room->errors(*parse_settings(settings)))[Figure::texture];
    EXPECT_NEAR(errors(*room, Cause::interpolation, settings)[Figure::texture], drawn, 0.03 * drawn) << settings;
  }
}

TEST(Causes, EachIsMeasuredWithTheValuesOfItsKnobs) {
  std::vector<std::string> words;
  for (const CauseCase& c : cause_cases(*scene("teapot"), *parse_knobs("shading,format,dither,strips")))
    words.push_back(std::string(info(c.cause).name) + " " + to_text(c.settings));
  EXPECT_EQ(words, (std::vector<std::string>{"aliasing default", "snapping default", "transform default",
                                             "interpolation default", "interpolation shading=flat",
                                             "interpolation shading=pixel", "depth default", "colour default",
                                             "colour format=gray4", "colour format=mono", "colour dither=on",
                                             "colour format=gray4,dither=on", "colour format=mono,dither=on"}));
}

}  // namespace
}  // namespace zstrip::sim
