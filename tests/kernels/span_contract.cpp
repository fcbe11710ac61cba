// Spans of all lengths up to 40 and at all places of a vector, of one colour and of three that vary.
#include <cstdint>

#include "contracts.hpp"
#include "pictures.hpp"
#include "random.hpp"
#include "zstrip/kernels/span.hpp"

namespace zstrip::kernels_test {
namespace {

using namespace detail;
using Rule = DepthRule<DepthMode{}>;

constexpr std::int32_t kRow = 3;

/// `draw(span, portable)`.
template <class Draw>
bool differ(Random& random, const Plane& depth, std::uint32_t number, Outcome& outcome, const Draw& draw) {
  for (std::int32_t length = 1; length <= 40; ++length) {
    for (std::int32_t start = 0; start < 9; ++start) {
      const std::int32_t skipped = random.between(0, 40), whole_length = skipped + length + random.between(0, 40);
      const Pictures pictures(random, start + length, 1, depth.at(start, kRow) >> 16);
      const auto span_of = [&](const Picture& picture) {
        return Span<>{picture.depth() + start, picture.colour() + start, length, start, kRow, skipped, whole_length};
      };
      draw(span_of(pictures.portable), true);
      draw(span_of(pictures.own), false);
      if (!pictures.equal()) return outcome.differs("a span", number);
      outcome.compared += pictures.changed() ? 1U : 0U;
    }
  }
  return false;
}

bool flat_spans_differ(Random& random, const Plane& depth, std::uint32_t number, Outcome& outcome) {
  return differ(random, depth, number, outcome, [&depth](const Span<>& span, bool portable) {
    if (portable) {
      fill_flat_portable<false>(span, depth, Rule{}, 0x1234, nullptr);
    } else {
      fill_flat<false>(span, depth, Rule{}, 0x1234, nullptr);
    }
  });
}

bool gouraud_spans_differ(Random& random, const Plane& depth, std::uint32_t number, Outcome& outcome) {
  // Channels stay within 0 .. 255 over the span.
  const auto channel = [&random] {
    return Plane{static_cast<std::uint32_t>(random.between(100 << 16, 150 << 16)),
                 static_cast<std::uint32_t>(random.between(-(1 << 17), 1 << 17)), 0};
  };
  const ColourPlanes planes{channel(), channel(), channel()};
  return differ(random, depth, number, outcome, [&](const Span<>& span, bool portable) {
    if (portable) {
      fill_gouraud_portable<false>(span, depth, Rule{}, planes, nullptr);
    } else {
      fill_gouraud<false>(span, depth, Rule{}, planes, nullptr);
    }
  });
}

}  // namespace

Outcome compare_spans(std::uint32_t cases) {
  Random random(5);
  Outcome outcome;
  for (std::uint32_t number = 0; number < cases; ++number) {
    const Plane depth{random.word(), random.word() >> random.between(0, 20), random.word()};
    if (number % 2 == 0 ? flat_spans_differ(random, depth, number, outcome)
                        : gouraud_spans_differ(random, depth, number, outcome)) {
      break;
    }
  }
  return outcome;
}

}  // namespace zstrip::kernels_test
