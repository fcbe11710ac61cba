// The Utah teapot turning on the board's OLED. Runs by itself; see host_control.hpp.
#include <array>
#include <cstddef>
#include <cstdint>

#include "cortex_m/console.hpp"
#include "lm3s6965evb/host_control.hpp"
#include "lm3s6965evb/oled_bus.hpp"
#include "zstrip/frame/renderer.hpp"
#include "zstrip_hal/present.hpp"
#include "zstrip_hal/ssd0323.hpp"
#include "zstrip_scenes/stage.hpp"
#include "zstrip_scenes/teapot.hpp"

namespace {

using zstrip::board::OledBus;
using zstrip::board::print;
using zstrip::scenes::teapot;
using Panel = zstrip::hal::Ssd0323<OledBus>;

constexpr std::uint32_t kFramesPerTurn = 64;
constexpr zstrip::View kView{Panel::kWidth, Panel::kHeight, zstrip::PixelFormat::gray4};
constexpr zstrip::Effects kEffects = effects_of(teapot.scene, teapot.camera);
constexpr zstrip::Budget kBudget{.bytes = 40 * 1024};
constexpr zstrip::PlanResult kPlanned = plan(teapot.counts, kView, kEffects, kBudget);
static_assert(kPlanned.status, "the teapot does not fit the budget");
constexpr zstrip::Plan kPlan = kPlanned.plan;

// All the memory of the renderer. The bus is polled: a second strip of pixels would not save any time.
alignas(zstrip::kArenaAlignment) std::array<std::byte, kPlan.bytes()> arena;
std::array<std::byte, kPlan.strip_pixel_bytes(kView)> pixels;
zstrip::Renderer<kEffects> renderer;
zstrip::scenes::Staged staged;

void report(const char* doing, const char* error) {
  print("teapot: ");
  print(doing);
  print(": ");
  print(error);
  print("\n");
}

bool show_frame(Panel& panel, std::uint32_t frame) {
  stage(teapot, staged, frame, kFramesPerTurn, kView);
  if (const zstrip::Status begun = renderer.begin_frame(staged.scene, staged.camera, kView, kPlan, arena); !begun) {
    report("begin of the frame", message(begun.error));
    return false;
  }
  const auto shown = zstrip::hal::present(renderer, panel, {kPlan.strips, kPlan.strip_rows}, {pixels, {}});
  if (!shown.draw) report("drawing", message(shown.draw.error));
  if (shown.display != zstrip::hal::Error::none) report("display", message(shown.display));
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
