// The text of programs for the Raspberry Pi Pico SDK; see program_text.hpp.
#include <fmt/format.h>

#include <string_view>

#include "bake/program_parts.hpp"
#include "bake/program_text.hpp"

namespace zstrip::sim {
namespace {

/// The start of a program for the Raspberry Pi Pico SDK, up to the function that starts the panel. `memory`: what
/// draws, with its memory.
std::string pico_head(const View& view, const std::string& memory, std::string_view more_includes) {
  std::string text = R"( For the Raspberry Pi Pico SDK and an ST7789, written by `zstrip
// bake`. CMakeLists.txt says how to build it.
)";
  text += more_includes;
  text += R"(
#include "pico_spi_dma.hpp"
#include "scene.hpp"
#include "zstrip_player/player.hpp"

// The panel's pins, all of SPI 0: those of zstrip_pico_show.uf2. Without a select pin: spi_set_format() with CPOL and
// CPHA 1 after spi_init().
constexpr uint kSelect = 17, kClock = 18, kData = 19, kDataCommand = 20, kReset = 21, kBacklight = 22;
constexpr uint kHertz = 15'000'000;  // the data sheet's limit; modules are commonly run at 40'000'000

)";
  text += memory;
  text += R"(adapters::PicoClock waiting;
adapters::PicoSpiDma bus(spi0, kDataCommand, kSelect);
constexpr zstrip::hal::DcsConfig kPanel)";
  text += panel_config(view);
  text += R"(;
adapters::PicoPanel panel(bus, waiting, kPanel);

// Returns false if the panel does not start.
bool start_panel() {
  spi_init(spi0, kHertz);
  gpio_set_function(kClock, GPIO_FUNC_SPI);
  gpio_set_function(kData, GPIO_FUNC_SPI);
  for (const uint pin : {kSelect, kDataCommand, kReset, kBacklight}) {
    gpio_init(pin);
    gpio_put(pin, true);
    gpio_set_dir(pin, GPIO_OUT);
  }
  waiting.wait(10'000);
  gpio_put(kReset, false);
  waiting.wait(10'000);
  gpio_put(kReset, true);
  waiting.wait(120'000);
  return bus.start() == zstrip::hal::Error::none && panel.start() == zstrip::hal::Error::none;
}
)";
  return text;
}

/// Writes the vertices of skins for the time `time`, an expression, if there are skins.
std::string pico_pose(const BakedScene& baked, const char* indent, const char* time) {
  if (!bends(baked)) return {};
  return fmt::format("{}if (!{}) std::puts(\"{}\");\n", indent, pose_call(baked, time), pose_words(baked));
}

/// Two renderers share the strips of a frame, so that there is no player.
std::string pico_program_of_two_cores(const BakedScene& baked) {
  std::string text =
      pico_head(baked.view,
                R"(// Both cores draw, each the next strip when it is free, with a renderer and an arena of its own.
using Renderer = zstrip::Renderer<@::kEffects>;
alignas(zstrip::kArenaAlignment) std::byte arenas[2][@::kPlan.bytes()];
Renderer renderer, renderer_of_second;
zstrip::hal::SecondCore second(renderer_of_second);
alignas(4) std::byte pixels[3][@::kPlan.strip_pixel_bytes(@::kView)];  // two are drawn while one is sent
// The moving parts of the scene, in RAM.
std::array<zstrip::Instance, @::kScene.instances.size()> instances;
std::array<zstrip::LineSet, @::kScene.lines.size()> lines;
constexpr zstrip::scenes::AtRest kAtRest)" +
                    at_rest_words(baked) + R"(;
constexpr std::uint32_t kPeriod = @::kAnimation.tracks.empty() ? zstrip::Player::kTurnTime
                                                                   : std::max<std::uint32_t>(@::kAnimation.duration, 1);

)",
                R"(#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <span>

#include <pico/multicore.h>
#include <zstrip/zstrip.hpp>
#include <zstrip_hal/second_core.hpp>
)");
  text += R"(
zstrip::Status begin(Renderer& with, std::span<std::byte> arena, const zstrip::scenes::BakedFrame& frame) {
  return with.begin_frame(frame.scene, frame.camera, @::kView, @::kPlan, arena);
}

int main() {
  stdio_init_all();
  if (!start_panel()) std::puts("the panel does not start");
  multicore_launch_core1([] {
    for (;;) second.serve();
  });
  for (;;) {
    const std::uint32_t time = to_ms_since_boot(get_absolute_time()) % kPeriod;
)";
  text += pico_pose(baked, "    ", "time");
  text += R"(    const auto frame = zstrip::scenes::stage(kAtRest, time, kPeriod, {instances, lines});
    // Each core begins the frame with its own renderer, both at once.
    const auto begin_second = [&frame] { return begin(renderer_of_second, arenas[1], frame); };
    second.start(begin_second);
    if (const zstrip::Status begun = begin(renderer, arenas[0], frame); !begun) {
      std::puts(zstrip::message(begun.error));
      while (!second.is_done()) tight_loop_contents();
      continue;
    }
    const auto shown = zstrip::hal::present(
        renderer, second, panel, {@::kPlan.strips, @::kPlan.strip_rows, @::kPlan.strip_columns},
        {pixels[0], pixels[1], pixels[2]}, waiting);
    if (!shown) std::puts(shown.draw ? zstrip::hal::message(shown.display) : zstrip::message(shown.draw.error));
  }
}
)";
  return text;
}

std::string pico_program_of_one_core(const BakedScene& baked) {
  std::string text = pico_head(baked.view, player_text(baked), R"(#include <cstddef>
#include <cstdint>
#include <cstdio>
)");
  text += R"(
int main() {
  stdio_init_all();
  if (!start_panel()) std::puts("the panel does not start");
  const bool opened = player.open()" +
          at_rest_words(baked) + R"(, @::kView);
)";
  text += pico_pose(baked, "  ", "player.time()");
  text += R"(  if (!opened || !player.fit(panel, kOptions)) std::puts(player.error());
  for (;;) {
    player.play(to_ms_since_boot(get_absolute_time()));
)";
  text += pico_pose(baked, "    ", "player.time()");
  text += R"(    if (!player.draw(panel)) std::puts(player.error());
  }
}
)";
  return text;
}

}  // namespace

Result<Done> check_for_pico_program(const BakedScene& baked, const std::string& name_space) {
  if (const Result<Done> fits = check_panel(baked.view); !fits) return fits.failure();
  if (const Result<Done> sent = check_format(baked.view); !sent) return sent.failure();
  return check_names(baked, name_space,
                     {"arenas", "begin", "bus", "instances", "lines", "main", "memory", "panel", "pixels", "player",
                      "renderer", "renderer_of_second", "second", "start_panel", "waiting"});
}

std::string to_pico_program(const BakedScene& baked, const std::string& name_space, std::uint8_t cores) {
  return first_line(baked) +
         with_namespace(cores == 2 ? pico_program_of_two_cores(baked) : pico_program_of_one_core(baked), name_space);
}

}  // namespace zstrip::sim
