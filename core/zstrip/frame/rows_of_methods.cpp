// Pipelines with a visibility method and all that it does not refuse; they can count and cull.
#include "zstrip/effects/exclusions.hpp"
#include "zstrip/frame/make_rows.hpp"

namespace zstrip::detail {
namespace {

template <Effects method>
constexpr Effects everything_with() {
  constexpr Effects kAll = kEverything | method::culling | method;
  return without(kAll, refused_by_methods(kAll));
}
template <Effects... methods>
constexpr auto rows() {
  return pipeline_rows<everything_with<methods>()..., everything_with<methods>() | effect::orthographic...>();
}

/// The first is culling alone.
constexpr auto kRowsOfMethods =
    rows<Effects{}, method::painter, method::painter | method::in_order, method::painter | method::bsp,
         method::front_to_back, method::hierarchical_z, method::front_to_back | method::hierarchical_z,
         method::midpoint, method::midpoint_safe>();

}  // namespace

std::span<const PipelineRow> rows_of_methods() { return kRowsOfMethods; }

}  // namespace zstrip::detail
