// The examples of the pages, each within what it expects around it. gather_examples.py puts an example where a comment
// names its page and section; the result is compiled, not run.
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <utility>

#include "bench/board_model.hpp"
#include "pico_spi_dma.hpp"
#include "scene.hpp"
#include "zstrip/area.hpp"
#include "zstrip/fingerprints.hpp"
#include "zstrip/zstrip.hpp"
#include "zstrip_hal/changed_tiles.hpp"
#include "zstrip_hal/message_screen.hpp"
#include "zstrip_hal/output_pin.hpp"
#include "zstrip_hal_linux/gpio.hpp"
#include "zstrip_hal_linux/sleeping_clock.hpp"
#include "zstrip_hal_linux/spidev.hpp"
#include "zstrip_player/pick_with.hpp"

// Last, because Arduino's macros have names of functions of the C++ library.
#include "tft_espi.hpp"
#include "zstrip_arduino.h"

namespace pages {

struct Pin {
  zstrip::hal::Error set(bool);
};
struct InputLine {
  zstrip::hal::Error read(bool& high);
};
struct QuadWires {
  zstrip::hal::Error write(std::span<const std::byte, 4> header, std::span<const std::byte> data, unsigned lines);
  zstrip::hal::Error wait();
};
struct OpenDrain {
  zstrip::hal::Error pull_low();
  zstrip::hal::Error release();
  zstrip::hal::Error read(bool& high);
};
struct Clock {
  void wait(std::uint32_t microseconds);
};
struct Bus {
  zstrip::hal::Error write_command(std::span<const std::byte> bytes);
  zstrip::hal::Error write_data(std::span<const std::byte> bytes);
  zstrip::hal::Error wait();
};

Bus bus;
Clock clock;
zstrip::hal::St7789 panel(bus, clock);
std::byte player_memory[1];
zstrip::Player player(player_memory, zstrip::drawn_with<baked::kEffects>);
zstrip::Fixed step;
std::uint16_t x, y;
void show(const char* text);
void pull();
constexpr int kLever = 1;

namespace four_calls {
std::uint32_t scene[1];

void shown() {
  // docs/player.md: In four calls
}
}  // namespace four_calls

void moved() {
  // docs/player.md: A model that the program moves
}

namespace characters {
std::uint32_t figure[1];

void waves() {
  // docs/player.md: Characters
}
}  // namespace characters

void heard() {
  const auto play_sound = [](std::uint16_t) {};
  // docs/player.md: Events
}

void touched() {
  // docs/player.md: Which part was touched
}

void in_part() {
  // docs/player.md: A part of a larger picture
}

namespace card {
constexpr int kCardSelect = 4;
struct File {
  explicit operator bool() const;
  std::uint32_t size();
  int read(void* bytes, std::size_t count);
};
struct Card {
  bool begin(int select);
  File open(const char* path);
} SD;

// docs/player.md: A scene from a card or a flash chip
}  // namespace card

namespace new_texels {
using baked::kInstances, baked::kMaterials, baked::kMeshes;

// docs/program.md: A texture that changes
}  // namespace new_texels

namespace baked_texels {
namespace baked {
using namespace ::baked;
using new_texels::kTextures;
}  // namespace baked
using new_texels::texels;

void opened() {
  // docs/program.md: A texture that changes
}
}  // namespace baked_texels

namespace on_pico {
// docs/porting.md: Which compiler
}  // namespace on_pico

int drawn() {
  static baked::FixedRenderer renderer;
  alignas(4) static std::array<std::byte, baked::FixedRenderer::kStripBytes> pixels;
  // docs/program.md: A rectangle of the picture
  return 0;
}

int rotated() {
  // docs/panels.md: Rotated
  return 0;
}

int on_qspi() {
  // docs/panels.md: QSPI
  return 0;
}

int on_paper(InputLine busy_pin, Pin reset_pin) {
  // docs/panels.md: E-paper
  return 0;
}

int wired(Pin clock_pin, Pin data_pin, Pin dc_pin, Pin select_pin, Pin reset_pin, Pin write_pin, OpenDrain scl_pin,
          OpenDrain sda_pin) {
  Pin d0, d1, d2, d3, d4, d5, d6, d7;
  // docs/panels.md: Wires
  return 0;
}

namespace on_tft {
TFT_eSPI tft;

void drawn() {
  // docs/displays.md: On another display library
}
}  // namespace on_tft

void only_changes(adapters::TftEspi& panel, zstrip::Player& player) {
  using Panel = adapters::TftEspi;
  // docs/displays.md: Send only what changed
}

namespace known {
zstrip::Renderer<baked::kEffects> renderer;
std::array<std::byte, baked::kPlan.bytes()> arena;
std::array<std::byte, baked::kPlan.strip_pixel_bytes(baked::kView)> first_pixels, second_pixels;

void drawn(adapters::TftEspi& panel, const zstrip::Scene& scene, const zstrip::Camera& camera) {
  constexpr zstrip::hal::StripLayout kLayout{baked::kPlan.strips, baked::kPlan.strip_rows, baked::kPlan.strip_columns};
  zstrip::hal::ChangedTiles<adapters::TftEspi, 100> changes(panel);
  // docs/displays.md: Strips that are not drawn
}
}  // namespace known

void without_a_console() {
  // docs/displays.md: Without a console
}

namespace planned {
constexpr auto kScene = baked::kScene;
constexpr auto kView = baked::kView;
constexpr auto kEffects = baked::kEffects;
constexpr zstrip::Budget kBudget{.bytes = 20'000};
constexpr zstrip::Fixed kNear = 1 << 16, kFar = 100 << 16, kFarthest = 50 << 16;
constexpr std::uint64_t kSeparation = 1ULL << 30;

void strips() {
  // docs/memory.md: Choosing strips
}

// docs/memory.md: Choosing the depth format
}  // namespace planned

namespace skins {
baked::FixedRenderer fixed;
namespace baked {
using namespace ::baked;
bool pose_skins(std::uint32_t milliseconds);
}  // namespace baked
zstrip::Renderer<baked::kEffects> renderer;
std::array<std::byte, baked::kPlan.bytes()> arena;
std::array<std::byte, baked::kPlan.strip_pixel_bytes(baked::kView)> pixels;

bool drawn(std::uint32_t milliseconds) {
  // docs/scenes.md: Baked models that bend
  return true;
}
}  // namespace skins

namespace text {
using baked::kScene;

void drawn(unsigned frame) {
  // docs/effects.md: Sprites and text over the picture
}
}  // namespace text

namespace on_linux {
using namespace zstrip::hal;
int fail(const Fault& fault);

int opened() {
  // docs/linux.md: In a program of your own
  return 0;
}
}  // namespace on_linux

namespace board {
using zstrip::sim::BoardModel, zstrip::sim::CyclesPerEstimate;
constexpr CyclesPerEstimate kCortexM4{1.5, 2.3};
constexpr std::array kBoards{
    // host-sim/bench/README.md: A board of yours
};
}  // namespace board

}  // namespace pages
