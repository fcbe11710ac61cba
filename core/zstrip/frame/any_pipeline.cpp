// The table of the pipelines that most scenes need, for programs that learn the effects at run time.
#include <iterator>
#include <utility>

#include "zstrip/frame/pipelines_with_effects.hpp"

namespace zstrip {
namespace {

constexpr Effects kColours = effect::lighting | effect::vertex_colours;
/// How a triangle gets its colours; exact sets, because a pipeline that has to ask which it is costs R10k 2 %.
constexpr Effects kShades[] = {Effects{},
                               effect::lighting,
                               effect::vertex_colours,
                               kColours,
                               effect::lighting | effect::gouraud,
                               effect::vertex_colours | effect::gouraud,
                               kColours | effect::gouraud};
constexpr std::size_t kMostShading = std::size(kShades) - 1;
/// Counting slows down anyway, and parallel rays are seldom: one pipeline is for all shades.
constexpr Effects kRare[] = {effect::statistics, effect::orthographic, effect::statistics | effect::orthographic};
constexpr std::size_t kSets = (std::size(kShades) + std::size(kRare)) * 2;

constexpr Effects set_at(std::size_t index) {
  const std::size_t row = index / 2;
  const Effects effects =
      row < std::size(kShades) ? kShades[row] : kShades[kMostShading] | kRare[row - std::size(kShades)];
  return effects | effect::bins | ((index & 1U) != 0 ? effect::textures : Effects{});
}

/// Of effects that the table knows.
constexpr std::size_t index_of(Effects effects) {
  std::size_t row = 0;
  if (effects.any(effect::statistics | effect::orthographic)) {
    row = std::size(kShades);
    while (kRare[row - std::size(kShades)] != (effects & (effect::statistics | effect::orthographic))) ++row;
  } else {
    while (without(effects, kShades[row]).any(kColours | effect::gouraud)) ++row;
  }
  return row * 2 + (effects.has(effect::textures) ? 1 : 0);
}

constexpr bool table_has_every_set() {
  for (std::uint64_t bits = 0; bits <= effect::all.bits; ++bits) {
    const Effects effects{bits}, found = set_at(index_of(effects));
    if (!found.has(effects) || (found & effect::orthographic) != (effects & effect::orthographic)) return false;
  }
  return true;
}
static_assert(table_has_every_set());

template <std::size_t... index>
constexpr auto table_of(std::index_sequence<index...>) {
  struct Table {
    Pipeline pipelines[sizeof...(index)];
  };
  return Table{{detail::pipeline<set_at(index)>()...}};
}

constexpr auto kTable = table_of(std::make_index_sequence<kSets>{});

}  // namespace

Pipeline pipeline_for(Effects effects) {
  if (effects.methods != 0) return pipeline_of_method(effects);
  if (!depth_effects_agree(effects) || !perspective_effects_agree(effects))
    return detail::refusing<Error::depth_effects>();
  // Without perspective, or without textures, all of them draw the same.
  if (effects.has(effect::orthographic)) effects = without(effects, effect::short_reciprocals);
  if (effects.has(effect::orthographic) || !effects.has(effect::textures)) {
    effects = without(effects, effect::perspective_runs);
  }
  if (effects.any(detail::kBeyondTable)) {
    const Pipeline* const found = detail::pipeline_with_effects(effects);
    return found != nullptr ? *found : detail::refusing<Error::depth_effects>();
  }
  return kTable.pipelines[index_of(effects)];
}

}  // namespace zstrip
