// A room that is drawn once and stored compressed, and a teapot that flies through it: each frame draws and sends to
// the OLED only the tiles that the teapot leaves or reaches. Runs without a host; see host_control.hpp.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "cortex_m/console.hpp"
#include "lm3s6965evb/oled_bus.hpp"
#include "portable/host_control.hpp"
#include "portable/pacing.hpp"
#include "zstrip/layer.hpp"
#include "zstrip/plan.hpp"
#include "zstrip/renderer.hpp"
#include "zstrip/resolve/convert.hpp"
#include "zstrip_hal/ssd0323.hpp"
#include "zstrip_scenes/showroom.hpp"

namespace {

using zstrip::board::print;
using Panel = zstrip::hal::Ssd0323<zstrip::board::OledBus>;
using namespace zstrip;
using namespace zstrip::scenes;

constexpr std::uint32_t kFramesPerFlight = 64;
constexpr View kView{Panel::kWidth, Panel::kHeight, PixelFormat::rgb565};  // converted when it is sent
constexpr Instance kAnyTeapot[] = {{.mesh = kShowroomTeapotMesh, .material = kShowroomTeapotMaterial}};
// One pipeline for both layers.
constexpr Effects kEffects =
    effects_of(kShowroomBackground, kShowroomCamera) | effects_of(showroom_scene(kAnyTeapot), kShowroomCamera);
constexpr LayerBytes kLayer = layer_bytes(kView, 6 * 1024, 8 * 1024);
constexpr PlanResult kBackground = plan(count(kShowroomBackground), kView, kEffects,
                                        {.strip_rows = quality::balanced.budget.strip_rows, .layer = kLayer});
constexpr PlanResult kMoving = plan(kShowroomTeapotCounts, kView, kEffects, {.strip_rows = 8});
static_assert(kBackground.status && kMoving.status);

constexpr std::uint32_t kCells = 16 * 64;  // pixels of the largest rectangle that is drawn at once

// The plans of both layers share the arena, one after the other.
alignas(kArenaAlignment) std::array<std::byte, std::max(kBackground.plan.bytes(), kMoving.plan.bytes())> arena;
alignas(4) std::array<std::byte, kBackground.plan.strip_pixel_bytes(kView)> strip_pixels;
alignas(4) std::array<std::byte, kLayer.depth> depth_pool;
alignas(4) std::array<std::byte, kLayer.colour> colour_pool;
std::array<std::uint32_t, kLayer.dirty / sizeof(std::uint32_t)> dirty_words;
std::array<std::uint16_t, kCells> pixels, depth;
std::array<std::byte, kCells / 2> sent;  // two pixels a byte
Renderer<kEffects> renderer;
StaticLayer layer;

bool report(const char* doing, const char* error) {
  print("layers: ");
  print(doing);
  print(": ");
  print(error);
  print("\n");
  return false;
}
bool succeeded(const char* doing, const Status& status) { return status || report(doing, message(status.error)); }
bool succeeded(const char* doing, hal::Error error) {
  return error == hal::Error::none || report(doing, hal::message(error));
}

bool keep_background() {
  if (!succeeded("memory of the layer", layer.reset({depth_pool, colour_pool, dirty_words}, kView))) return false;
  const Status begun = renderer.begin_frame(kShowroomBackground, kShowroomCamera, kView, kBackground.plan, arena);
  if (!succeeded("begin of the background", begun)) return false;
  for (std::uint16_t strip = 0; strip < kBackground.plan.strips; ++strip) {
    if (!succeeded("drawing the background", renderer.draw_strip(strip, strip_pixels)) ||
        !succeeded("keeping the background", layer.keep(renderer.frame(), strip, strip_pixels))) {
      return false;
    }
  }
  return true;
}

bool show_area(Panel& panel, const Rect& area) {
  const auto left = static_cast<std::uint16_t>(area.left), top = static_cast<std::uint16_t>(area.top);
  const auto width = static_cast<std::uint16_t>(area.width()), rows = static_cast<std::uint16_t>(area.height());
  if (!succeeded("restoring the background", layer.restore(area, pixels, depth)) ||
      !succeeded("drawing", renderer.draw_over(area, pixels, depth))) {
    return false;
  }
  convert_pixels(PixelFormat::gray4, width, rows, pixels.data(), sent.data());
  const std::size_t bytes = std::size_t{rows} * bytes_per_row(width, PixelFormat::gray4);
  return succeeded("display", panel.write({left, top, width, rows}, std::span(sent).first(bytes))) &&
         succeeded("display", panel.wait());
}

/// `cells` becomes the number of pixels that were drawn and sent.
bool show_frame(Panel& panel, std::uint32_t frame, std::uint32_t& cells) {
  const Instance instances[] = {showroom_teapot(frame, kFramesPerFlight)};
  const Scene moving = showroom_scene(instances);
  if (!succeeded("begin of the frame", renderer.begin_frame(moving, kShowroomCamera, kView, kMoving.plan, arena)) ||
      !succeeded("display", panel.begin_frame())) {
    return false;
  }
  layer.move_to(renderer.frame().bounds());
  cells = 0;
  Rect area;
  while (layer.next(area, kCells)) {
    if (!show_area(panel, area)) return false;
    cells += static_cast<std::uint32_t>(area.width() * area.height());
  }
  return succeeded("display", panel.end_frame());
}

}  // namespace

int main() {
  static zstrip::board::OledBus bus;
  bus.start();
  Panel panel(bus);
  if (!succeeded("start of the display", panel.start()) || !keep_background()) return 1;
  zstrip::board::start_pacing();
  zstrip::board::HostControl control;
  for (std::uint32_t frame = 0;; frame = (frame + 1) % kFramesPerFlight) {
    std::uint32_t cells = 0;
    if (!show_frame(panel, frame, cells)) return 1;
    zstrip::board::feed_watchdog();
    control.frame_shown(frame, cells);
    zstrip::board::wait_for_tick();
  }
}
