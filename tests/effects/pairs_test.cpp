// Every effect off, and every pair of effects in every combination.
#include "combination.hpp"

namespace effects_test {
namespace {

TEST(EffectsTogether, NoneOfThem) { expect_drawn_alike<row(0)>(); }
TEST(EffectsTogether, PairsOfRows1And2) {
  expect_drawn_alike<row(1)>();
  expect_drawn_alike<row(2)>();
}
TEST(EffectsTogether, PairsOfRows3And4) {
  expect_drawn_alike<row(3)>();
  expect_drawn_alike<row(4)>();
}
TEST(EffectsTogether, PairsOfRows5And6) {
  expect_drawn_alike<row(5)>();
  expect_drawn_alike<row(6)>();
}
TEST(EffectsTogether, PairsOfRow7) { expect_drawn_alike<row(7)>(); }

/// A scene that calls for `set` is drawn alike in strips and in bins, and not as what `remove` leaves of it.
template <class Remove>
void expect_column(Effects set, const Remove& remove) {
  SCOPED_TRACE(testing::Message() << std::hex << set.bits);
  const View view = view_of(set);
  const Combination combination(set);
  const Scene& scene = combination.scene;
  const Camera& camera = combination.camera;
  ASSERT_TRUE(validate(scene));
  ASSERT_EQ(without_shades(effects_of(scene, camera)) | effects_of(view), set);
  const Drawn whole = draw_any(set, scene, camera, view);
  Scene others = scene;
  remove(others);
  EXPECT_NE(draw_any(set, others, camera, view), whole);
  EXPECT_EQ(draw_any(set, scene, camera, view, {.strip_rows = 5, .strip_columns = 16}), whole);
  EXPECT_EQ(draw_any(set | effect::bins, scene, camera, view, {.strip_rows = 9, .modes = Modes::binned}), whole);
}

/// CSG goes with everything but shadows, so that it has a column of its own in each row.
TEST(EffectsTogether, ProductsOfSolidsAndEachRow) {
  for (std::size_t i = 0; i < kRows; ++i) {
    expect_column(completed(without(row(i), effect::shadows)) | effect::csg, [](Scene& scene) {
      scene.instances = scene.instances.first(3);
      scene.csg = {};
    });
  }
}

/// Edges likewise, without outlines, samples and skins, too.
TEST(EffectsTogether, EdgesAndEachRow) {
  constexpr Effects kNotWithEdges = effect::outlines | effect::supersampled | effect::skins;
  for (std::size_t i = 0; i < kRows; ++i) {
    expect_column(completed(without(row(i), kNotWithEdges)) | effect::edges, [](Scene& scene) { scene.edges = {}; });
  }
}

}  // namespace
}  // namespace effects_test
