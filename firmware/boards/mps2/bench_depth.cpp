// Measures the cost of depth: R50, nearly all of it flat fragments, with each way to store depth. It is a separate
// program, so that its functions are compiled as in firmware, which has one pipeline.
#include "mps2/bench_run.hpp"
#include "zstrip_scenes/random.hpp"

int main() {
  using namespace zstrip;
  constexpr bench::Workload kWorkloads[] = {
      {"R50", "z16", bench::run<scenes::random50>},
      {"R50", "state", bench::run<scenes::random50, effect::depth_state>},
      {"R50", "ranges", bench::run<scenes::random50, effect::depth_ranges>},
      {"R50", "float", bench::run<scenes::random50, effect::depth_float>},
      {"R50", "z24", bench::run<scenes::random50, effect::depth_24>},
  };
  return bench::run_bench(kWorkloads);
}
