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

}  // namespace
}  // namespace effects_test
