// A scene of one's own, baked by `zstrip bake`, animated or turning on the board's OLED: ZSTRIP_SCENE names its header.
// Runs by itself; see host_control.hpp.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>

#include "baked_scene.hpp"
#include "cortex_m/console.hpp"
#include "lm3s6965evb/host_control.hpp"
#include "lm3s6965evb/oled_bus.hpp"
#include "zstrip/frame/renderer.hpp"
#include "zstrip_hal/present.hpp"
#include "zstrip_hal/ssd0323.hpp"
#include "zstrip_scenes/stage.hpp"

namespace {

using zstrip::board::OledBus;
using zstrip::board::print;
using Panel = zstrip::hal::Ssd0323<OledBus>;

constexpr std::uint32_t kFramesPerTurn = 64;
static_assert(baked::kView.width == Panel::kWidth && baked::kView.height == Panel::kHeight &&
                  baked::kView.format == zstrip::PixelFormat::gray4,
              "bake for this display: --size 128x64 --format gray4");
static_assert(baked::kPlan.strip_columns == Panel::kWidth, "bake without --split-columns and --strip-columns");

// All the memory of the renderer. The bus is polled: a second strip of pixels would not save any time.
alignas(zstrip::kArenaAlignment) std::array<std::byte, baked::kPlan.bytes()> arena;
std::array<std::byte, baked::kPlan.strip_pixel_bytes(baked::kView)> pixels;
zstrip::Renderer<baked::kEffects> renderer;
// What moves lies in RAM; everything else stays in flash.
std::array<zstrip::Instance, std::size(baked::kInstances)> instances;

void report(const char* doing, const char* error) {
  print("scene: ");
  print(doing);
  print(": ");
  print(error);
  print("\n");
}

/// The scene's animation in as many frames as a turn has; what has none turns.
void move(std::uint32_t frame) {
  if constexpr (!baked::kAnimation.tracks.empty()) {
    if (frame == 0) std::copy(std::begin(baked::kInstances), std::end(baked::kInstances), instances.begin());
    pose(baked::kAnimation, zstrip::time_of_frame(baked::kAnimation, frame, kFramesPerTurn), instances);
  } else {
    std::transform(std::begin(baked::kInstances), std::end(baked::kInstances), instances.begin(),
                   [frame](zstrip::Instance instance) {
                     instance.transform = zstrip::scenes::turned(instance.transform, frame, kFramesPerTurn);
                     return instance;
                   });
  }
}

bool show_frame(Panel& panel, std::uint32_t frame) {
  move(frame);
  zstrip::Scene scene = baked::kScene;
  scene.instances = instances;
  const zstrip::Status begun = renderer.begin_frame(scene, baked::kCamera, baked::kView, baked::kPlan, arena);
  if (!begun) {
    report("begin of the frame", message(begun.error));
    return false;
  }
  const auto shown =
      zstrip::hal::present(renderer, panel, {baked::kPlan.strips, baked::kPlan.strip_rows}, {pixels, {}});
  if (!shown.draw) report("drawing", message(shown.draw.error));
  if (shown.display != zstrip::hal::Error::none) report("display", zstrip::hal::message(shown.display));
  return static_cast<bool>(shown);
}

}  // namespace

int main() {
  static OledBus bus;
  bus.start();
  Panel panel(bus);
  if (const zstrip::hal::Error error = panel.start(); error != zstrip::hal::Error::none) {
    report("start of the display", zstrip::hal::message(error));
    return 1;
  }
  zstrip::board::HostControl control;
  for (std::uint32_t frame = 0;; frame = (frame + 1) % kFramesPerTurn) {
    if (!show_frame(panel, frame)) return 1;
    control.frame_shown(frame);
  }
}
