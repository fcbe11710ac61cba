// Prints, for each effect's scene, "name fragments vertices instances": of a frame, those that the effect touches. Only
// what calls for the effect is drawn, so that nothing hides it.
#include <cstdio>
#include <vector>

#include "plain.hpp"
#include "zstrip/zstrip.hpp"
#include "zstrip_scenes/stage.hpp"

namespace {

using namespace zstrip;
using namespace zstrip::effects_cost;

template <const scenes::BuiltIn& built_in>
int print_affected() {
  constexpr View kPicture = kView<built_in, false>;
  constexpr Effects kCalledFor = effects_of(kPicture) | kChoice<built_in>;
  constexpr Effects kEffects = effects_of(built_in.scene, built_in.camera) | kCalledFor | effect::statistics;
  static Renderer<kEffects> renderer;
  std::uint64_t fragments = 0, vertices = 0, instances = 0;
  for (std::uint32_t frame = 0; frame < kFrames; ++frame) {
    scenes::Staged staged;
    stage(built_in, staged, frame, kFramesPerTurn, kPicture);
    std::vector<Instance> touched;
    for (const Instance& instance : staged.scene.instances) {
      Scene alone = staged.scene;
      alone.instances = {&instance, 1};
      alone.quadrics = {};
      alone.lines = {};
      constexpr Effects kOwn = kKeepsLight<built_in> ? effect::pixel_shading : kTaken<built_in>;
      if ((effects_of(alone, staged.camera) | kCalledFor).any(kOwn)) touched.push_back(instance);
    }
    staged.scene.instances = touched;
    instances += touched.size();
    for (const Instance& instance : touched) vertices += staged.scene.meshes[instance.mesh].positions.size();
    const Plan plan = zstrip::plan(built_in.counts, kPicture, kEffects, {.strip_rows = kPicture.height}).plan;
    std::vector<std::uint64_t> arena(plan.bytes() / 8 + 1), pixels(plan.strip_pixel_bytes(kPicture) / 8 + 1);
    if (!renderer.begin_frame(staged.scene, staged.camera, kPicture, plan, std::as_writable_bytes(std::span(arena))) ||
        !renderer.draw_strip(0, std::as_writable_bytes(std::span(pixels)))) {
      return 1;
    }
    // A format is that of every pixel, and every pixel has samples; each edge is looked at.
    std::size_t edges = 0;
    for (const EdgeSet& set : built_in.scene.edges) edges += set.edges.size();
    fragments += edges != 0 ? edges
                 : kCalledFor.any(effect::dithered_format | effect::supersampled)
                     ? std::uint32_t{kWidth} * kHeight
                     : renderer.frame().statistics().fragments;
  }
  const auto of_a_frame = [](std::uint64_t count) { return static_cast<unsigned long long>(count / kFrames); };
  std::printf("%s %llu %llu %llu\n", built_in.name, of_a_frame(fragments), of_a_frame(vertices), of_a_frame(instances));
  return 0;
}

}  // namespace

int main() {
  return print_affected<scenes::lit>() + print_affected<scenes::smooth>() + print_affected<scenes::textured>() +
         print_affected<scenes::affine>() + print_affected<scenes::every_8>() + print_affected<scenes::every_pixel>() +
         print_affected<scenes::coarse>() + print_affected<scenes::by_table>() + print_affected<scenes::fog>() +
         print_affected<scenes::emissive>() + print_affected<scenes::specular>() + print_affected<scenes::punctual>() +
         print_affected<scenes::mask>() + print_affected<scenes::blend>() + print_affected<scenes::bilinear>() +
         print_affected<scenes::palette>() + print_affected<scenes::mipmaps>() + print_affected<scenes::environment>() +
         print_affected<scenes::per_pixel>() + print_affected<scenes::spheres>() + print_affected<scenes::dithered>() +
         print_affected<scenes::dithered_mono>() + print_affected<scenes::lines>() +
         print_affected<scenes::billboards>() + print_affected<scenes::outlines>() + print_affected<scenes::shadows>() +
         print_affected<scenes::csg>() + print_affected<scenes::edges>() + print_affected<scenes::samples_2>() +
         print_affected<scenes::samples_4>();
}
