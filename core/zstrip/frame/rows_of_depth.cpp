// Pipelines with another format, range or mapping of depth, or with another accuracy of texture coordinates.
#include "zstrip/frame/make_rows.hpp"

namespace zstrip::detail {
namespace {

/// Edges compare codes of z16; shadows need the distance that a code stands for.
constexpr Effects kWithoutEdges = without(kEverything, effect::edges);
constexpr Effects kWithoutShadows = without(kWithoutEdges, effect::shadows);

constexpr auto kRowsOfDepth =
    pipeline_rows<kEverything | effect::perspective_affine, kEverything | effect::perspective_8,
                  kEverything | effect::perspective_1, kWithoutEdges | effect::depth_float,
                  kWithoutEdges | effect::depth_24, kWithoutEdges | effect::depth_24 | effect::orthographic,
                  kWithoutShadows | effect::depth_ranges,
                  kWithoutShadows | effect::depth_ranges | effect::orthographic>();

}  // namespace

std::span<const PipelineRow> rows_of_depth() { return kRowsOfDepth; }

}  // namespace zstrip::detail
