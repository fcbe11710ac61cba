// Draws frames of a workload, each as many times as it is told, and prints nothing: two runs differ by what drawing
// takes. workloads WORKLOAD WIDTHxHEIGHT FRAMES TIMES. Exit status: 0 drawn, 2 the words are wrong, 1 anything else.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <span>
#include <string_view>
#include <vector>

#include "zstrip/renderer.hpp"
#include "zstrip_scenes/character.hpp"
#include "zstrip_scenes/cube.hpp"
#include "zstrip_scenes/knot.hpp"
#include "zstrip_scenes/knot_meshlets.hpp"
#include "zstrip_scenes/random.hpp"
#include "zstrip_scenes/room.hpp"
#include "zstrip_scenes/stage.hpp"
#include "zstrip_scenes/teapot.hpp"

namespace {

using namespace zstrip;

template <const scenes::BuiltIn& built_in>
Status draw(const View& view, std::uint32_t frames, std::uint32_t times) {
  constexpr Effects kEffects = effects_of(built_in.scene, built_in.camera);
  static Renderer<kEffects> renderer;
  static scenes::Staged staged;
  const auto [status, plan] = zstrip::plan(built_in.counts, view, kEffects, {.modes = Modes::streamed});
  if (!status) return status;
  std::vector<std::uint64_t> arena(plan.bytes() / sizeof(std::uint64_t) + 1);
  std::vector<std::byte> pixels(plan.strip_pixel_bytes(view));
  for (std::uint32_t draws = 0; draws < frames * times; ++draws) {
    if (draws % times == 0) stage_workload(built_in, staged, draws / times);
    Status drawn{};
    if (built_in.pose != nullptr) drawn = built_in.pose(draws / times);
    if (!drawn) return drawn;
    drawn = renderer.begin_frame(staged.scene, staged.camera, view, plan, std::as_writable_bytes(std::span(arena)));
    for (std::uint16_t strip = 0; drawn && strip < plan.strips; ++strip) drawn = renderer.draw_strip(strip, pixels);
    if (!drawn) return drawn;
  }
  return status;
}

struct Workload {
  std::string_view name;
  Status (*draw)(const View&, std::uint32_t frames, std::uint32_t times);
};
constexpr Workload kWorkloads[] = {{"K5", draw<scenes::knot>},           {"CT", draw<scenes::cube>},
                                   {"R50", draw<scenes::random50>},      {"R10k", draw<scenes::random10k>},
                                   {"teapot", draw<scenes::teapot>},     {"room", draw<scenes::room>},
                                   {"K5T", draw<scenes::knot_textured>}, {"character", draw<scenes::character>}};

}  // namespace

int main(int count, char** words) {
  View view{.width = 0, .height = 0, .format = PixelFormat::rgb565};
  unsigned frames = 0, times = 0;
  if (count != 5 || std::sscanf(words[2], "%hux%hu", &view.width, &view.height) != 2 ||
      std::sscanf(words[3], "%u", &frames) != 1 || std::sscanf(words[4], "%u", &times) != 1 || times == 0) {
    return 2;
  }
  for (const Workload& workload : kWorkloads) {
    if (workload.name == words[1]) return workload.draw(view, frames, times) ? 0 : 1;
  }
  return 2;
}
