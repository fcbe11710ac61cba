// The benchmark's workloads that are also counted on RISC-V.
#include "mps2/bench_run.hpp"
#include "zstrip_scenes/character.hpp"
#include "zstrip_scenes/cube.hpp"
#include "zstrip_scenes/knot.hpp"
#include "zstrip_scenes/knot_meshlets.hpp"

int main() {
  using namespace zstrip;
  board::paint_stack();
  constexpr bench::Workload kWorkloads[] = {{"K5", "z16", bench::run<scenes::knot>},
                                            {"CT", "z16", bench::run<scenes::cube>},
                                            {"K5T", "z16", bench::run<scenes::knot_textured>},
                                            {"character", "z16", bench::run<scenes::character>}};
  return bench::run_bench(kWorkloads);
}
