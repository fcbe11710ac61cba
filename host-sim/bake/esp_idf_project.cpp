// Programs for ESP-IDF and their project; see esp_idf_project.hpp.
#include "bake/esp_idf_project.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "bake/adapter_texts.hpp"
#include "bake/program_parts.hpp"
#include "image/to_rgb.hpp"

namespace zstrip::sim {
namespace {

/// Writes the vertices of skins and morph targets for the player's time, if the scene has them.
std::string pose(const BakedScene& baked, std::string_view indent) {
  if (!bends(baked)) return {};
  return fmt::format("{}if (!{}) std::puts(\"{}\");\n", indent, pose_call(baked, "player.time()"), pose_words(baked));
}

/// The rest of app_main for a panel that takes frames whenever they are drawn.
std::string playing(const BakedScene& baked) {
  return R"(  const bool opened = player.open()" + at_rest_words(baked) + R"(, @::kView);
)" + pose(baked, "  ") +
         R"(  if (!opened || !player.fit(panel, kOptions)) std::puts(player.error());
  for (;;) {
    player.play(static_cast<std::uint32_t>(esp_timer_get_time() / 1000));
)" + pose(baked, "    ") +
         R"(    if (!player.draw(panel)) std::puts(player.error());
    vTaskDelay(1);  // the idle task runs, which the watchdog wants
  }
}
)";
}

/// The program for esp_lcd of ESP-IDF, whose driver of an ST7789 drives the panel.
std::string spi_program(const BakedScene& baked) {
  const UprightModule module = upright_module(baked.view);
  const bool sideways = lies_sideways(baked.view);
  std::string text = R"( For ESP-IDF 5.0.1 or later and an ST7789, written by `zstrip
// bake`. The CMakeLists.txt of the folder above says how to build it.
#include <cstddef>
#include <cstdint>
#include <cstdio>

#include <driver/gpio.h>
#include <driver/spi_master.h>
#include <esp_lcd_panel_vendor.h>
#include <esp_timer.h>
#include <freertos/FreeRTOS.h>
#include <freertos/task.h>

#include "../scene.hpp"
#include "esp_lcd.hpp"
#include "zstrip_player/player.hpp"

// The panel's pins, on an ESP32. Other chips have other ones.
constexpr int kClock = 18, kData = 23, kDataCommand = 2, kReset = 4;
constexpr int kSelect = 5;      // -1 without a select pin, with kMode = 3
constexpr int kBacklight = -1;  // -1: not switched
constexpr int kMode = 0;
constexpr unsigned kHertz = 40'000'000;

)" + player_text(baked) +
                     R"(
// Returns false if the panel does not start.
bool start_glass(esp_lcd_panel_io_handle_t& io, esp_lcd_panel_handle_t& glass) {
  if (kBacklight >= 0) {
    gpio_set_direction(static_cast<gpio_num_t>(kBacklight), GPIO_MODE_OUTPUT);
    gpio_set_level(static_cast<gpio_num_t>(kBacklight), 1);
  }
  spi_bus_config_t bus{};
  bus.mosi_io_num = kData;
  bus.miso_io_num = -1;
  bus.sclk_io_num = kClock;
  bus.quadwp_io_num = -1;
  bus.quadhd_io_num = -1;
  bus.max_transfer_sz = static_cast<int>(@::kPlan.strip_pixel_bytes(@::kView));
  if (spi_bus_initialize(SPI2_HOST, &bus, SPI_DMA_CH_AUTO) != ESP_OK) return false;

  esp_lcd_panel_io_spi_config_t wires{};
  wires.cs_gpio_num = static_cast<gpio_num_t>(kSelect);
  wires.dc_gpio_num = static_cast<gpio_num_t>(kDataCommand);
  wires.spi_mode = kMode;
  wires.pclk_hz = kHertz;
  wires.trans_queue_depth = 10;
  wires.lcd_cmd_bits = 8;
  wires.lcd_param_bits = 8;
  if (esp_lcd_new_panel_io_spi((esp_lcd_spi_bus_handle_t)SPI2_HOST, &wires, &io) != ESP_OK) return false;

  esp_lcd_panel_dev_config_t config{};
  config.reset_gpio_num = static_cast<gpio_num_t>(kReset);
  config.bits_per_pixel = 16;
  if (esp_lcd_new_panel_st7789(io, &config, &glass) != ESP_OK) return false;
  esp_lcd_panel_reset(glass);
  esp_lcd_panel_init(glass);
  esp_lcd_panel_invert_color(glass, true);
)";
  if (sideways) {
    text += "  esp_lcd_panel_swap_xy(glass, true);\n  esp_lcd_panel_mirror(glass, true, false);\n";
  }
  const int gap_x = sideways ? module.row_offset : module.column_offset;
  const int gap_y = sideways ? module.columns_after : module.row_offset;
  if (gap_x != 0 || gap_y != 0) text += fmt::format("  esp_lcd_panel_set_gap(glass, {}, {});\n", gap_x, gap_y);
  text += R"(  return esp_lcd_panel_disp_on_off(glass, true) == ESP_OK;
}

extern "C" void app_main() {
  esp_lcd_panel_io_handle_t io = nullptr;
  esp_lcd_panel_handle_t glass = nullptr;
  const bool has_glass = start_glass(io, glass);
  adapters::EspLcd panel(io, glass, @::kView.width, @::kView.height);
  if (!has_glass || panel.start() != zstrip::hal::Error::none) {
    std::puts("the panel does not start");
    return;
  }
)" + playing(baked);
  return text;
}

/// The program for an RGB panel, whose driver has no picture in memory: its two bounce buffers are the strips.
std::string rgb_program(const BakedScene& baked) {
  return R"( For ESP-IDF 5.0.1 or later and an RGB panel on an ESP32-S3,
// written by `zstrip bake`. Fill in pins and timings in glass.hpp. The CMakeLists.txt of the folder above says how to
// build it.
#include <cstddef>
#include <cstdint>
#include <cstdio>

#include <esp_lcd_panel_ops.h>
#include <esp_timer.h>

#include "../scene.hpp"
#include "esp_lcd_rgb.hpp"
#include "glass.hpp"
#include "zstrip_player/player.hpp"

)" + player_text(baked) +
         R"(
static_assert(@::kView.height % (2 * @::kPlan.strip_rows) == 0,
              "the two bounce buffers take an even number of equal strips: bake with --display rgb_panel");

extern "C" void app_main() {
  const esp_lcd_panel_handle_t driver = glass::create(@::kView.width, @::kView.height, @::kPlan.strip_rows);
  static adapters::EspLcdRgb panel(driver, @::kView.width, @::kView.height, @::kPlan.strip_rows);
  if (driver == nullptr || panel.start() != zstrip::hal::Error::none || esp_lcd_panel_init(driver) != ESP_OK) {
    std::puts("the panel does not start");
    return;
  }
  const bool opened = player.open()" +
         at_rest_words(baked) + R"(, @::kView);
)" + pose(baked, "  ") +
         R"(  if (!opened || !player.fit(panel, kOptions)) {
    std::puts(player.error());
    return;
  }
  for (unsigned frames = 0, late = 0;; ++frames) {
    player.play(static_cast<std::uint32_t>(esp_timer_get_time() / 1000));
)" + pose(baked, "    ") +
         R"(    late += player.draw(panel) ? 0 : 1;
    if (frames == 0) glass::light();
    // The panel shows old rows in a frame that is late. More than a few: take a slower pixel clock, or a smaller model.
    if (frames % 1000 == 999) std::printf("%u of %u frames were late: %s\n", late, frames + 1, player.error());
  }
}
)";
}

/// The program for a MIPI-DSI panel, whose driver copies each strip into a picture in PSRAM.
std::string mipi_dsi_program(const BakedScene& baked) {
  return R"( For ESP-IDF 5.3 or later and a MIPI-DSI panel on an ESP32-P4,
// written by `zstrip bake`. Fill in pins and timings in glass.hpp. The CMakeLists.txt of the folder above says how to
// build it.
#include <cstddef>
#include <cstdint>
#include <cstdio>

#include <esp_timer.h>
#include <freertos/FreeRTOS.h>
#include <freertos/task.h>

#include "../scene.hpp"
#include "esp_lcd_dsi.hpp"
#include "glass.hpp"
#include "zstrip_player/player.hpp"

)" + player_text(baked) +
         R"(
extern "C" void app_main() {
  const esp_lcd_panel_handle_t driver = glass::create(@::kView.width, @::kView.height);
  static adapters::EspLcdDsi panel(driver, @::kView.width, @::kView.height);
  if (driver == nullptr || panel.start() != zstrip::hal::Error::none) {
    std::puts("the panel does not start");
    return;
  }
  glass::light();
)" + playing(baked);
}

/// The chip and the components of a panel's program.
struct PanelProject {
  std::string_view chip;
  std::string_view components;
  std::string_view settings;      ///< sdkconfig.defaults
  std::string_view dependencies;  ///< idf_component.yml
};

PanelProject project_of(EspLcdPanel panel) {
  switch (panel) {
    case EspLcdPanel::rgb:
      return {"esp32s3", "esp_lcd driver esp_timer", adapter_text::kRgbSettings, adapter_text::kRgbDependencies};
    case EspLcdPanel::mipi_dsi:
      return {"esp32p4", "esp_lcd driver esp_timer esp_hw_support", adapter_text::kDsiSettings,
              adapter_text::kDsiDependencies};
    case EspLcdPanel::spi: break;
  }
  return {"esp32", "esp_lcd driver esp_timer",
          R"(# The stack of the task that draws, 4 KB of it for zstrip; and code for speed.
CONFIG_ESP_MAIN_TASK_STACK_SIZE=8192
CONFIG_COMPILER_OPTIMIZATION_PERF=y
)",
          R"(dependencies:
  idf: ">=5.0.1"
)"};
}

/// Returns the rows of the highest strips, at most `limit`, of which an even number is as high as the panel; 0 for an
/// odd height.
std::uint16_t equal_strip_rows(unsigned height, unsigned limit) {
  for (unsigned rows = std::min(limit, height / 2); height % 2 == 0 && rows > 0; --rows) {
    if (height / 2 % rows == 0) return static_cast<std::uint16_t>(rows);
  }
  return 0;
}

Result<Done> check_bounce_buffers(const View& view, const Plan& plan) {
  if (view.height % 2 != 0) {
    return Failure{ExitStatus::usage,
                   fmt::format("--size {}x{}: the two buffers of an RGB panel take an even number of "
                               "strips; choose an even height",
                               view.width, view.height)};
  }
  if (view.height % (2 * plan.strip_rows) != 0) {
    return Failure{ExitStatus::usage,
                   fmt::format("--strip-rows {}: the two buffers of an RGB panel take an even number of equal strips; "
                               "choose a divisor of {}, such as {}",
                               plan.strip_rows, view.height / 2, equal_strip_rows(view.height, plan.strip_rows))};
  }
  if (plan.strip_columns == view.width) return Done{};
  return Failure{ExitStatus::usage,
                 "--split-columns, --strip-columns: the buffers of an RGB panel take whole rows; leave the option out"};
}

}  // namespace

std::uint16_t rgb_strip_rows(std::uint16_t width, std::uint16_t height) {
  constexpr unsigned kBouncePixels = 8192;  // 16 KB for each of the two buffers
  return equal_strip_rows(height, kBouncePixels / width);
}

Result<Done> check_for_esp_idf_project(const BakedScene& baked, const std::string& name_space, EspLcdPanel panel) {
  const bool on_spi = panel == EspLcdPanel::spi;
  if (on_spi) {
    if (const Result<Done> fits = check_panel(baked.view); !fits) return fits.failure();
    if (const Result<Done> sent = check_rgb565(baked.view, "esp_lcd takes rgb565_swapped; choose it"); !sent)
      return sent.failure();
  } else if (baked.view.format != PixelFormat::rgb565) {
    return Failure{
        ExitStatus::usage,
        fmt::format("--format {}: RGB and MIPI-DSI panels of esp_lcd take rgb565; choose it", name(baked.view.format))};
  }
  if (panel == EspLcdPanel::rgb) {
    if (const Result<Done> fit = check_bounce_buffers(baked.view, baked.plan); !fit) return fit.failure();
  }
  return check_names(baked, name_space, {"app_main", "glass", "memory", "player", "start_glass"});
}

std::vector<ProjectFile> esp_idf_files(const BakedScene& baked, const std::string& name_space, const std::string& name,
                                       EspLcdPanel panel) {
  const PanelProject project = project_of(panel);
  std::vector<ProjectFile> files;
  files.push_back(
      {"CMakeLists.txt",
       fmt::format(
           R"(# Written by `zstrip bake`. zstrip's package, the folder zstrip of its archive, goes into components/ next to this file.
#     idf.py set-target {}
#     idf.py build flash
cmake_minimum_required(VERSION 3.16)
include($ENV{{IDF_PATH}}/tools/cmake/project.cmake)
project({})
)",
           project.chip, name)});
  files.push_back({"sdkconfig.defaults", std::string(project.settings)});
  files.push_back(
      {"main/CMakeLists.txt",
       fmt::format("idf_component_register(SRCS main.cpp INCLUDE_DIRS . REQUIRES zstrip {})\n", project.components)});
  files.push_back({"main/idf_component.yml", std::string(project.dependencies)});
  const std::string program = panel == EspLcdPanel::rgb        ? rgb_program(baked)
                              : panel == EspLcdPanel::mipi_dsi ? mipi_dsi_program(baked)
                                                               : spi_program(baked);
  files.push_back({"main/main.cpp", first_line(baked) + with_namespace(program, name_space)});
  files.push_back({"main/esp_lcd.hpp", std::string(adapter_text::kEspLcd)});
  if (panel == EspLcdPanel::rgb) {
    files.push_back({"main/esp_lcd_rgb.hpp", std::string(adapter_text::kEspLcdRgb)});
    files.push_back({"main/glass.hpp", std::string(adapter_text::kRgbGlass)});
  }
  if (panel == EspLcdPanel::mipi_dsi) {
    files.push_back({"main/esp_lcd_dsi.hpp", std::string(adapter_text::kEspLcdDsi)});
    files.push_back({"main/glass.hpp", std::string(adapter_text::kDsiGlass)});
  }
  return files;
}

}  // namespace zstrip::sim
