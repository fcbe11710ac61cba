// The table of all pipelines, for programs that learn the effects at run time.
#include <utility>

#include "zstrip/frame/pipeline.hpp"

namespace zstrip {
namespace {

template <std::size_t... bits>
constexpr auto table_of(std::index_sequence<bits...>) {
  struct Table {
    Pipeline pipelines[sizeof...(bits)];
  };
  return Table{{{&detail::begin_frame<Effects{bits}>, &detail::draw_strip<Effects{bits}>}...}};
}

constexpr auto kTable = table_of(std::make_index_sequence<effect::all.bits + 1>{});

}  // namespace

Pipeline pipeline_for(Effects effects) { return kTable.pipelines[effects.bits & effect::all.bits]; }

}  // namespace zstrip
