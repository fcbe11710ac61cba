// Every effect of the list alone, with nothing but what it needs to show.
#include <utility>

#include "combination.hpp"

namespace effects_test {
namespace {

constexpr bool is_drawn(Effects effect) {
  return !effect.any(effect::bins | effect::unclipped | effect::dithered_format);
}

TEST(EffectsTogether, EachAlone) {
  [&]<std::size_t... place>(std::index_sequence<place...>) {
    (
        [&] {
          if constexpr (constexpr Effects kAlone = kEffectNames[place].effect; is_drawn(kAlone)) {
            expect_drawn_alike<kAlone>();
          }
        }(),
        ...);
  }
  (std::make_index_sequence<kEffectNames.size()>());
}

TEST(EffectsTogether, EdgesOfAnOrthographicCamera) { expect_drawn_alike<effect::edges | effect::orthographic>(); }

}  // namespace
}  // namespace effects_test
