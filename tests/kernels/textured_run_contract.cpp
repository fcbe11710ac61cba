// Runs of texels: any walk over any texture, of any length, as they are and in one light; and whole runs between exact
// positions. What the renderer asks for is among them.
#include <cstdint>
#include <type_traits>

#include "contracts.hpp"
#include "pictures.hpp"
#include "random.hpp"
#include "textures.hpp"
#include "zstrip/kernels/textured_run.hpp"
#include "zstrip/kernels/textured_span.hpp"

namespace zstrip::kernels_test {
namespace {

using namespace detail;
using Rule = DepthRule<DepthMode{}>;
using Run = TexturedRun<TexelLight::none, false, std::uint32_t, Rule>;
using LitRun = TexturedRun<TexelLight::flat, false, std::uint32_t, Rule>;
template <TexelLight lit>
using Runs = TexturedRun<lit, false, std::uint32_t, Rule, TexturedRunsState>;

constexpr std::int32_t kMaxPixels = 40;  // more than a run has
constexpr std::int32_t kMaxRuns = 5;

/// The texture and the depth of a run.
template <class AnyRun>
void begin(Random& random, AnyRun& run) {
  // Up to 2^17 texels: more than vectors know.
  const bool large = random.below(4) == 0;
  const std::int32_t log2_width = random.between(0, large ? kMaxLog2Width : 5);
  const std::int32_t log2_height = random.between(0, large ? kMaxLog2Height : 5);
  const auto factor = [&random] { return light_factor(random.word() >> 8); };
  run.r = factor(), run.g = factor(), run.b = factor();
  run.texels = texels.data();
  run.to_column = TextureAxis(static_cast<std::uint8_t>(log2_width)).to_index;
  run.to_row = log2_width + log2_height == 0 ? 31 : 32 - log2_width - log2_height;
  run.row_mask = ~((std::uint32_t{1} << log2_width) - 1);
  run.z = random.word(), run.step_z = random.word() >> random.below(16);
  run.u = random.word(), run.v = random.word();
  run.step_u = random.word() >> random.below(16), run.step_v = random.word() >> random.below(16);
  if (log2_width == 0) run.u = run.step_u = 0;
  if (log2_height == 0) run.v = run.step_v = 0;
  if constexpr (std::is_base_of_v<TexturedRunsState, AnyRun>) {
    run.to_fraction_u = TextureAxis(static_cast<std::uint8_t>(log2_width)).to_fraction;
    run.to_fraction_v = TextureAxis(static_cast<std::uint8_t>(log2_height)).to_fraction;
  }
}

template <class AnyRun>
bool runs_differ(Random& random, std::uint32_t number, Outcome& outcome) {
  AnyRun portable;
  begin(random, portable);
  const std::int32_t length = random.between(1, kMaxPixels), start = random.below(9);
  const Pictures pictures(random, start + length, 1, portable.z >> 16);
  AnyRun own = portable;
  portable.fill(pictures.portable.depth() + start, pictures.portable.colour() + start, length, ColourPlanes{}, nullptr);
  fill_run(own, knows_texture(own), pictures.own.depth() + start, pictures.own.colour() + start, length, ColourPlanes{},
           nullptr);
  outcome.compared += pictures.changed() ? 1U : 0U;
  return (!pictures.equal() || portable.z != own.z) && outcome.differs("a run of texels", number);
}

/// Where a span with perspective goes on: 1/w stays positive.
void go_on(Random& random, TexturedRunsState& run, std::int32_t count) {
  run.one_over_w = (random.word() >> random.between(3, 20)) | 0x100;
  const auto most = static_cast<std::int32_t>(run.one_over_w / static_cast<std::uint32_t>(count + 1));
  run.one_over_w_step = static_cast<std::uint32_t>(random.between(-most, most));
  const auto over_w = [&random] { return static_cast<std::uint32_t>(random.within(1 << random.between(8, 29))); };
  run.u_over_w = over_w(), run.v_over_w = over_w();
  run.u_over_w_step = static_cast<std::uint32_t>(static_cast<std::int32_t>(over_w()) >> 4);
  run.v_over_w_step = static_cast<std::uint32_t>(static_cast<std::int32_t>(over_w()) >> 4);
  run.base_u = random.within(1 << 14) * 65536, run.base_v = random.within(1 << 14) * 65536;
  run.from_u = static_cast<std::int32_t>(random.word()), run.from_v = static_cast<std::int32_t>(random.word());
  run.right_shift = random.between(-3, 30);
}

template <TexelLight lit>
bool whole_runs_differ(Random& random, std::uint32_t number, Outcome& outcome) {
  if constexpr (kHasWholeRuns<lit, false, std::uint32_t, Rule>) {
    Runs<lit> portable;
    begin(random, portable);
    if (!knows_texture(portable)) return false;
    const std::int32_t count = random.between(1, kMaxRuns), start = random.below(9);
    go_on(random, portable, count);
    const Pictures pictures(random, start + count * kPerspectiveRun, 1, portable.z >> 16);
    Runs<lit> own = portable;
    fill_runs_portable(portable, pictures.portable.depth() + start, pictures.portable.colour() + start,
                       static_cast<std::uint32_t>(count));
    fill_runs(own, pictures.own.depth() + start, pictures.own.colour() + start, static_cast<std::uint32_t>(count));
    outcome.compared += pictures.changed() ? 1U : 0U;
    const bool same = portable.z == own.z && portable.u_over_w == own.u_over_w && portable.v_over_w == own.v_over_w &&
                      portable.one_over_w == own.one_over_w && portable.from_u == own.from_u &&
                      portable.from_v == own.from_v;
    if (!same) return outcome.differs("the place behind whole runs", number);
    return !pictures.equal() && outcome.differs("whole runs of texels", number);
  } else {
    return false;
  }
}

}  // namespace

Outcome compare_textured_runs(std::uint32_t cases) {
  Random random(6);
  fill_texels(random);
  Outcome outcome;
  for (std::uint32_t number = 0; number < cases; ++number) {
    const bool differ = number % 8 == 3   ? whole_runs_differ<TexelLight::none>(random, number, outcome)
                        : number % 8 == 7 ? whole_runs_differ<TexelLight::flat>(random, number, outcome)
                        : number % 4 == 2 ? runs_differ<LitRun>(random, number, outcome)
                                          : runs_differ<Run>(random, number, outcome);
    if (differ) break;
  }
  return outcome;
}

}  // namespace zstrip::kernels_test
