// Aprons of strips; see apron.hpp. Only renderers with effect::edges link it.
#include "zstrip/effects/edges/apron.hpp"

namespace zstrip::detail::edges {

Status check_request(const FrameRequest& request) {
  const View& view = request.view;
  const Plan& plan = request.plan;
  if (view.samples != 1 || request.called_for.any(effect::outlines | effect::csg)) {
    return {.error = Error::edges};
  }
  const std::uint64_t cells = cells_with_apron(plan.strip_rows, plan.strip_columns, view);
  if (plan.depth_bytes < cells * kDepthBytes) return too_small(Purpose::depth, cells * kDepthBytes, plan.depth_bytes);
  const std::uint64_t colour = colour_bytes_of_edges(plan.strip_rows, plan.strip_columns, view);
  return plan.colour_bytes < colour ? too_small(Purpose::colour, colour, plan.colour_bytes) : Status{};
}

Status check_saved(const FrameRequest& request) {
  const Plan& plan = request.plan;
  const std::uint64_t colour = colour_bytes_of_edges(plan.strip_rows, plan.strip_columns, request.view) +
                               saved_bytes_of_edges(plan.strip_rows, plan.strip_columns, request.view);
  return plan.colour_bytes < colour ? too_small(Purpose::colour, colour, plan.colour_bytes) : Status{};
}

void copy_without_apron(const std::uint16_t* from, const Rect& drawn, std::uint16_t* to, const Rect& area) {
  const auto width = static_cast<std::size_t>(area.width());
  from += (area.top - drawn.top) * drawn.width() + (area.left - drawn.left);
  for (std::int32_t row = 0; row < area.height(); ++row, from += drawn.width(), to += width) {
    __builtin_memcpy(to, from, width * sizeof(std::uint16_t));
  }
}

}  // namespace zstrip::detail::edges
