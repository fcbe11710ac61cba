// Plans a workload and keeps its memory.
#include "bench/drawing.hpp"

#include <fmt/format.h>

#include "bench/workloads.hpp"
#include "text/number.hpp"

namespace zstrip::sim {

Result<Drawing> Drawing::prepare(const BenchCase& bench_case) {
  const scenes::BuiltIn* built_in = find_workload(bench_case.workload)->built_in();
  const Effects effects = effects_of(built_in->scene, built_in->camera) | effect::bins;
  const auto [status, plan] = zstrip::plan(built_in->counts, bench_case.view, effects, bench_case.budget);
  if (status.error == Error::arena_too_small) {
    return Failure{ExitStatus::budget,
                   fmt::format("{} needs {}, most of them for {}, and --ram allows {}", bench_case.workload,
                               counted(status.needed, "byte"), name(status.purpose), grouped(status.available))};
  }
  if (status.error == Error::unplannable) {
    return Failure{ExitStatus::usage, fmt::format("{} cannot be planned: {}; ask for larger strips",
                                                  bench_case.workload, message(status.error))};
  }
  if (!status) {
    return Failure{ExitStatus::usage,
                   fmt::format("{} cannot be planned: {} ({} given, at most {})", bench_case.workload,
                               message(status.error), status.needed, status.available)};
  }
  return Drawing(bench_case, *built_in, effects, plan);
}

Drawing::Drawing(const BenchCase& bench_case, const scenes::BuiltIn& built_in, Effects effects, const Plan& plan)
    : built_in_(&built_in),
      staged_(std::make_unique<scenes::Staged>()),
      view_(bench_case.view),
      plan_(plan),
      renderer_(effects),
      arena_((plan.bytes() + sizeof(std::uint64_t) - 1) / sizeof(std::uint64_t)),
      pixels_(plan.strip_pixel_bytes(bench_case.view)) {}

void Drawing::stage(std::uint32_t frame) {
  frame_ = frame;
  scenes::stage_workload(*built_in_, *staged_, frame);
}

std::size_t Drawing::strip_bytes(std::uint16_t strip) const {
  const Rect area = plan_.strip_area(strip, view_);
  return static_cast<std::size_t>(area.height()) *
         bytes_per_row(static_cast<std::uint16_t>(area.width()), view_.format);
}

}  // namespace zstrip::sim
