// Plans for any counts, view and budget; and rows of RGB565 in the formats of panels, against a plain reference.
#include <algorithm>
#include <vector>

#include "input.hpp"
#include "require.hpp"
#include "zstrip/plan/plan.hpp"
#include "zstrip/resolve/resolve.hpp"

namespace {

using namespace zstrip;

std::uint64_t sum_of_parts(const Plan& plan) {
  return std::uint64_t{plan.instance_bytes} + plan.vertex_bytes + plan.depth_bytes + plan.colour_bytes + plan.bin_bytes;
}

/// What the parts of the arena must hold at least, from the documentation of each record.
void require_enough(const Plan& plan, const SceneCounts& counts, const View& view, Effects effects) {
  const std::uint64_t cells = std::uint64_t{plan.strip_rows} * view.width;
  const bool coloured = effects.any(effect::lighting | effect::vertex_colours);
  const bool panel = view.format == PixelFormat::gray4 || view.format == PixelFormat::mono;
  fuzz::require(plan.instance_bytes >= std::uint64_t{counts.instances} * kInstanceBytes, "room for every instance");
  fuzz::require(plan.vertex_bytes >= std::uint64_t{counts.largest_meshlet} * (coloured ? 12 : 8),
                "room for the largest meshlet");
  fuzz::require(plan.depth_bytes >= 2 * cells, "a depth cell for each pixel of a strip");
  fuzz::require(plan.colour_bytes >= (panel ? 2 * cells : 0), "a working colour for each pixel of a strip");
}

void require_sound(const Plan& plan, const SceneCounts& counts, const View& view, Effects effects) {
  fuzz::require(plan.strip_rows >= 1 && plan.strip_rows <= view.height, "1 to height strip rows: %u", plan.strip_rows);
  fuzz::require((plan.strips - 1) * plan.strip_rows < view.height && plan.strips * plan.strip_rows >= view.height,
                "strips cover the picture, none is empty: %u of %u rows", plan.strips, plan.strip_rows);
  fuzz::require(plan.bytes() == sum_of_parts(plan), "the sum of a plan's parts does not wrap: %llu",
                static_cast<unsigned long long>(sum_of_parts(plan)));
  require_enough(plan, counts, view, effects);
}

void judge_plan(fuzz::Input& input) {
  const auto number = [&input](std::int32_t usual) { return static_cast<std::uint32_t>(input.number(usual)); };
  const SceneCounts counts{number(1), number(100), number(100), number(64)};
  const View view{input.any<std::uint16_t>(), input.any<std::uint16_t>(), static_cast<PixelFormat>(input.below(4))};
  const Effects effects{input.any<std::uint8_t>() & effect::all.bits};
  const Budget budget{number(0), static_cast<std::uint16_t>(input.number(0))};

  const PlanResult result = plan(counts, view, effects, budget);
  const bool possible = view.width >= 1 && view.width <= 4096 && view.height >= 1 && view.height <= 4096;
  fuzz::require(possible != (result.status.error == Error::view_size), "sizes of 1 to 4096 and no others");
  if (!possible) return;
  fuzz::require((budget.strip_rows > view.height) == (result.status.error == Error::strip_rows),
                "as many rows as the picture has and no more");
  if (result.status.error == Error::strip_rows) return;
  if (!result.status) {
    fuzz::require(result.status.error == Error::arena_too_small, "only memory can lack");
    const std::uint32_t limit = budget.bytes == 0 ? kLargestArena : std::min(budget.bytes, kLargestArena);
    fuzz::require(result.status.available == limit, "an error says what is there: %u, not %u", limit,
                  result.status.available);
    if (sum_of_parts(result.plan) > kLargestArena) return;  // refused with any budget
    fuzz::require(result.status.needed > limit, "what is needed is more than what is there: %u, %u",
                  result.status.needed, limit);
    const PlanResult enough = plan(counts, view, effects, {result.status.needed, budget.strip_rows});
    fuzz::require(static_cast<bool>(enough.status), "the bytes that an error asks for suffice: %u",
                  result.status.needed);
    require_sound(enough.plan, counts, view, effects);
    const PlanResult less = plan(counts, view, effects, {result.status.needed - 1, budget.strip_rows});
    fuzz::require(result.status.needed == 1 || !less.status, "an error asks for no more than suffices");
    return;
  }
  require_sound(result.plan, counts, view, effects);
  fuzz::require(budget.bytes == 0 || result.plan.bytes() <= budget.bytes, "a plan keeps to its budget: %u of %u",
                result.plan.bytes(), budget.bytes);
  fuzz::require(budget.strip_rows == 0 || result.plan.strip_rows == budget.strip_rows, "given strip rows are kept");
}

/// Luma as the conventions say it, in other words than the core's.
unsigned reference_luma(std::uint16_t pixel) {
  const unsigned r = pixel / 2048U;
  const unsigned g = pixel / 32U % 64U;
  const unsigned b = pixel % 32U;
  return (77 * (r * 8 + r / 4) + 150 * (g * 4 + g / 16) + 29 * (b * 8 + b / 4) + 128) / 256;
}

void judge_resolve(fuzz::Input& input) {
  const auto width = static_cast<std::uint16_t>(1 + input.below(100));
  std::vector<std::uint16_t> pixels(width);
  for (std::uint16_t& pixel : pixels) pixel = input.any<std::uint16_t>();
  const auto garbage = static_cast<std::byte>(input.any<std::uint8_t>());

  std::vector<std::byte> gray4(bytes_per_row(width, PixelFormat::gray4), garbage);
  std::vector<std::byte> mono(bytes_per_row(width, PixelFormat::mono), garbage);
  detail::resolve_gray4(pixels.data(), width, gray4.data());
  detail::resolve_mono(pixels.data(), width, mono.data());
  // Beyond the last pixel, up to the end of its byte, everything is dark.
  for (std::size_t x = 0; x < 2 * gray4.size(); ++x) {
    const unsigned expected = x < width ? reference_luma(pixels[x]) / 16 : 0;
    const unsigned got = std::to_integer<unsigned>(gray4[x / 2]) / (x % 2 == 0 ? 16 : 1) % 16;
    fuzz::require(got == expected, "gray4 pixel %zu is %u, not %u", x, got, expected);
  }
  for (std::size_t x = 0; x < 8 * mono.size(); ++x) {
    const unsigned expected = x < width && reference_luma(pixels[x]) >= 128 ? 1 : 0;
    const unsigned got = (std::to_integer<unsigned>(mono[x / 8]) >> (7 - x % 8)) % 2;
    fuzz::require(got == expected, "mono pixel %zu is %u, not %u", x, got, expected);
  }

  std::vector<std::uint16_t> swapped = pixels;
  detail::swap_bytes(swapped.data(), width);
  for (std::size_t x = 0; x < width; ++x) {
    fuzz::require(swapped[x] == pixels[x] % 256 * 256 + pixels[x] / 256, "the bytes of pixel %zu are swapped", x);
  }

  // From an odd pixel on too: strips of odd width start at any even address.
  const std::uint32_t skipped = input.below(2);
  const auto colour = input.any<std::uint16_t>();
  std::vector<std::uint16_t> filled = pixels;
  detail::fill_pixels(filled.data() + skipped, width - skipped, colour);
  for (std::size_t x = 0; x < width; ++x) {
    fuzz::require(filled[x] == (x < skipped ? pixels[x] : colour), "pixel %zu is filled", x);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Input input(data, size);
  if (input.flag()) {
    judge_resolve(input);
  } else {
    judge_plan(input);
  }
  return 0;
}
