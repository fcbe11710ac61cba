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
}

}  // namespace
}  // namespace effects_test
