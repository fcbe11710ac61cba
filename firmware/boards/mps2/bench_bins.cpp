// The benchmark with bins. A separate program, so that functions are compiled as in firmware, which has one pipeline.
#include "mps2/bench_run.hpp"
#include "zstrip_scenes/cube.hpp"
#include "zstrip_scenes/knot.hpp"
#include "zstrip_scenes/knot_meshlets.hpp"
#include "zstrip_scenes/random.hpp"
#include "zstrip_scenes/room.hpp"
#include "zstrip_scenes/teapot.hpp"

int main() {
  using namespace zstrip;
  constexpr bench::Workload kWorkloads[] = {{"K5", "z16", bench::run<scenes::knot, effect::bins>},
                                            {"K5M", "z16", bench::run<scenes::knot_meshlets, effect::bins>},
                                            {"CT", "z16", bench::run<scenes::cube, effect::bins>},
                                            {"K5T", "z16", bench::run<scenes::knot_textured, effect::bins>},
                                            {"R50", "z16", bench::run<scenes::random50, effect::bins>},
                                            {"R10k", "z16", bench::run<scenes::random10k, effect::bins>},
                                            {"teapot", "z16", bench::run<scenes::teapot, effect::bins>},
                                            {"room", "z16", bench::run<scenes::room, effect::bins>}};
  return bench::run_bench(kWorkloads);
}
