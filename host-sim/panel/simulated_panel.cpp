// Combines drivers and models, with the wiring of the usual modules.
#include "panel/simulated_panel.hpp"

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

#include "panel/dcs_model.hpp"
#include "panel/on_qspi.hpp"
#include "panel/rgb_model.hpp"
#include "panel/rgb_scanner.hpp"
#include "panel/ssd0323_model.hpp"
#include "panel/ssd1306_model.hpp"
#include "panel/ssd1351_model.hpp"
#include "panel/ssd1680_model.hpp"
#include "zstrip_hal/changed_tiles.hpp"
#include "zstrip_hal/co5300.hpp"
#include "zstrip_hal/gc9a01.hpp"
#include "zstrip_hal/ili9341.hpp"
#include "zstrip_hal/ili9342.hpp"
#include "zstrip_hal/ili9488.hpp"
#include "zstrip_hal/scanned_panel.hpp"
#include "zstrip_hal/sh8601.hpp"
#include "zstrip_hal/ssd0323.hpp"
#include "zstrip_hal/ssd1306.hpp"
#include "zstrip_hal/ssd1351.hpp"
#include "zstrip_hal/ssd1680.hpp"
#include "zstrip_hal/st7735.hpp"
#include "zstrip_hal/st7789.hpp"
#include "zstrip_hal/st77916.hpp"
#include "zstrip_hal/st7796.hpp"

namespace zstrip::sim {
namespace {

using hal::DisplayFormat;

constexpr PanelModule kSt7789Modules[] = {{240, 240, 0, 0},  {240, 320, 0, 0},  {240, 280, 0, 20},
                                          {172, 320, 34, 0}, {170, 320, 35, 0}, {135, 240, 52, 40}};
constexpr PanelModule kIli9341Modules[] = {{240, 320, 0, 0}};
constexpr PanelModule kSt7735Modules[] = {{128, 160, 2, 1}, {128, 128, 2, 3}, {80, 160, 26, 1}};
constexpr PanelModule kGc9a01Modules[] = {{240, 240, 0, 0, true}};
constexpr PanelModule kSt7796Modules[] = {{320, 480, 0, 0}};
constexpr PanelModule kIli9342Modules[] = {{320, 240, 0, 0}};
constexpr PanelModule kIli9488Modules[] = {{320, 480, 0, 0}};
constexpr PanelModule kCo5300Modules[] = {{466, 466, 6, 0, true}, {410, 502, 22, 0}, {280, 456, 20, 0}};
constexpr PanelModule kSh8601Modules[] = {{368, 448, 0, 0}};
constexpr PanelModule kSt77916Modules[] = {{360, 360, 0, 0, true}};
constexpr PanelModule kSsd1351Modules[] = {{128, 128, 0, 0}, {128, 96, 0, 0}};
constexpr PanelModule kSsd1306Modules[] = {{128, 64, 0, 0}, {128, 32, 0, 0}, {64, 48, 32, 0}};
constexpr PanelModule kSsd0323Modules[] = {{128, 64, 0, 0}};
constexpr PanelModule kSsd1680Modules[] = {{128, 296, 0, 0}, {122, 250, 0, 0}};
constexpr PanelModule kSt7262Modules[] = {{480, 272, 0, 0}};

constexpr DisplayFormat kColours[] = {DisplayFormat::rgb565_swapped, DisplayFormat::rgb666, DisplayFormat::rgb444};
constexpr DisplayFormat kWideFirst[] = {DisplayFormat::rgb666, DisplayFormat::rgb565_swapped};
constexpr DisplayFormat kGreys[] = {DisplayFormat::gray4};
constexpr DisplayFormat kMono[] = {DisplayFormat::mono};
constexpr DisplayFormat kWords[] = {DisplayFormat::rgb565};

constexpr std::span<const DisplayFormat> kAll(kColours);

constexpr PanelKind kKinds[] = {
    {"st7789", kSt7789Modules, kAll, 66ns, 0ns},
    {"ili9341", kIli9341Modules, kAll.first(2), 100ns, 0ns},
    {"st7735", kSt7735Modules, kAll, 66ns, 0ns},
    {"gc9a01", kGc9a01Modules, kAll.first(2), 10ns, 0ns},
    {"st7796", kSt7796Modules, kAll.first(2), 66ns, 0ns},
    {"ili9342", kIli9342Modules, kAll.first(2), 100ns, 0ns},
    {"ili9488", kIli9488Modules, kWideFirst, 50ns, 0ns},
    {"ssd1351", kSsd1351Modules, kAll.first(1), 50ns, 0ns},
    {"ssd1306", kSsd1306Modules, kMono, 100ns, 2500ns},
    {"ssd0323", kSsd0323Modules, kGreys, 250ns, 0ns},
    {"ssd1680", kSsd1680Modules, kMono, 50ns, 0ns},
    {"co5300", kCo5300Modules, kAll.first(1), 0ns, 0ns, 20ns},
    {"sh8601", kSh8601Modules, kAll.first(1), 0ns, 0ns, 20ns},
    {"st77916", kSt77916Modules, kAll.first(1), 0ns, 0ns, 20ns},
    {"st7262", kSt7262Modules, kWords, 0ns, 0ns, 0ns, 83ns},
};

/// Owns the objects that the driver refers to.
template <class Driver>
class PanelOf final : public SimulatedPanel {
 public:
  template <class MakeDriver>
  PanelOf(std::unique_ptr<PanelModel> model, const BusTiming& timing, MakeDriver make_driver)
      : model_(std::move(model)), bus_(*model_, timing), driver_(make_driver(bus_)) {
    bus_.wait(120'000);
  }

  hal::Error start() override { return driver_.start(); }
  std::uint16_t width() const override { return driver_.width(); }
  std::uint16_t height() const override { return driver_.height(); }
  DisplayFormat format() const override { return driver_.format(); }
  hal::Error begin_frame() override { return driver_.begin_frame(); }
  hal::Error write(const hal::Area& area, std::span<std::byte> pixels) override { return driver_.write(area, pixels); }
  hal::Error wait() override { return driver_.wait(); }
  hal::Error end_frame() override { return driver_.end_frame(); }

  const PanelModel& model() const override { return *model_; }
  std::uint64_t bytes() const override { return bus_.bytes(); }
  Nanoseconds busy() const override { return bus_.busy() + model_->refreshing(); }

 private:
  std::unique_ptr<PanelModel> model_;
  ModelBus bus_;
  Driver driver_;
};

/// `Display` is the driver of a panel with MIPI's commands, with bus and clock as its parameters.
template <template <class, class> class Display, class Controller>
std::unique_ptr<SimulatedPanel> dcs_panel(const PanelRequest& request, const DcsPart& part, hal::DcsConfig config) {
  config.width = request.module.width;
  config.height = request.module.height;
  config.column_offset = request.module.column_offset;
  config.row_offset = request.module.row_offset;
  config.orientation = request.orientation;
  config.format = request.format;
  config.id = Controller::kId;  // this panel's data output is wired
  const Glass glass{.width = config.width,
                    .height = config.height,
                    .column_offset = config.column_offset,
                    .row_offset = config.row_offset,
                    .columns_reversed = config.columns_reversed,
                    .rows_reversed = config.rows_reversed,
                    .bgr = config.bgr,
                    .inverted = config.inverted,
                    .is_round = request.module.is_round};
  auto model = std::make_unique<DcsModel>(part, glass);
  const BusTiming timing = timing_of(request.bus, request.cycle);
  if (part.has_qspi) {
    return std::make_unique<PanelOf<OnQspi<Display>>>(
        std::move(model), timing, [&config](ModelBus& bus) { return OnQspi<Display>(bus, config); });
  }
  using Driver = Display<ModelBus, ModelBus>;
  return std::make_unique<PanelOf<Driver>>(std::move(model), timing,
                                           [&config](ModelBus& bus) { return Driver(bus, bus, config); });
}

template <class Bus, class Time>
using St7735 = hal::St7735<Bus, Time>;

std::unique_ptr<SimulatedPanel> ssd1351_panel(const PanelRequest& request) {
  using Driver = hal::Ssd1351<ModelBus>;
  const hal::Ssd1351Config config{.height = request.module.height, .orientation = request.orientation};
  return std::make_unique<PanelOf<Driver>>(std::make_unique<Ssd1351Model>(Ssd1351Glass{.height = config.height}),
                                           timing_of(request.bus, request.cycle),
                                           [&config](ModelBus& bus) { return Driver(bus, config); });
}

std::unique_ptr<SimulatedPanel> ssd1306_panel(const PanelRequest& request) {
  using Driver = hal::Ssd1306<ModelBus>;
  const bool alternating = request.module.height > 32;
  const hal::Ssd1306Config config{.width = static_cast<std::uint8_t>(request.module.width),
                                  .height = static_cast<std::uint8_t>(request.module.height),
                                  .column_offset = static_cast<std::uint8_t>(request.module.column_offset),
                                  .orientation = request.orientation,
                                  .com_alternating = alternating};
  const Ssd1306Glass glass{.width = request.module.width,
                           .height = request.module.height,
                           .column_offset = request.module.column_offset,
                           .com_alternating = alternating};
  const Nanoseconds fastest = request.kind->fastest(request.bus);
  return std::make_unique<PanelOf<Driver>>(std::make_unique<Ssd1306Model>(glass, fastest),
                                           timing_of(request.bus, request.cycle),
                                           [&config](ModelBus& bus) { return Driver(bus, config); });
}

std::unique_ptr<SimulatedPanel> ssd0323_panel(const PanelRequest& request) {
  using Driver = hal::Ssd0323<ModelBus>;
  const hal::Ssd0323Config config{.orientation = request.orientation};
  return std::make_unique<PanelOf<Driver>>(std::make_unique<Ssd0323Model>(), timing_of(request.bus, request.cycle),
                                           [&config](ModelBus& bus) { return Driver(bus, config); });
}

/// The BUSY line of e-paper.
struct BusyPin {
  const Ssd1680Model* panel;
  hal::Error read(bool& high) {
    high = panel->is_busy();
    return hal::Error::none;
  }
};

/// The picture's memory is destroyed after the driver that refers to it.
struct PictureMemory {
  std::vector<std::byte> bytes;
};
class ModelledSsd1680 : private PictureMemory, public hal::Ssd1680<ModelBus, BusyPin, ModelBus> {
 public:
  ModelledSsd1680(ModelBus& bus, const Ssd1680Model& panel, const hal::Ssd1680Config& config)
      : PictureMemory{std::vector<std::byte>(memory_bytes(config))}, Ssd1680(bus, {&panel}, bus, bytes, config) {}
};

std::unique_ptr<SimulatedPanel> ssd1680_panel(const PanelRequest& request) {
  const hal::Ssd1680Config config{
      .width = request.module.width, .height = request.module.height, .orientation = request.orientation};
  auto model = std::make_unique<Ssd1680Model>(Ssd1680Glass{.width = config.width, .height = config.height});
  const Ssd1680Model& panel = *model;
  return std::make_unique<PanelOf<ModelledSsd1680>>(std::move(model), timing_of(request.bus, request.cycle),
                                                    [&](ModelBus& bus) { return ModelledSsd1680(bus, panel, config); });
}

/// An RGB panel whose controller reads strips of eight rows. Drawing takes no time here, so that no strip is late, and
/// a frame is a refresh.
class RgbPanel final : public SimulatedPanel {
 public:
  static constexpr std::uint16_t kRows = 8;

  explicit RgbPanel(const RgbTimings& timings)
      : scanner_(model_, timings, kRows,
                 [this](std::span<std::byte> buffer, std::uint16_t strip) {
                   driver_.ask(buffer, strip);
                   asked_for_ = strip;
                 }),
        driver_(scanner_, {.width = timings.width, .height = timings.height, .rows = kRows}) {}

  hal::Error start() override {
    scanner_.start();
    read_to_the_last_strip();
    begin_ = model_.now();
    return hal::Error::none;
  }
  std::uint16_t width() const override { return driver_.width(); }
  std::uint16_t height() const override { return driver_.height(); }
  DisplayFormat format() const override { return driver_.format(); }
  hal::Error begin_frame() override { return driver_.begin_frame(); }
  hal::Error write(const hal::Area& area, std::span<std::byte> pixels) override {
    const std::size_t row = hal::bytes_per_row(area.width, format());
    for (std::uint16_t from = 0; from < area.height; from = static_cast<std::uint16_t>(from + kRows)) {
      const auto rows = static_cast<std::uint16_t>(std::min<int>(kRows, area.height - from));
      const hal::Area part{area.left, static_cast<std::uint16_t>(area.top + from), area.width, rows};
      const hal::Error error = driver_.write(part, pixels.subspan(from * row, rows * row));
      if (error != hal::Error::none) return error;
    }
    return hal::Error::none;
  }
  hal::Error wait() override { return driver_.wait(); }
  hal::Error end_frame() override {
    read_to_the_last_strip();
    scanner_.show_rest();
    return driver_.end_frame();
  }

  const PanelModel& model() const override { return model_; }
  std::uint64_t bytes() const override { return scanner_.bytes(); }
  Nanoseconds busy() const override { return model_.now() - begin_; }

 private:
  /// Waits until the controller asks for the first strip of the next frame.
  void read_to_the_last_strip() {
    do scanner_.wait(1);
    while (asked_for_ != 0);
  }

  RgbModel model_;
  RgbScanner scanner_;
  hal::ScannedPanel<RgbScanner> driver_;
  std::uint16_t asked_for_ = 0;  // the strip
  Nanoseconds begin_{};
};

std::unique_ptr<SimulatedPanel> whole_panel(const PanelRequest& request) {
  const std::string_view name = request.kind->name;
  if (name == "st7262") {
    RgbTimings timings = kRgbTimings480x272;
    timings.pixel = request.cycle;
    return std::make_unique<RgbPanel>(timings);
  }
  if (name == "ssd1351") return ssd1351_panel(request);
  if (name == "ssd1306") return ssd1306_panel(request);
  if (name == "ssd0323") return ssd0323_panel(request);
  if (name == "ssd1680") return ssd1680_panel(request);
  if (name == "ili9341") {
    return dcs_panel<hal::Ili9341, hal::Ili9341Controller>(request, kIli9341Part, hal::kIli9341Module240x320);
  }
  if (name == "st7735")
    return dcs_panel<St7735, hal::St7735Controller>(request, kSt7735Part, hal::kSt7735Module128x160);
  if (name == "gc9a01") {
    return dcs_panel<hal::Gc9a01, hal::Gc9a01Controller>(request, kGc9a01Part, hal::kGc9a01Module240x240);
  }
  if (name == "st7796") {
    return dcs_panel<hal::St7796, hal::St7796Controller>(request, kSt7796Part, hal::kSt7796Module320x480);
  }
  if (name == "ili9342") {
    return dcs_panel<hal::Ili9342, hal::Ili9342Controller>(request, kIli9342Part, hal::kIli9342Module320x240);
  }
  if (name == "co5300") {
    return dcs_panel<hal::Co5300, hal::Co5300Controller>(request, kCo5300Part, hal::kCo5300Module466x466);
  }
  if (name == "sh8601") {
    return dcs_panel<hal::Sh8601, hal::Sh8601Controller>(request, kSh8601Part, hal::kSh8601Module368x448);
  }
  if (name == "st77916") {
    return dcs_panel<hal::St77916, hal::St77916Controller>(request, kSt77916Part, hal::kSt77916Module360x360);
  }
  if (name == "ili9488") {
    return dcs_panel<hal::Ili9488, hal::Ili9488Controller>(request, kIli9488Part, hal::kIli9488Module320x480);
  }
  return dcs_panel<hal::St7789, hal::St7789Controller>(request, kSt7789Part, hal::kSt7789Module240x240);
}

/// Sends only the changed tiles to another panel. It has tiles for each strip of each module.
class ChangesPanel final : public SimulatedPanel {
 public:
  explicit ChangesPanel(std::unique_ptr<SimulatedPanel> panel) : panel_(std::move(panel)), changes_(*panel_) {}

  hal::Error start() override { return changes_.start(); }
  std::uint16_t width() const override { return changes_.width(); }
  std::uint16_t height() const override { return changes_.height(); }
  DisplayFormat format() const override { return changes_.format(); }
  hal::Error begin_frame() override { return changes_.begin_frame(); }
  hal::Error write(const hal::Area& area, std::span<std::byte> pixels) override { return changes_.write(area, pixels); }
  hal::Error wait() override { return changes_.wait(); }
  hal::Error end_frame() override { return changes_.end_frame(); }
  bool shows(const hal::Area& area, std::uint32_t fingerprint) override { return changes_.shows(area, fingerprint); }

  const PanelModel& model() const override { return panel_->model(); }
  std::uint64_t bytes() const override { return panel_->bytes(); }
  Nanoseconds busy() const override { return panel_->busy(); }

 private:
  std::unique_ptr<SimulatedPanel> panel_;
  hal::ChangedTiles<SimulatedPanel, 16384, 16, kStrips> changes_;
};

}  // namespace

std::span<const PanelKind> panel_kinds() { return kKinds; }

BusTiming timing_of(BusKind bus, Nanoseconds cycle) {
  if (bus != BusKind::i2c) return {.byte = 8 * cycle, .transfer = 0ns, .cycle = cycle};
  // Each byte has an acknowledge bit. Start, address and control byte come before them, stop comes after them.
  return {.byte = 9 * cycle, .transfer = (1 + 9 + 9 + 1) * cycle, .cycle = cycle};
}

std::unique_ptr<SimulatedPanel> open_panel(const PanelRequest& request) {
  std::unique_ptr<SimulatedPanel> panel = whole_panel(request);
  if (!request.changes) return panel;
  return std::make_unique<ChangesPanel>(std::move(panel));
}

bool has_orientation(const PanelKind& kind, const hal::Orientation& orientation) {
  const std::string_view name = kind.name;
  if (kind.fastest_rgb != 0ns) return orientation == hal::Orientation{};
  const hal::DcsTraits traits = name == "co5300"   ? hal::Co5300Controller::kTraits
                                : name == "sh8601" ? hal::Sh8601Controller::kTraits
                                                   : hal::DcsTraits{};
  const hal::Scan scan = scan_of(orientation);
  return (traits.exchanges || !scan.exchanged) && (traits.reverses_rows || !scan.rows_reversed);
}

Nanoseconds longest_cycle(BusKind bus) {
  if (bus != BusKind::rgb) return 0ns;
  // A strip and the blanking are read between two requests.
  RgbTimings timings = kRgbTimings480x272;
  timings.pixel = 1ns;
  return Nanoseconds(std::chrono::microseconds(hal::kMaxScanMicroseconds)) /
         ((RgbPanel::kRows + timings.rows.total()) * timings.row_time().count());
}

std::uint16_t row_step(const PanelRequest& request) {
  const bool sideways = is_sideways(request.orientation);
  const std::string_view name = request.kind->name;
  if (name == "ssd1306" && !sideways) return hal::Ssd1306<ModelBus>::kRowStep;
  if (name == "ssd0323" && sideways) return hal::Ssd0323<ModelBus>::kRowStep;
  if (name == "st7262") return RgbPanel::kRows;
  if (name == "co5300" || name == "sh8601") return hal::Co5300<ModelBus, ModelBus>::kRowStep;
  return 1;
}

}  // namespace zstrip::sim
