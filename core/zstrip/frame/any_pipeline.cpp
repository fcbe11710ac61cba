// The table of all pipelines, for programs that learn the effects at run time.
#include <utility>

#include "zstrip/frame/pipeline.hpp"

namespace zstrip {
namespace {

/// Every program of this kind may bin: half as many pipelines.
constexpr Effects kAlways = effect::bins;
constexpr std::size_t kPipelines = without(effect::all, kAlways).bits + 1;
static_assert((kPipelines & (kPipelines - 1)) == 0, "the effects below kAlways have no gaps");

template <std::size_t... bits>
constexpr auto table_of(std::index_sequence<bits...>) {
  struct Table {
    Pipeline pipelines[sizeof...(bits)];
  };
  return Table{{{&detail::begin_frame<Effects{bits} | kAlways>, &detail::draw_strip<Effects{bits} | kAlways>}...}};
}

constexpr auto kTable = table_of(std::make_index_sequence<kPipelines>{});

}  // namespace

Pipeline pipeline_for(Effects effects) { return kTable.pipelines[effects.bits & (kPipelines - 1)]; }

}  // namespace zstrip
