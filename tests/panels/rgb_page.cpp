// The example of docs/displays.md for panels without memory compiles. What it takes for granted stands here: the names
// of esp_lcd, a clock, a scene and its plan.
#include <array>
#include <zstrip/zstrip.hpp>

#include "zstrip_hal/scanned_panel.hpp"

namespace zstrip::panels::page {

using esp_lcd_panel_handle_t = void*;
struct Ticks {
  void wait(std::uint32_t) {}
};
Ticks clock;
const Scene scene{};
const Camera camera{};
constexpr View kView{480, 272, PixelFormat::rgb565};
constexpr Plan kPlan = plan(SceneCounts{}, kView, Effects{}, {.bytes = 0, .strip_rows = 17}).plan;
std::array<std::uint64_t, kPlan.bytes() / 8 + 1> words;
const std::span<std::byte> arena = std::as_writable_bytes(std::span(words));
Renderer<Effects{}> renderer;

#include "rgb_page.inc"

}  // namespace zstrip::panels::page
