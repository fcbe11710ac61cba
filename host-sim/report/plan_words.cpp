// A plan in words.
#include "report/plan_words.hpp"

#include <fmt/format.h>

#include "report/frame_record.hpp"
#include "report/number.hpp"
#include "visibility/methods.hpp"
#include "zstrip/plan/visibility_bytes.hpp"

namespace zstrip::sim {

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

std::string memory(const Plan& plan, std::uint32_t strip_pixel_bytes, Purpose of_visibility) {
  std::string parts;
  const auto list = [&parts](Purpose purpose, std::uint32_t bytes) {
    if (bytes > 0) parts += fmt::format("{}{} {}", parts.empty() ? "" : ", ", name(purpose), grouped(bytes));
  };
  for (const auto& [purpose, bytes] : by_purpose(plan)) list(purpose, bytes);
  list(of_visibility, plan.visibility_bytes);
  return fmt::format("{} ({}), and {} for the pixels of a strip", counted(plan.bytes(), "byte"), parts,
                     grouped(strip_pixel_bytes));
}

std::string visibility_words(const Plan& plan, Effects method) {
  std::string text = fmt::format("{}: ", visibility_name(method));
  if (plan.visibility_bytes == 0) {
    text += "no memory of its own";
  } else {
    text +=
        fmt::format("{} for {}", counted(plan.visibility_bytes, "byte"),
                    sorts_triangles(method) && method.any(method::bounded) ? "sorting and bounds of depth"
                                                                           : name(detail::visibility_purpose(method)));
  }
  if (method.has(method::painter)) {
    const std::uint64_t cells = std::uint64_t{plan.strip_columns} * plan.strip_rows;
    text += fmt::format(", {} of z-buffer saved", counted(cells * depth_bytes(DepthFormat::z16), "byte"));
  }
  return text;
}

}  // namespace zstrip::sim
