// The table of the pipelines that most scenes need, for programs that learn the effects at run time.
#include <utility>

#include "zstrip/frame/pipelines_with_effects.hpp"

namespace zstrip {
namespace {

/// Light and vertex colours are one choice here: what an instance has of them is decided for each of them anyway.
constexpr Effects kColours = effect::lighting | effect::vertex_colours;
constexpr Effects kChoices[] = {effect::textures, effect::orthographic, effect::statistics};
/// Nothing, colours of triangles, colours of vertices.
constexpr Effects kShades[] = {Effects{}, kColours, kColours | effect::gouraud};
constexpr std::size_t kSets = std::size(kShades) << std::size(kChoices);

constexpr Effects set_at(std::size_t index) {
  Effects effects = kShades[index >> std::size(kChoices)] | effect::bins;
  for (std::size_t i = 0; i < std::size(kChoices); ++i) {
    if (((index >> i) & 1U) != 0) effects = effects | kChoices[i];
  }
  return effects;
}

/// Of effects that the table knows.
constexpr std::size_t index_of(Effects effects) {
  std::size_t index = effects.has(effect::gouraud) ? 2 : effects.any(kColours) ? 1 : 0;
  index <<= std::size(kChoices);
  for (std::size_t i = 0; i < std::size(kChoices); ++i) {
    if (effects.has(kChoices[i])) index |= std::size_t{1} << i;
  }
  return index;
}

constexpr bool table_has_every_set() {
  for (std::uint64_t bits = 0; bits <= effect::all.bits; ++bits) {
    if (!set_at(index_of(Effects{bits})).has(Effects{bits})) return false;
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

constexpr Pipeline kRefusing{
    [](Frame&, const Scene&, const Camera&, const View&, const Plan&, std::span<std::byte>) {
      return Status{.error = Error::depth_effects};
    },
    [](Frame&, std::uint16_t, std::span<std::byte>) { return Status{.error = Error::not_begun}; },
    [](Frame&, const Rect&, std::span<std::uint16_t>, std::span<std::uint16_t>) {
      return Status{.error = Error::not_begun};
    }};

}  // namespace

Pipeline pipeline_for(Effects effects) {
  if (effects.methods != 0) return pipeline_of_method(effects);
  if (!depth_effects_agree(effects) || !perspective_effects_agree(effects)) return kRefusing;
  // Without perspective, or without textures, all of them draw the same.
  if (effects.has(effect::orthographic) || !effects.has(effect::textures)) {
    effects = without(effects, effect::perspective_runs);
  }
  if (effects.any(detail::kBeyondTable)) {
    const Pipeline* const found = detail::pipeline_with_effects(effects);
    return found != nullptr ? *found : kRefusing;
  }
  return kTable.pipelines[index_of(effects)];
}

}  // namespace zstrip
