// Bilinear texels: any walk over any texture of any format. The portable kernel reads each texel by itself, so that it
// keeps none of a neighbour's.
#include <algorithm>
#include <array>
#include <cstdint>

#include "contracts.hpp"
#include "random.hpp"
#include "textures.hpp"
#include "zstrip/kernels/fragment_run.hpp"
#include "zstrip/kernels/portable/bilinear.hpp"
#include "zstrip/raster/run_texels.hpp"

namespace zstrip::kernels_test {
namespace {

using namespace detail;
using Colours = std::array<std::uint32_t, kPerspectiveRun + 1>;  // one more, which must stay

RunTexels texels_of(Random& random, TextureFormat format) {
  // A quarter are large; there is room for their alpha.
  const bool large = random.below(4) == 0;
  const auto side = [&](std::int32_t most) {
    return static_cast<std::uint8_t>(random.between(0, large ? most - 1 : 4));
  };
  const std::uint8_t width = side(kMaxLog2Width), height = side(kMaxLog2Height);
  return detail::texels_of({texels.data(), width, height}, format);
}

/// A quarter of a texel and more, mostly; or of any size.
std::uint32_t step(Random& random, std::uint32_t log2_size) {
  if (log2_size == 0) return 0;
  const std::int32_t kind = random.below(8);
  const std::int32_t smaller = kind == 0 ? random.below(31) : static_cast<std::int32_t>(log2_size) + random.below(4);
  std::uint32_t size = random.word() >> 1 >> smaller;
  if (kind == 1) size = 1U << (32 - log2_size - 1);
  if (kind == 2) size = 1U << (32 - log2_size);  // just a texel
  return random.below(2) == 0 ? size : 0 - size;
}

template <bool palettes, bool alpha>
bool run_differs(Random& random, const RunTexels& from, std::uint32_t number, Outcome& outcome) {
  const auto place = [&random](std::uint32_t log2_size) { return log2_size == 0 ? 0 : random.word(); };
  const RunPlace run{place(from.log2_width), place(from.log2_height), step(random, from.log2_width),
                     step(random, from.log2_height)};
  const std::int32_t count = random.between(1, kPerspectiveRun);
  Colours portable, own;
  portable.fill(0x12345678);
  own = portable;
  RunPlace one{run.u, run.v, 0, 0};
  for (std::int32_t i = 0; i < count; ++i, one.u += run.step_u, one.v += run.step_v) {
    fetch_bilinear_portable<palettes, alpha>(from, one, &portable[static_cast<std::size_t>(i)], 1);
  }
  fetch_bilinear<palettes, alpha>(from, run, own.data(), count);
  outcome.compared += static_cast<std::uint32_t>(count);
  if (own != portable) return outcome.differs("a run of bilinear texels", number);
  fetch_bilinear_portable<palettes, alpha>(from, run, own.data(), count);
  return own != portable && outcome.differs("a portable run of bilinear texels", number);
}

}  // namespace

Outcome compare_bilinear(std::uint32_t cases) {
  Random random(9);
  fill_texels(random);
  Outcome outcome;
  for (std::uint32_t number = 0; number < cases; ++number) {
    constexpr TextureFormat kFormats[] = {TextureFormat::rgb565, TextureFormat::rgb565_alpha, TextureFormat::palette8,
                                          TextureFormat::palette4};
    const TextureFormat format = kFormats[number % 4];
    const RunTexels from = texels_of(random, format);
    const bool differs = format == TextureFormat::rgb565_alpha ? run_differs<false, true>(random, from, number, outcome)
                         : format == TextureFormat::rgb565 && number % 8 == 0
                             ? run_differs<false, false>(random, from, number, outcome)
                             : run_differs<true, false>(random, from, number, outcome);
    if (differs) break;
  }
  return outcome;
}

}  // namespace zstrip::kernels_test
