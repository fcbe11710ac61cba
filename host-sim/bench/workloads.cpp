// The table of workloads.
#include "bench/workloads.hpp"

#include <algorithm>
#include <array>

namespace zstrip::sim {
namespace {

constexpr std::array kWorkloads{
    Workload{"K5", "knot", "a knot of 5120 small Gouraud triangles: transform and set-up", 320, 240},
    Workload{"K5M", "knot_meshlets", "the same knot in 64 meshlets", 320, 240},
    Workload{"K5T", "knot_textured", "that knot, textured and lit", 320, 240},
    Workload{"CT", "cube", "a textured cube that fills the picture: fill rate", 320, 240},
    Workload{"R50", "random50", "50 large flat triangles, no culling", 640, 480},
    Workload{"R10k", "random10k", "10000 small flat triangles, no culling", 640, 480},
    Workload{"teapot", "teapot", "the Utah teapot, lit: medium Gouraud triangles", 320, 240},
    Workload{"room", "room", "a lit, textured room that the camera stands in", 320, 240},
};

}  // namespace

std::span<const Workload> workloads() { return kWorkloads; }

const Workload* find_workload(std::string_view name) {
  const auto* found = std::ranges::find(kWorkloads, name, &Workload::name);
  return found == kWorkloads.end() ? nullptr : found;
}

}  // namespace zstrip::sim
