// The text of sketches and of a source for CMake that show a baked scene with zstrip::Player; see program_text.hpp.
// They use the constants of the header.
#include "bake/program_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "bake/program_parts.hpp"
#include "text/text.hpp"

namespace zstrip::sim {
namespace {

/// The parts of a sketch that depend on the driver of the panel.
struct SketchPanel {
  std::string head;     ///< the rest of the first line, includes and pins
  std::string objects;  ///< `panel` and the objects that it needs
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

/// The library finds the board, whose panel may have any size.
SketchPanel m5gfx_panel(const View& view) {
  return {.head = R"( A sketch for Arduino with M5GFX, written by `zstrip bake`.
// M5GFX finds out which board of M5Stack it runs on, and knows its panel.
#include <M5GFX.h>
#include <zstrip.h>

#include "lovyangfx.hpp"
#include "scene.hpp"

)",
          .objects = "M5GFX device;\nadapters::LovyanGfx panel(device);\n",
          .start = R"(  if (panel.start() != zstrip::hal::Error::none) Serial.println("M5GFX finds no panel");
)" + fmt::format("  device.setRotation({});\n", view.width > view.height ? 1 : 0)};
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
  switch (library) {
    case DisplayLibrary::tft_espi: return tft_espi_panel(view);
    case DisplayLibrary::lovyangfx: return lovyangfx_panel(view);
    case DisplayLibrary::m5gfx: return m5gfx_panel(view);
    case DisplayLibrary::arduino_gfx: return arduino_gfx_panel(view);
    case DisplayLibrary::st7789: break;
  }
  return own_panel(view);
}

/// Returns the file's name, in brackets if CMake would otherwise read it differently.
std::string cmake_argument(const std::string& file) {
  const bool plain = std::ranges::all_of(file, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' || c == '_' ||
           c == '-';
  });
  return plain ? file : "[[" + printable(file) + "]]";
}

}  // namespace

Result<Done> check_for_program(const BakedScene& baked, const std::string& name_space) {
  return check_names(baked, name_space, {"main", "memory", "picture", "player", "send"});
}

Result<Done> check_for_sketch(const BakedScene& baked, const std::string& name_space, DisplayLibrary library) {
  const View& view = baked.view;
  const bool own = library == DisplayLibrary::st7789;
  if (library != DisplayLibrary::tft_espi && library != DisplayLibrary::m5gfx) {
    if (const Result<Done> fits = check_panel(view); !fits) return fits.failure();
  }
  const Result<Done> sent =
      own ? check_format(view)
          : check_rgb565(view, "other display libraries take rgb565_swapped; choose it, or --display st7789");
  if (!sent) return sent.failure();
  return check_names(baked, name_space,
                     {"bus", "device", "gfx", "loop", "memory", "panel", "player", "setup", "tft", "waiting"});
}

std::string to_sketch(const BakedScene& baked, const std::string& name_space, DisplayLibrary library) {
  // Called before fit(), which counts the vertices of the skin.
  const std::string pose = bends(baked) ? fmt::format("  if (!{}) Serial.println(\"{}\");\n",
                                                      pose_call(baked, "player.time()"), pose_words(baked))
                                        : "";
  const SketchPanel panel = sketch_panel(baked.view, library);
  std::string text = panel.head + player_text(baked) + panel.objects;
  text += "\nvoid setup() {\n  Serial.begin(115200);\n" + panel.start;
  text += R"(  const bool opened = player.open()" + at_rest_words(baked) + R"(, @::kView);
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
  text += player_text(baked);
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
  const bool opened = player.open()" +
          at_rest_words(baked) + R"(, @::kView);
  // A loop calls player.play(now) before each frame, with the milliseconds of a clock.
  if (count > 2) player.seek(static_cast<std::uint32_t>(std::strtoul(words[2], nullptr, 10)));
)";
  if (bends(baked)) text += fmt::format("  if (!{}) return 1;\n", pose_call(baked, "player.time()"));
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
