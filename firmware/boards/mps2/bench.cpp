// The benchmark of the workloads, named as in the published comparison with other renderers.
#include "mps2/bench_run.hpp"
#include "zstrip_scenes/character.hpp"
#include "zstrip_scenes/cube.hpp"
#include "zstrip_scenes/knot.hpp"
#include "zstrip_scenes/knot_meshlets.hpp"
#include "zstrip_scenes/random.hpp"
#include "zstrip_scenes/room.hpp"
#include "zstrip_scenes/teapot.hpp"

int main() {
  using namespace zstrip;
  constexpr bench::Workload kWorkloads[] = {{"K5", "z16", bench::run<scenes::knot>},
                                            {"K5M", "z16", bench::run<scenes::knot_meshlets>},
                                            {"CT", "z16", bench::run<scenes::cube>},
                                            {"R50", "z16", bench::run<scenes::random50>},
                                            {"R10k", "z16", bench::run<scenes::random10k>},
                                            {"teapot", "z16", bench::run<scenes::teapot>},
                                            {"room", "z16", bench::run<scenes::room>},
                                            {"K5T", "z16", bench::run<scenes::knot_textured>},
                                            {"character", "z16", bench::run<scenes::character>}};
  return bench::run_bench(kWorkloads);
}
