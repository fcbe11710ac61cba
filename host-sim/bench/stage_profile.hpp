// The instructions of a frame on an emulated core for each stage of the pipeline, by the source file of each
// instruction.
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

/// In the order of a frame; `clear` is for colour and depth. An instruction of the rasterisers belongs to `setup` if it
/// runs at most once for each drawn triangle, to `pixels` if it runs at least once for every eight fragments, and else
/// to `spans`.
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
  Statistics work;  ///< of all frames, counted on the host: triangles and other counts
  std::uint64_t instructions = 0;
  std::map<PipelineStage, std::uint64_t> by_stage;
  std::map<std::string, std::uint64_t> by_source;  ///< file of core/zstrip, or another source
};

/// Runs the case on its board with the counting plugin and finds sources with arm-none-eabi-addr2line. The program must
/// be compiled with -g, as host-sim/bench/stages does. Fails with ExitStatus::environment if one of these is missing.
Result<StageProfile> profile_stages(const BenchCase& bench_case, const std::string& firmware);

/// Returns text for the user: stages with their share, and the instructions for each vertex, triangle or fragment; then
/// the sources.
std::string stage_text(const StageProfile& profile);
/// Returns an array with one object for each profile; bench/README.md documents the keys.
std::string stage_json(const std::vector<StageProfile>& profiles);

}  // namespace zstrip::sim
