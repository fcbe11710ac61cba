// Where a frame's instructions on an emulated core go: stage by stage of the pipeline, by the source that each
// instruction comes from.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "bench/measurement.hpp"
#include "result.hpp"
#include "zstrip/base/statistics.hpp"

namespace zstrip::sim {

/// In the order of a frame; `clear` holds colour and depth. An instruction of the rasterisers belongs to `setup` where
/// it runs at most once a drawn triangle, to `pixels` where it runs at least once for each eighth fragment, and between
/// these to `spans`.
enum class PipelineStage : std::uint8_t {
  begin,
  clear,
  transform,
  shade,
  cull,
  clip,
  setup,
  spans,
  pixels,
  resolve,
  library
};
std::string_view name(PipelineStage stage);

struct StageProfile {
  BenchCase bench_case;
  Statistics work;  ///< of all frames, counted on the host; triangles and so on
  std::uint64_t instructions = 0;
  std::map<PipelineStage, std::uint64_t> by_stage;
  std::map<std::string, std::uint64_t> by_source;  ///< file of core/zstrip, or what else it is
};

/// Runs the case on its board under the counting plugin and finds sources with arm-none-eabi-addr2line: the program
/// must be compiled with -g, as host-sim/bench/stages does. Fails with ExitStatus::environment where something of these
/// is missing.
Result<StageProfile> profile_stages(const BenchCase& bench_case, const std::string& firmware);

/// For people: stages with their share, and what that is for each vertex, triangle or fragment; then the sources.
std::string stage_text(const StageProfile& profile);
/// An array with one object a profile; the keys are documented in bench/README.md.
std::string stage_json(const std::vector<StageProfile>& profiles);

}  // namespace zstrip::sim
