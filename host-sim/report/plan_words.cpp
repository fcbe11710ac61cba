// A plan in words.
#include "report/plan_words.hpp"

#include <fmt/format.h>

#include "report/frame_record.hpp"
#include "text/number.hpp"
#include "visibility/methods.hpp"
#include "zstrip/effects/list.hpp"
#include "zstrip/visibility/memory.hpp"

namespace zstrip::sim {
namespace {

/// Returns the purpose of a method's bytes.
std::string_view purpose_of(Effects method) {
  if (sorts_triangles(method) && method.any(method::bounded)) return "sorting and bounds of depth";
  return name(detail::visibility_purpose(method));
}

}  // namespace

std::string shape(const Plan& plan, const View& view) {
  const std::string strips =
      plan.strip_columns == view.width
          ? fmt::format("{} of {}", counted(plan.strips, "strip"), counted(plan.strip_rows, "row"))
          : fmt::format("{} of {}x{}", counted(plan.strips, "strip"), plan.strip_columns, plan.strip_rows);
  return fmt::format("{}, {}", name(plan.mode), strips);
}

std::array<std::pair<Purpose, std::uint32_t>, 7> by_purpose(const Plan& plan) {
  return {{{Purpose::instances, plan.instance_bytes},
           {Purpose::extents, plan.extent_bytes},
           {Purpose::vertices, plan.vertex_bytes},
           {Purpose::depth, plan.depth_bytes},
           {Purpose::colour, plan.colour_bytes},
           {Purpose::bins, plan.bin_bytes},
           {Purpose::effects, plan.effect_bytes}}};
}

std::string memory(const Plan& plan, std::uint32_t strip_pixel_bytes, Effects method) {
  std::string parts;
  const auto list = [&parts](std::string_view purpose, std::uint32_t bytes) {
    if (bytes > 0) parts += fmt::format("{}{} {}", parts.empty() ? "" : ", ", purpose, grouped(bytes));
  };
  for (const auto& [purpose, bytes] : by_purpose(plan)) list(name(purpose), bytes);
  list(purpose_of(method), plan.visibility_bytes);
  return fmt::format("{} ({}), and {} for the pixels of a strip", counted(plan.bytes(), "byte"), parts,
                     grouped(strip_pixel_bytes));
}

std::string visibility_words(const Plan& plan, Effects method) {
  std::string text = fmt::format("{}: ", visibility_name(method));
  if (plan.visibility_bytes == 0) {
    text += "no memory of its own";
  } else {
    text += fmt::format("{} for {}", counted(plan.visibility_bytes, "byte"), purpose_of(method));
  }
  if (method.has(method::painter)) {
    const std::uint64_t cells = std::uint64_t{plan.strip_columns} * plan.strip_rows;
    text += fmt::format(", {} of z-buffer saved", counted(cells * depth_bytes(DepthFormat::z16), "byte"));
  }
  return text;
}

std::vector<std::string> left_out_of_estimates(Effects effects) {
  constexpr Effects kPriced = effect::lighting | effect::gouraud | effect::vertex_colours | effect::textures |
                              effect::two_sided | effect::skins | effect::supersampled | effect::bins |
                              effect::fragments | effect::vertex_light | effect::environment | effect::outlines |
                              effect::shadows | effect::quadrics | effect::lines | effect::edges |
                              effect::dithered_format;
  constexpr Effects kNearlyFree = effect::orthographic | effect::depth_state | effect::billboards | effect::unclipped;
  std::vector<std::string> names;
  for (const EffectName& known : kEffectNames) {
    if (without(effects, kPriced | kNearlyFree).has(known.effect)) names.emplace_back(known.name);
  }
  return names;
}

}  // namespace zstrip::sim
