// Each controller to the tests: its driver, its model, and the configurations to try.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "panel/dcs_model.hpp"
#include "panel/model_bus.hpp"
#include "panel/on_qspi.hpp"
#include "panel/ssd0323_model.hpp"
#include "panel/ssd1306_model.hpp"
#include "panel/ssd1351_model.hpp"
#include "zstrip_hal/co5300.hpp"
#include "zstrip_hal/gc9a01.hpp"
#include "zstrip_hal/ili9341.hpp"
#include "zstrip_hal/ili9342.hpp"
#include "zstrip_hal/ili9488.hpp"
#include "zstrip_hal/sh8601.hpp"
#include "zstrip_hal/ssd0323.hpp"
#include "zstrip_hal/ssd1306.hpp"
#include "zstrip_hal/ssd1351.hpp"
#include "zstrip_hal/st7735.hpp"
#include "zstrip_hal/st7789.hpp"
#include "zstrip_hal/st77916.hpp"
#include "zstrip_hal/st7796.hpp"

namespace zstrip::panels {

using hal::DisplayFormat;
using hal::Orientation;
using hal::Rotation;

inline constexpr Orientation kOrientations[] = {
    {Rotation::none, false}, {Rotation::by_90, false}, {Rotation::by_180, false}, {Rotation::by_270, false},
    {Rotation::none, true},  {Rotation::by_90, true},  {Rotation::by_180, true},  {Rotation::by_270, true}};

/// Areas begin and end at multiples of these.
struct Step {
  unsigned x = 1, y = 1;
};

template <class Display, const sim::DcsPart& part, DisplayFormat... formats>
struct Dcs {
  using Driver = Display;
  using Config = hal::DcsConfig;
  static std::string name() { return part.name; }

  static std::vector<Config> configs() {
    std::vector<Config> all;
    for (const Orientation& orientation : kOrientations) {
      for (const DisplayFormat format : {formats...}) {
        for (const unsigned wiring : {0U, 1U, 2U, 7U, 12U}) {
          all.push_back({.width = 34,
                         .height = 22,
                         .column_offset = 7,
                         .row_offset = 11,
                         .orientation = orientation,
                         .format = format,
                         .columns_reversed = (wiring & 1) != 0,
                         .rows_reversed = (wiring & 2) != 0,
                         .bgr = (wiring & 4) != 0,
                         .inverted = (wiring & 8) != 0});
        }
      }
      all.push_back({.width = part.columns, .height = part.rows, .orientation = orientation});
    }
    return all;
  }
  static Step step(const Config& config) { return {config.format == DisplayFormat::rgb444 ? 2U : 1U, 1}; }
  static std::unique_ptr<sim::DcsModel> model(const Config& config) {
    return std::make_unique<sim::DcsModel>(part, sim::Glass{.width = config.width,
                                                            .height = config.height,
                                                            .column_offset = config.column_offset,
                                                            .row_offset = config.row_offset,
                                                            .columns_reversed = config.columns_reversed,
                                                            .rows_reversed = config.rows_reversed,
                                                            .bgr = config.bgr,
                                                            .inverted = config.inverted});
  }
  static Driver driver(sim::ModelBus& bus, const Config& config) { return Driver(bus, bus, config); }
};

using St7789 = Dcs<hal::St7789<sim::ModelBus, sim::ModelBus>, sim::kSt7789Part, DisplayFormat::rgb565_swapped,
                   DisplayFormat::rgb666, DisplayFormat::rgb444>;
using Ili9341 = Dcs<hal::Ili9341<sim::ModelBus, sim::ModelBus>, sim::kIli9341Part, DisplayFormat::rgb565_swapped,
                    DisplayFormat::rgb666>;
using St7735 = Dcs<hal::St7735<sim::ModelBus, sim::ModelBus>, sim::kSt7735Part, DisplayFormat::rgb565_swapped,
                   DisplayFormat::rgb666, DisplayFormat::rgb444>;
using St7735Gm11 = Dcs<hal::St7735<sim::ModelBus, sim::ModelBus, hal::St7735Gm11Controller>, sim::kSt7735Gm11Part,
                       DisplayFormat::rgb565_swapped>;
using St7735Rows132 = Dcs<hal::St7735<sim::ModelBus, sim::ModelBus, hal::St7735Rows132Controller>,
                          sim::kSt7735Rows132Part, DisplayFormat::rgb565_swapped>;
using Gc9a01 = Dcs<hal::Gc9a01<sim::ModelBus, sim::ModelBus>, sim::kGc9a01Part, DisplayFormat::rgb565_swapped,
                   DisplayFormat::rgb666>;
using St7796 = Dcs<hal::St7796<sim::ModelBus, sim::ModelBus>, sim::kSt7796Part, DisplayFormat::rgb565_swapped,
                   DisplayFormat::rgb666>;
using Ili9342 = Dcs<hal::Ili9342<sim::ModelBus, sim::ModelBus>, sim::kIli9342Part, DisplayFormat::rgb565_swapped,
                    DisplayFormat::rgb666>;
using Ili9488 = Dcs<hal::Ili9488<sim::ModelBus, sim::ModelBus>, sim::kIli9488Part, DisplayFormat::rgb565_swapped,
                    DisplayFormat::rgb666>;
/// On QSPI, with even offsets and areas where the part wants them, and the orientations that it has.
template <template <class, class> class Display, const sim::DcsPart& part>
struct QspiDcs {
  using Driver = sim::OnQspi<Display>;
  using Config = hal::DcsConfig;
  static std::string name() { return part.name; }

  static std::vector<Config> configs() {
    std::vector<Config> all;
    for (const Orientation& orientation : kOrientations) {
      if ((access_of(orientation) & ~part.access) != 0) continue;
      for (const unsigned wiring : {0U, 4U, 8U}) {
        all.push_back({.width = 34,
                       .height = 22,
                       .column_offset = 6,
                       .row_offset = 10,
                       .orientation = orientation,
                       .bgr = (wiring & 4) != 0,
                       .inverted = (wiring & 8) != 0});
      }
    }
    all.push_back({.width = part.columns, .height = part.rows});
    return all;
  }
  static Step step(const Config& /*config*/) { return part.has_even_windows ? Step{2, 2} : Step{}; }
  static std::unique_ptr<sim::DcsModel> model(const Config& config) {
    return std::make_unique<sim::DcsModel>(part, sim::Glass{.width = config.width,
                                                            .height = config.height,
                                                            .column_offset = config.column_offset,
                                                            .row_offset = config.row_offset,
                                                            .bgr = config.bgr,
                                                            .inverted = config.inverted});
  }
  static Driver driver(sim::ModelBus& bus, const Config& config) { return Driver(bus, config); }

 private:
  static unsigned access_of(const Orientation& orientation) {
    const hal::Scan scan = scan_of(orientation);
    return (scan.rows_reversed ? 0x80U : 0U) | (scan.columns_reversed ? 0x40U : 0U) | (scan.exchanged ? 0x20U : 0U);
  }
};
using Co5300 = QspiDcs<hal::Co5300, sim::kCo5300Part>;
using Sh8601 = QspiDcs<hal::Sh8601, sim::kSh8601Part>;
using St77916 = QspiDcs<hal::St77916, sim::kSt77916Part>;

struct Ssd1351 {
  using Driver = hal::Ssd1351<sim::ModelBus>;
  using Config = hal::Ssd1351Config;
  static std::string name() { return "SSD1351"; }

  static std::vector<Config> configs() {
    std::vector<Config> all;
    for (const Orientation& orientation : kOrientations) {
      for (const unsigned wiring : {0U, 1U, 2U, 7U}) {
        all.push_back({.height = static_cast<std::uint16_t>(wiring == 1 ? 96 : 128),
                       .orientation = orientation,
                       .columns_reversed = (wiring & 1) != 0,
                       .rows_reversed = (wiring & 2) != 0,
                       .bgr = (wiring & 4) != 0});
      }
    }
    return all;
  }
  static Step step(const Config& /*config*/) { return {}; }
  static std::unique_ptr<sim::Ssd1351Model> model(const Config& config) {
    return std::make_unique<sim::Ssd1351Model>(sim::Ssd1351Glass{.height = config.height,
                                                                 .columns_reversed = config.columns_reversed,
                                                                 .rows_reversed = config.rows_reversed,
                                                                 .bgr = config.bgr});
  }
  static Driver driver(sim::ModelBus& bus, const Config& config) { return Driver(bus, config); }
};

struct Ssd1306 {
  using Driver = hal::Ssd1306<sim::ModelBus>;
  using Config = hal::Ssd1306Config;
  static std::string name() { return "SSD1306"; }

  static std::vector<Config> configs() {
    std::vector<Config> all;
    for (const Orientation& orientation : kOrientations) {
      for (const unsigned wiring : {0U, 1U, 2U, 3U}) {
        const bool reversed_columns = (wiring & 1) != 0, reversed_rows = (wiring & 2) != 0;
        all.push_back(
            {.orientation = orientation, .columns_reversed = reversed_columns, .rows_reversed = reversed_rows});
        all.push_back({.width = 65,
                       .height = 40,
                       .column_offset = 31,
                       .orientation = orientation,
                       .columns_reversed = reversed_columns,
                       .rows_reversed = reversed_rows,
                       .com_alternating = false,
                       .charge_pump = false});
      }
    }
    return all;
  }
  static Step step(const Config& config) { return is_sideways(config.orientation) ? Step{8, 1} : Step{1, 8}; }
  static std::unique_ptr<sim::Ssd1306Model> model(const Config& config) {
    return std::make_unique<sim::Ssd1306Model>(sim::Ssd1306Glass{.width = config.width,
                                                                 .height = config.height,
                                                                 .column_offset = config.column_offset,
                                                                 .columns_reversed = config.columns_reversed,
                                                                 .rows_reversed = config.rows_reversed,
                                                                 .com_alternating = config.com_alternating,
                                                                 .charge_pump = config.charge_pump});
  }
  static Driver driver(sim::ModelBus& bus, const Config& config) { return Driver(bus, config); }
};

struct Ssd0323 {
  using Driver = hal::Ssd0323<sim::ModelBus>;
  using Config = hal::Ssd0323Config;
  static std::string name() { return "SSD0323"; }

  static std::vector<Config> configs() {
    std::vector<Config> all;
    for (const Orientation& orientation : kOrientations) {
      for (const unsigned wiring : {0U, 1U, 2U, 7U}) {
        all.push_back({.orientation = orientation,
                       .columns_reversed = (wiring & 1) != 0,
                       .rows_reversed = (wiring & 2) != 0,
                       .com_split = (wiring & 4) != 0,
                       .dc_dc_converter = wiring != 0});
      }
    }
    return all;
  }
  static Step step(const Config& config) { return is_sideways(config.orientation) ? Step{1, 2} : Step{2, 1}; }
  static std::unique_ptr<sim::Ssd0323Model> model(const Config& config) {
    return std::make_unique<sim::Ssd0323Model>(sim::Ssd0323Glass{.columns_reversed = config.columns_reversed,
                                                                 .rows_reversed = config.rows_reversed,
                                                                 .com_split = config.com_split,
                                                                 .display_offset = config.display_offset});
  }
  static Driver driver(sim::ModelBus& bus, const Config& config) { return Driver(bus, config); }
};

}  // namespace zstrip::panels
