// The text of programs that show a baked scene with zstrip::Player. It uses the constants of the header.
#include "bake/program_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <string_view>
#include <utility>

#include "panel/simulated_panel.hpp"
#include "report/frame_record.hpp"
#include "text/text.hpp"
#include "visibility/methods.hpp"
#include "zstrip_hal/st7789.hpp"

namespace zstrip::sim {
namespace {

using Panel = hal::St7789Controller;

/// Replaces each @ by the header's namespace.
std::string with_namespace(std::string text, const std::string& name_space) {
  for (std::size_t at = 0; (at = text.find('@', at)) != std::string::npos;) {
    text.replace(at, 1, name_space);
    at += name_space.size();
  }
  return text;
}

bool bends(const BakedScene& baked) { return !baked.skins.meshes.empty(); }

std::string first_line(const BakedScene& baked) {
  return fmt::format("// {} in {}x{} pixels, {}.", printable(baked.source), baked.view.width, baked.view.height,
                     format_words(baked.view));
}

/// The memory of the scene's player.
constexpr std::string_view kPlayer =
    R"(constexpr zstrip::FitOptions kOptions{.strip_buffers = @::kBudget.strip_buffers > 1 ? 2 : 1,
                                      .split_columns = @::kBudget.split_columns,
                                      .strip_rows = @::kPlan.strip_rows};
// Memory for arena and strips of the header's plan (--ram makes them smaller), for moving data, and for gaps.
std::byte memory[@::kPlan.bytes() + kOptions.strip_buffers * @::kPlan.strip_pixel_bytes(@::kView) +
                 @::kScene.instances.size_bytes() + @::kScene.lines.size_bytes())";
/// Memory for the tables of the overlay, with room for the player's text.
constexpr std::string_view kOverlayTables =
    R"( +
                 (@::kOverlay.fonts.size() + 1) * sizeof(zstrip::Font) +
                 (@::kOverlay.labels.size() + 1) * sizeof(zstrip::Label))";

std::string player(const BakedScene& baked) {
  std::string text(kPlayer);
  if (baked.scene.overlay != nullptr) text += kOverlayTables;
  return text + " + 96];\nzstrip::Player player(memory, zstrip::drawn_with<@::kEffects>);\n";
}

/// Returns the module with a glass of this size, or null.
const PanelModule* module_of(std::uint16_t width, std::uint16_t height) {
  const auto is_panel = [](const PanelKind& kind) { return std::string_view(kind.name) == "st7789"; };
  for (const PanelModule& module : std::ranges::find_if(panel_kinds(), is_panel)->modules) {
    if (module.width == width && module.height == height) return &module;
  }
  return nullptr;
}

/// True if the panel is rotated: the picture is wider than the panel, or has the size of a module on its side.
bool lies_sideways(const View& view) {
  return view.width > Panel::kColumns ||
         (module_of(view.width, view.height) == nullptr && module_of(view.height, view.width) != nullptr);
}

/// Returns the driver's configuration of the panel in this orientation.
std::string panel_config(const View& view) {
  const bool sideways = lies_sideways(view);
  const std::uint16_t width = sideways ? view.height : view.width, height = sideways ? view.width : view.height;
  std::string config = fmt::format(".width = {}, .height = {},", width, height);
  if (const PanelModule* const module = module_of(width, height); module != nullptr) {
    if (module->column_offset != 0) config += fmt::format(" .column_offset = {},", module->column_offset);
    if (module->row_offset != 0) config += fmt::format(" .row_offset = {},", module->row_offset);
  }
  if (sideways) config += "\n    .orientation = {.rotation = zstrip::hal::Rotation::by_90},";
  if (view.format == PixelFormat::rgb666 || view.format == PixelFormat::rgb444) {
    config += fmt::format("\n    .format = zstrip::hal::PixelFormat::{},", name(view.format));
  }
  return "{" + config + " .inverted = true}";
}

/// Refuses pictures that no ST7789 can show.
Result<Done> check_panel(const View& view) {
  const bool fits = (view.width <= Panel::kColumns && view.height <= Panel::kRows) ||
                    (view.width <= Panel::kRows && view.height <= Panel::kColumns);
  if (fits) return Done{};
  return Failure{ExitStatus::usage, fmt::format("--size {}x{}: the program is for an ST7789, which has {}x{} pixels at "
                                                "most; choose its size, as 240x240",
                                                view.width, view.height, Panel::kColumns, Panel::kRows)};
}

/// Refuses formats that zstrip's driver of an ST7789 does not send.
Result<Done> check_format(const View& view) {
  // RGB565 is sent as bytes, the high one first.
  if (view.format != PixelFormat::rgb565 && Panel::pixel_format(static_cast<hal::PixelFormat>(view.format)) == 0) {
    return Failure{
        ExitStatus::usage,
        fmt::format("--format {}: the program is for an ST7789, which takes rgb565_swapped, rgb666 or rgb444",
                    name(view.format))};
  }
  if (view.format == PixelFormat::rgb444 && view.width % 2 != 0) {
    return Failure{
        ExitStatus::usage,
        fmt::format("--size {}x{} with --format rgb444: the program sends two pixels in three bytes; choose an "
                    "even width, or rgb565_swapped",
                    view.width, view.height)};
  }
  return Done{};
}

/// The parts of a sketch that depend on what drives the panel.
struct SketchPanel {
  std::string head;     ///< the rest of the first line, includes and pins
  std::string objects;  ///< `panel` and what it needs
  std::string start;    ///< lines of setup()
};

/// The pins and the clock of sketches that name them.
constexpr std::string_view kPins = R"(
// The panel's pins in addition to SPI clock and data. An ESP32 has its flash at 6 to 11: take 2, 4 and 5 there.
constexpr int kDataCommand = 8, kReset = 9, kSelect = 10;  // kSelect = -1 without such a pin
)";

SketchPanel own_panel(const View& view) {
  return {.head = R"( A sketch for Arduino with an ST7789, written by `zstrip bake`.
// Put it into a folder of the same name, next to scene.hpp, which the same command writes with -o scene.hpp. With
// -o FOLDER/ it writes both.
#include <zstrip.h>
#include <zstrip_arduino.h>

#include "scene.hpp"

// The panel's pins in addition to SPI clock and data. Without a select pin: kSelect = -1, and .mode = SPI_MODE3 below.
// An ESP32 has its flash at 6 to 11: take 2, 4 and 5 there.
constexpr int kDataCommand = 8, kReset = 9, kSelect = 10;
constexpr std::uint32_t kHertz = 15'000'000;  // the data sheet's limit; modules are commonly run at 40'000'000

)",
          .objects = R"(zstrip::hal::ArduinoClock waiting;
zstrip::hal::ArduinoSpi bus(SPI, {.data_command = kDataCommand, .select = kSelect}, kHertz);
constexpr zstrip::hal::DcsConfig kPanel)" +
                     panel_config(view) + ";\nzstrip::hal::St7789 panel(bus, waiting, kPanel);\n",
          .start = R"(  bus.start();
  zstrip::hal::ArduinoPin reset(kReset);
  (void)zstrip::hal::reset_panel(reset, waiting);
  if (panel.start() != zstrip::hal::Error::none) Serial.println("the panel does not start");
)"};
}

/// Its panel may have any size; its setup names panel and pins.
SketchPanel tft_espi_panel(const View& view) {
  return {.head = R"( A sketch for Arduino with TFT_eSPI, written by `zstrip bake`.
// TFT_eSPI knows the panel and its pins: by its User_Setup.h, or by the flags of a platformio.ini.
#include <TFT_eSPI.h>
#include <zstrip.h>

#include "scene.hpp"
#include "tft_espi.hpp"

)",
          .objects = "TFT_eSPI tft;\nadapters::TftEspi panel(tft);\n",
          .start =
              R"(  if (panel.start() != zstrip::hal::Error::none) Serial.println("TFT_eSPI has no DMA for this board");
)" + fmt::format("  tft.setRotation({});\n", view.width > view.height ? 1 : 0)};
}

/// The module of the picture's size, upright.
struct UprightModule {
  std::uint16_t width, height, column_offset = 0, row_offset = 0;
  int columns_after = 0, rows_after = 0;  ///< the offsets of the module upside down
};
UprightModule upright_module(const View& view) {
  const bool sideways = lies_sideways(view);
  UprightModule upright{sideways ? view.height : view.width, sideways ? view.width : view.height};
  if (const PanelModule* const module = module_of(upright.width, upright.height); module != nullptr) {
    upright.column_offset = module->column_offset;
    upright.row_offset = module->row_offset;
    upright.columns_after = Panel::kColumns - upright.width - upright.column_offset;
    upright.rows_after = Panel::kRows - upright.height - upright.row_offset;
  }
  return upright;
}

SketchPanel lovyangfx_panel(const View& view) {
  const UprightModule module = upright_module(view);
  std::string objects = R"(
// SCK and MOSI are the board's usual pins of SPI clock and data.
class Device : public lgfx::LGFX_Device {
 public:
  Device() {
    auto wires = bus_.config();
    wires.freq_write = kHertz;
    wires.pin_sclk = SCK;
    wires.pin_mosi = MOSI;
    wires.pin_dc = kDataCommand;
    bus_.config(wires);
    auto glass = panel_.config();
    glass.pin_cs = kSelect;
    glass.pin_rst = kReset;
)";
  objects += fmt::format("    glass.panel_width = {};\n    glass.panel_height = {};\n", module.width, module.height);
  if (module.column_offset != 0) objects += fmt::format("    glass.offset_x = {};\n", module.column_offset);
  if (module.row_offset != 0) objects += fmt::format("    glass.offset_y = {};\n", module.row_offset);
  objects += R"(    glass.readable = false;
    glass.invert = true;
    panel_.config(glass);
    panel_.setBus(&bus_);
    setPanel(&panel_);
  }

 private:
  lgfx::Bus_SPI bus_;
  lgfx::Panel_ST7789 panel_;
};
Device device;
adapters::LovyanGfx panel(device);
)";
  std::string head = R"( A sketch for Arduino with LovyanGFX, written by `zstrip bake`.
// The class Device names the panel, an ST7789. For another one, or a board that LovyanGFX knows, write yours instead.
#include <LovyanGFX.hpp>
#include <zstrip.h>

#include "lovyangfx.hpp"
#include "scene.hpp"
)";
  head += kPins;
  head += "constexpr std::uint32_t kHertz = 40'000'000;\n\n";
  return {.head = std::move(head),
          .objects = std::move(objects),
          .start = R"(  if (panel.start() != zstrip::hal::Error::none) Serial.println("LovyanGFX finds no panel");
)" + fmt::format("  device.setRotation({});\n", lies_sideways(view) ? 1 : 0)};
}

SketchPanel arduino_gfx_panel(const View& view) {
  const UprightModule module = upright_module(view);
  std::string head = R"( A sketch for Arduino with Arduino_GFX, written by `zstrip bake`.
// `gfx` is the panel, an ST7789. For another one write its class instead.
#include <Arduino_GFX_Library.h>
#include <zstrip.h>

#include "arduino_gfx.hpp"
#include "scene.hpp"
)";
  head += kPins;
  head += '\n';
  const std::string gfx = fmt::format(
      "Arduino_HWSPI bus(kDataCommand, kSelect);\n"
      "Arduino_ST7789 gfx(&bus, kReset, {}, true, {}, {}, {}, {}, {}, {});\nadapters::ArduinoGfx panel(gfx);\n",
      lies_sideways(view) ? 1 : 0, module.width, module.height, module.column_offset, module.row_offset,
      module.columns_after, module.rows_after);
  return {.head = std::move(head),
          .objects = gfx,
          .start = R"(  if (panel.start() != zstrip::hal::Error::none) Serial.println("the panel does not start");
)"};
}

SketchPanel sketch_panel(const View& view, DisplayLibrary library) {
  if (library == DisplayLibrary::tft_espi) return tft_espi_panel(view);
  if (library == DisplayLibrary::lovyangfx) return lovyangfx_panel(view);
  return library == DisplayLibrary::arduino_gfx ? arduino_gfx_panel(view) : own_panel(view);
}

/// Returns the file's name, in brackets if CMake would otherwise read it differently.
std::string cmake_argument(const std::string& file) {
  const bool plain = std::ranges::all_of(file, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' || c == '_' ||
           c == '-';
  });
  return plain ? file : "[[" + printable(file) + "]]";
}

/// `names`: the names that the text defines in addition to the header's namespace.
Result<Done> check(const BakedScene& baked, const std::string& name_space, std::initializer_list<const char*> names) {
  if (std::ranges::find(names, name_space) != names.end()) {
    return Failure{ExitStatus::usage,
                   fmt::format("--namespace {}: the program has that name itself; choose another one", name_space)};
  }
  if (baked.effects.methods == 0) return Done{};
  return Failure{
      ExitStatus::usage,
      fmt::format("zstrip::Player, by which programs and sketches draw, has no --visibility {}; leave it out",
                  visibility_name(baked.effects))};
}

}  // namespace

Result<Done> check_for_program(const BakedScene& baked, const std::string& name_space) {
  return check(baked, name_space, {"main", "memory", "picture", "player", "send"});
}

Result<Done> check_for_sketch(const BakedScene& baked, const std::string& name_space, DisplayLibrary library) {
  const View& view = baked.view;
  const bool own = library == DisplayLibrary::st7789;
  if (library != DisplayLibrary::tft_espi) {
    if (const Result<Done> fits = check_panel(view); !fits) return fits.failure();
  }
  if (!own && view.format != PixelFormat::rgb565 && view.format != PixelFormat::rgb565_swapped) {
    return Failure{ExitStatus::usage,
                   fmt::format("--format {}: other display libraries take rgb565_swapped; choose it, or --display "
                               "st7789",
                               name(view.format))};
  }
  if (own) {
    if (const Result<Done> sent = check_format(view); !sent) return sent.failure();
  }
  return check(baked, name_space,
               {"bus", "device", "gfx", "loop", "memory", "panel", "player", "setup", "tft", "waiting"});
}

Result<Done> check_for_pico_program(const BakedScene& baked, const std::string& name_space) {
  if (const Result<Done> fits = check_panel(baked.view); !fits) return fits.failure();
  if (const Result<Done> sent = check_format(baked.view); !sent) return sent.failure();
  return check(baked, name_space, {"bus", "main", "memory", "panel", "player", "waiting"});
}

std::string to_sketch(const BakedScene& baked, const std::string& name_space, DisplayLibrary library) {
  // Called before fit(), which counts the vertices of the skin.
  const std::string pose =
      bends(baked) ? "  if (!@::pose_skins(player.time())) Serial.println(\"the skin is not posed\");\n" : "";
  const SketchPanel panel = sketch_panel(baked.view, library);
  std::string text = panel.head + player(baked) + panel.objects;
  text += "\nvoid setup() {\n  Serial.begin(115200);\n" + panel.start;
  text += R"(  const bool opened = player.open({@::kScene, @::kCamera, @::kAnimation, @::kTurn}, @::kView);
)";
  text += pose;
  text += R"(  if (!opened || !player.fit(panel, kOptions)) Serial.println(player.error());
}

void loop() {
  player.play(millis());
)";
  text += pose;
  text += R"(  if (!player.draw(panel)) Serial.println(player.error());
}
)";
  return first_line(baked) + with_namespace(text, name_space);
}

std::string to_pico_program(const BakedScene& baked, const std::string& name_space) {
  const auto pose = [&](const char* indent) {
    return bends(baked) ? indent + std::string(
                                       "if (!@::pose_skins(player.time())) std::puts(\"the skin is not "
                                       "posed\");\n")
                        : std::string();
  };
  std::string text = R"( For the Raspberry Pi Pico SDK and an ST7789, written by `zstrip
// bake`. CMakeLists.txt says how to build it.
#include <cstddef>
#include <cstdint>
#include <cstdio>

#include "pico_spi_dma.hpp"
#include "scene.hpp"
#include "zstrip_player/player.hpp"

// The panel's pins, all of SPI 0: those of zstrip_pico_show.uf2. Without a select pin: spi_set_format() with CPOL and
// CPHA 1 after spi_init().
constexpr uint kSelect = 17, kClock = 18, kData = 19, kDataCommand = 20, kReset = 21, kBacklight = 22;
constexpr uint kHertz = 15'000'000;  // the data sheet's limit; modules are commonly run at 40'000'000

)";
  text += player(baked);
  text += R"(adapters::PicoClock waiting;
adapters::PicoSpiDma bus(spi0, kDataCommand, kSelect);
constexpr zstrip::hal::DcsConfig kPanel)";
  text += panel_config(baked.view);
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

int main() {
  stdio_init_all();
  if (!start_panel()) std::puts("the panel does not start");
  const bool opened = player.open({@::kScene, @::kCamera, @::kAnimation, @::kTurn}, @::kView);
)";
  text += pose("  ");
  text += R"(  if (!opened || !player.fit(panel, kOptions)) std::puts(player.error());
  for (;;) {
    player.play(to_ms_since_boot(get_absolute_time()));
)";
  text += pose("    ");
  text += R"(    if (!player.draw(panel)) std::puts(player.error());
  }
}
)";
  return first_line(baked) + with_namespace(text, name_space);
}

std::string to_program(const BakedScene& baked, const std::string& name_space, const std::string& file) {
  const std::string head = R"( Written by `zstrip bake`.
//     scene FILE [MILLISECONDS]    writes the picture at that time: its bytes, as `zstrip render --image raw` does
// The same command with -o scene.hpp writes scene.hpp. CMakeLists.txt, with zstrip's repository in the folder zstrip:
//     cmake_minimum_required(VERSION 3.22)
//     project(scene LANGUAGES CXX)
//     set(CMAKE_BUILD_TYPE Release)
//     add_subdirectory(zstrip)
//     add_executable(scene )" +
                           cmake_argument(file) + ")\n";
  std::string text = R"(//     target_link_libraries(scene PRIVATE zstrip::player)
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <span>

#include "scene.hpp"
#include "zstrip_player/player.hpp"

)";
  text += player(baked);
  text += R"(
// Takes the place of a display: your own send() copies a strip to the display.
constexpr std::size_t kRowBytes = zstrip::bytes_per_row(@::kView.width, @::kView.format);
std::byte picture[kRowBytes * @::kView.height];

bool send(const zstrip::Rect& area, std::span<const std::byte> pixels) {
  const std::size_t left = zstrip::bytes_per_row(static_cast<std::uint16_t>(area.left), @::kView.format);
  const std::size_t width = zstrip::bytes_per_row(static_cast<std::uint16_t>(area.width()), @::kView.format);
  for (auto row = static_cast<std::size_t>(area.top); !pixels.empty(); ++row, pixels = pixels.subspan(width)) {
    std::copy_n(pixels.begin(), width, picture + row * kRowBytes + left);
  }
  return true;
}

int main(int count, char** words) {
  if (count < 2) return 2;
  const bool opened = player.open({@::kScene, @::kCamera, @::kAnimation, @::kTurn}, @::kView);
  // A loop calls player.play(now) before each frame, with the milliseconds of a clock.
  if (count > 2) player.seek(static_cast<std::uint32_t>(std::strtoul(words[2], nullptr, 10)));
)";
  if (bends(baked)) text += "  if (!@::pose_skins(player.time())) return 1;\n";
  text += R"(  const bool fits = opened && player.fit(@::kView.width, @::kView.height, @::kView.format, kOptions);
  if (!fits || !player.draw_strips(send)) {
    std::fprintf(stderr, "%s\n", player.error());
    return 1;
  }
  std::FILE* const file = std::fopen(words[1], "wb");
  const bool written = file != nullptr && std::fwrite(picture, sizeof picture, 1, file) == 1;
  return file != nullptr && std::fclose(file) == 0 && written ? 0 : 1;
}
)";
  return first_line(baked) + head + with_namespace(text, name_space);
}

}  // namespace zstrip::sim
