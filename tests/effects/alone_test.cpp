// Every effect alone, with nothing but what it needs to show.
#include "combination.hpp"

namespace effects_test {
namespace {

TEST(EffectsTogether, EachOfLightAlone) {
  expect_drawn_alike<effect::emissive>();
  expect_drawn_alike<effect::specular>();
  expect_drawn_alike<effect::punctual_lights>();
}
TEST(EffectsTogether, EachOfFragmentsAlone) {
  expect_drawn_alike<effect::fog>();
  expect_drawn_alike<effect::alpha_test>();
  expect_drawn_alike<effect::blending>();
  expect_drawn_alike<effect::texture_alpha>();
  expect_drawn_alike<effect::bilinear>();
  expect_drawn_alike<effect::texture_palettes>();
  expect_drawn_alike<effect::mipmaps>();
  expect_drawn_alike<effect::dithered_colours>();
  expect_drawn_alike<effect::pixel_shading>();
}

TEST(EffectsTogether, EachOfSurfacesAlone) {
  expect_drawn_alike<effect::lighting>();
  expect_drawn_alike<effect::gouraud>();
  expect_drawn_alike<effect::vertex_colours>();
  expect_drawn_alike<effect::textures>();
  expect_drawn_alike<effect::quadrics>();
  expect_drawn_alike<effect::lines>();
  expect_drawn_alike<effect::billboards>();
  expect_drawn_alike<effect::environment>();
  expect_drawn_alike<effect::outlines>();
  expect_drawn_alike<effect::shadows>();
  expect_drawn_alike<effect::csg>();
  expect_drawn_alike<effect::edges>();
  expect_drawn_alike<effect::edges | effect::orthographic>();
  expect_drawn_alike<effect::overlay>();
  expect_drawn_alike<effect::orthographic>();
  expect_drawn_alike<effect::depth_state>();
  expect_drawn_alike<effect::supersampled>();
}

}  // namespace
}  // namespace effects_test
