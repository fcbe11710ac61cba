// The pipelines with which visibility methods are measured: most scenes, without statistics.
#include "zstrip/visibility/make_rows.hpp"

namespace zstrip::detail {
namespace {

constexpr Effects kOfTriangles = without(effect::all, effect::orthographic | effect::statistics);
constexpr auto kRows =
    pipeline_rows<kOfTriangles | method::painter, kOfTriangles | method::front_to_back,
                  kOfTriangles | method::hierarchical_z, kOfTriangles | method::front_to_back | method::hierarchical_z,
                  kOfTriangles | method::midpoint, kOfTriangles | method::midpoint_safe>();

}  // namespace

std::span<const PipelineRow> rows_of_measured_methods() { return kRows; }

}  // namespace zstrip::detail
