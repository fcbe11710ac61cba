// Measures the cost of the visibility methods: a closed mesh of small triangles, texels that fill the picture, a room,
// and objects one behind another, each with the plain z-buffer and with the methods. The word `depth` names the
// method.
#include "mps2/bench_run.hpp"
#include "zstrip/visibility.hpp"
#include "zstrip_scenes/cube.hpp"
#include "zstrip_scenes/knot.hpp"
#include "zstrip_scenes/knot_meshlets.hpp"
#include "zstrip_scenes/room.hpp"

namespace zstrip::scenes {
namespace {

consteval Instance behind(double distance) {
  Instance instance{};
  instance.transform.m[2][3] = -fixed(distance);
  return instance;
}

/// Four knots, the farthest first: later ones hide much of the earlier ones.
constexpr Instance kCrowdInstances[] = {behind(3), behind(2), behind(1), behind(0)};
constexpr Scene kCrowdScene{.meshes = kKnotTexturedMesh,
                            .materials = kKnotTexturedMaterial,
                            .textures = kKnotTexture,
                            .instances = kCrowdInstances,
                            .lights = kKeyLight,
                            .ambient = kAmbient};
constexpr SceneCounts kCrowdCounts{.instances = 4,
                                   .triangles = 4 * knot_textured.counts.triangles,
                                   .vertices = 4 * knot_textured.counts.vertices,
                                   .largest_meshlet = knot_textured.counts.largest_meshlet,
                                   .meshlets = 4 * knot_textured.counts.meshlets,
                                   .longest_meshlet = knot_textured.counts.longest_meshlet};
constexpr BuiltIn crowd{.name = "crowd",
                        .description = "four textured knots",
                        .scene = kCrowdScene,
                        .counts = kCrowdCounts,
                        .camera = knot_textured.camera,
                        .focal_across = knot_textured.focal_across};

}  // namespace
}  // namespace zstrip::scenes

int main() {
  using namespace zstrip;
  constexpr bench::Workload kWorkloads[] = {
      {"K5", "zbuffer", bench::run<scenes::knot>},
      {"K5", "front-to-back", bench::run<scenes::knot, method::front_to_back>},
      {"K5", "hierarchical-z", bench::run<scenes::knot, method::hierarchical_z>},
      {"K5", "painter", bench::run<scenes::knot, method::painter>},
      {"K5", "midpoint-safe", bench::run<scenes::knot, method::midpoint_safe>},
      {"CT", "zbuffer", bench::run<scenes::cube>},
      {"CT", "front-to-back", bench::run<scenes::cube, method::front_to_back>},
      {"CT", "hierarchical-z", bench::run<scenes::cube, method::hierarchical_z>},
      {"CT", "painter", bench::run<scenes::cube, method::painter>},
      {"CT", "midpoint-safe", bench::run<scenes::cube, method::midpoint_safe>},
      {"room", "zbuffer", bench::run<scenes::room>},
      {"room", "front-to-back", bench::run<scenes::room, method::front_to_back>},
      {"room", "hierarchical-z", bench::run<scenes::room, method::hierarchical_z>},
      {"room", "painter", bench::run<scenes::room, method::painter>},
      {"room", "midpoint-safe", bench::run<scenes::room, method::midpoint_safe>},
      {"crowd", "zbuffer", bench::run<scenes::crowd>},
      {"crowd", "front-to-back", bench::run<scenes::crowd, method::front_to_back>},
      {"crowd", "hierarchical-z", bench::run<scenes::crowd, method::hierarchical_z>},
      {"crowd", "painter", bench::run<scenes::crowd, method::painter>},
      {"crowd", "midpoint-safe", bench::run<scenes::crowd, method::midpoint_safe>}};
  return bench::run_bench(kWorkloads);
}
