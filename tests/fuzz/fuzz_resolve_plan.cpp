// Plans for any counts, view and budget; and rows of RGB565 in the formats of panels, against a plain reference.
#include <algorithm>
#include <vector>

#include "input.hpp"
#include "require.hpp"
#include "zstrip/effects/dithering/dither.hpp"
#include "zstrip/plan.hpp"
#include "zstrip/resolve/resolve.hpp"

namespace {

using namespace zstrip;

std::uint64_t sum_of_parts(const Plan& plan) {
  return std::uint64_t{plan.instance_bytes} + plan.extent_bytes + plan.vertex_bytes + plan.depth_bytes +
         plan.colour_bytes + plan.bin_bytes;
}

/// What the parts of the arena must hold at least, from the documentation of each record.
void require_enough(const Plan& plan, const SceneCounts& counts, const View& view, Effects effects) {
  const std::uint64_t cells = std::uint64_t{plan.strip_rows} * plan.strip_columns;
  const bool binned = plan.mode == Mode::binned;
  const std::uint64_t meshlets = std::max(counts.meshlets, counts.instances);
  const bool coloured = effects.any(effect::lighting | effect::vertex_colours) && !counts.colours_in_place;
  const bool panel = view.format != PixelFormat::rgb565 && view.format != PixelFormat::rgb565_swapped;
  fuzz::require(plan.instance_bytes >= std::uint64_t{counts.instances} * kInstanceBytes, "room for every instance");
  fuzz::require(
      plan.vertex_bytes >= std::uint64_t{binned ? counts.vertices : counts.largest_meshlet} * (coloured ? 12 : 8),
      "room for the largest meshlet, or for all vertices");
  fuzz::require(plan.strips == 1 || plan.extent_bytes >= 4 * meshlets, "an extent for each meshlet");
  fuzz::require(!binned || plan.bin_bytes >= 8 * meshlets + 8 * std::uint64_t{plan.strips}, "a list for each strip");
  fuzz::require(plan.depth_bytes >= 2 * cells, "a depth cell for each pixel of a strip");
  fuzz::require(plan.colour_bytes >= (panel ? 2 * cells : 0), "a working colour for each pixel of a strip");
}

void require_sound(const Plan& plan, const SceneCounts& counts, const View& view, Effects effects) {
  fuzz::require(plan.strip_rows >= 1 && plan.strip_rows <= view.height, "1 to height strip rows: %u", plan.strip_rows);
  fuzz::require(plan.strip_columns >= 1 && plan.strip_columns <= view.width &&
                    (plan.strip_columns % 8 == 0 || plan.strip_columns == view.width),
                "columns split at bytes: %u", plan.strip_columns);
  const unsigned across = (view.width + plan.strip_columns - 1U) / plan.strip_columns;
  fuzz::require(plan.strips % across == 0, "rows of strips are complete");
  const unsigned down = plan.strips / across;
  fuzz::require((down - 1) * plan.strip_rows < view.height && down * plan.strip_rows >= view.height,
                "strips cover the picture, none is empty: %u of %u rows", down, plan.strip_rows);
  fuzz::require(plan.bytes() == sum_of_parts(plan), "the sum of a plan's parts does not wrap: %llu",
                static_cast<unsigned long long>(sum_of_parts(plan)));
  require_enough(plan, counts, view, effects);
}

void judge_plan(fuzz::Input& input) {
  const auto number = [&input](std::int32_t usual) { return static_cast<std::uint32_t>(input.number(usual)); };
  SceneCounts counts{number(1), number(100), number(100), number(64)};
  const View view{input.any<std::uint16_t>(), input.any<std::uint16_t>(), static_cast<PixelFormat>(input.below(8))};
  const Effects shading = Effects{input.any<std::uint8_t>()} & effect::all;
  const Effects effects = shading | (input.flag() ? effect::bins : Effects{});
  Budget budget{.bytes = number(0), .strip_rows = static_cast<std::uint16_t>(input.number(0))};
  counts.meshlets = number(2);
  counts.longest_meshlet = number(100);
  // A meshlet is part of the scene.
  counts.largest_meshlet = std::min(counts.largest_meshlet, counts.vertices);
  counts.longest_meshlet = std::min(counts.longest_meshlet, counts.triangles);
  budget.strip_columns = static_cast<std::uint16_t>(input.number(0));
  budget.split_columns = input.flag();
  budget.strip_buffers = static_cast<std::uint8_t>(input.below(3));
  budget.modes = static_cast<Modes>(input.below(3));
  counts.colours_in_place = input.flag();

  const PlanResult result = plan(counts, view, effects, budget);
  const bool possible = view.width >= 1 && view.width <= 4096 && view.height >= 1 && view.height <= 4096 &&
                        view.format <= PixelFormat::xrgb8888;
  fuzz::require(possible != (result.status.error == Error::view_size), "sizes of 1 to 4096, formats, and no others");
  if (!possible) return;
  fuzz::require((budget.strip_rows > view.height) == (result.status.error == Error::strip_rows),
                "as many rows as the picture has and no more");
  if (result.status.error == Error::strip_rows) return;
  const bool columns_fit =
      budget.strip_columns == view.width || (budget.strip_columns < view.width && budget.strip_columns % 8 == 0);
  fuzz::require(columns_fit == (result.status.error != Error::strip_columns), "columns split at bytes");
  if (!columns_fit) return;
  const bool cannot_bin = budget.modes == Modes::binned && !effects.has(effect::bins);
  fuzz::require(cannot_bin == (result.status.error == Error::effect_missing), "binning is an effect");
  if (cannot_bin || result.status.error == Error::unplannable) return;
  if (!result.status) {
    fuzz::require(result.status.error == Error::arena_too_small, "only memory can lack");
    const std::uint32_t limit = budget.bytes == 0 ? kMaxArena : std::min(budget.bytes, kMaxArena);
    fuzz::require(result.status.available == limit, "an error says what is there: %u, not %u", limit,
                  result.status.available);
    const std::uint64_t smallest =
        sum_of_parts(result.plan) + std::uint64_t{budget.strip_buffers} * result.plan.strip_pixel_bytes(view);
    if (smallest > kMaxArena) return;  // refused with any budget
    fuzz::require(result.status.needed > limit, "what is needed is more than what is there: %u, %u",
                  result.status.needed, limit);
    const auto with_bytes = [&budget](std::uint32_t bytes) {
      Budget changed = budget;
      changed.bytes = bytes;
      return changed;
    };
    const PlanResult enough = plan(counts, view, effects, with_bytes(result.status.needed));
    fuzz::require(static_cast<bool>(enough.status), "the bytes that an error asks for suffice: %u",
                  result.status.needed);
    require_sound(enough.plan, counts, view, effects);
    const PlanResult less = plan(counts, view, effects, with_bytes(result.status.needed - 1));
    // Of plans that may only be binned the smallest is one of those that were tried.
    fuzz::require(budget.modes == Modes::binned || result.status.needed == 1 || !less.status,
                  "an error asks for no more than suffices");
    return;
  }
  require_sound(result.plan, counts, view, effects);
  const std::uint64_t all_bytes =
      result.plan.bytes() + std::uint64_t{budget.strip_buffers} * result.plan.strip_pixel_bytes(view);
  fuzz::require(budget.bytes == 0 || all_bytes <= budget.bytes, "a plan keeps to its budget: %u of %u",
                static_cast<unsigned>(all_bytes), budget.bytes);
  const bool is_binned = result.plan.mode == Mode::binned;
  fuzz::require(result.plan.strips > 1 || !is_binned, "a single strip is not binned");
  fuzz::require(budget.modes == Modes::any || result.plan.strips == 1 || is_binned == (budget.modes == Modes::binned),
                "a given mode is kept");
  fuzz::require(budget.strip_columns == 0 || result.plan.strip_columns == budget.strip_columns,
                "given columns are kept");
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

  // A row anywhere in the picture is dithered at once as it is pixel by pixel.
  const auto left = static_cast<std::int32_t>(input.below(kMaxViewSize));
  const auto top = static_cast<std::int32_t>(input.below(kMaxViewSize));
  for (const PixelFormat format : {PixelFormat::gray4, PixelFormat::mono, PixelFormat::rgb444}) {
    std::vector<std::uint16_t> dithered = pixels;
    dither_pixels(format, {left, top, left + width, top + 1}, dithered.data());
    for (std::int32_t x = 0; x < width; ++x) {
      const auto at = static_cast<std::size_t>(x);
      std::uint16_t alone = pixels[at];
      dither_pixels(format, {left + x, top, left + x + 1, top + 1}, &alone);
      fuzz::require(dithered[at] == alone, "dithered pixel %zu is %u, not %u", at, dithered[at], alone);
    }
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
