// The list of supersets, the smallest first.
#include "zstrip/frame/pipelines_with_effects.hpp"

namespace zstrip::detail {
namespace {

constexpr Effects kEverything = without(effect::of_scenes, effect::orthographic) | effect::statistics | effect::bins;
/// With another depth than that of edges.
constexpr Effects kWithoutEdges = without(kEverything, effect::edges);
/// With a depth that shadows cannot ask, either.
constexpr Effects kWithoutShadows = without(kWithoutEdges, effect::shadows);
constexpr Effects kTriangles = without(effect::all, effect::orthographic) | effect::bins;

struct Superset {
  Effects effects;
  Pipeline pipeline;
};

template <Effects effects>
constexpr Superset superset() {
  return {effects, pipeline<effects>()};
}

/// A set is drawn by the first that has all of it and the same way to keep depth and projection.
constexpr Superset kSupersets[] = {
    superset<kTriangles | effect::perspective_affine>(),
    superset<kTriangles | effect::perspective_8>(),
    superset<kTriangles | effect::perspective_1>(),
    superset<kTriangles | effect::coarse_reciprocal>(),
    superset<kTriangles | effect::table_reciprocal>(),
    superset<kEverything>(),
    superset<kEverything | effect::orthographic>(),
    superset<kEverything | effect::perspective_affine>(),
    superset<kEverything | effect::perspective_8>(),
    superset<kEverything | effect::perspective_1>(),
    superset<kWithoutEdges | effect::depth_float>(),
    superset<kWithoutShadows | effect::coarse_reciprocal>(),
    superset<kWithoutShadows | effect::table_reciprocal>(),
    superset<kWithoutShadows | effect::depth_w16>(),
    superset<kWithoutEdges | effect::depth_24>(),
    superset<kWithoutEdges | effect::depth_24 | effect::orthographic>(),
    superset<kWithoutEdges | effect::depth_32>(),
    superset<kWithoutEdges | effect::depth_32 | effect::orthographic>(),
    superset<kWithoutShadows | effect::depth_ranges>(),
    superset<kWithoutShadows | effect::depth_ranges | effect::orthographic>(),
};

constexpr Effects kMustBeEqual = effect::orthographic | effect::depth_formats | effect::depth_ranges |
                                 effect::perspective_runs | effect::short_reciprocals;

}  // namespace

const Pipeline* pipeline_with_effects(Effects effects) {
  const Effects fixed = effects & kMustBeEqual;
  for (const Superset& candidate : kSupersets) {
    if (candidate.effects.has(effects) && (candidate.effects & kMustBeEqual) == fixed) return &candidate.pipeline;
  }
  return nullptr;
}

}  // namespace zstrip::detail
