// Opens the panels with a controller of their own: wiring, reset, start sequence, backlight.
#include "open_panel.hpp"

#include <memory>
#include <optional>
#include <utility>

#include "panel_wiring.hpp"
#include "zstrip_hal/output_pin.hpp"
#include "zstrip_hal/ssd0323.hpp"
#include "zstrip_hal/st7789.hpp"
#include "zstrip_hal_linux/sleeping_clock.hpp"

namespace zstrip::panel {
namespace {

using hal::Outcome;
using Opened = std::variant<DisplayPointer, Failure>;

// A driver, and how its panel is put to rest.

template <class Bus>
struct St7789 {
  St7789(Bus& bus, hal::SleepingClock& clock, const hal::DcsConfig& config) : driver(bus, clock, config) {}
  hal::Error rest() { return driver.sleep(); }
  hal::St7789<Bus, hal::SleepingClock> driver;
};

template <class Bus>
struct Ssd0323 {
  Ssd0323(Bus& bus, hal::SleepingClock& /*clock*/, const hal::Ssd0323Config& config) : driver(bus, config) {}
  hal::Error rest() { return driver.start(); }  // black: an OLED's pixels are off then
  hal::Ssd0323<Bus> driver;
};

/// A panel with everything that it stands on.
template <template <class> class Kind, class Bus>
class Panel final : public DisplayAdapter<Panel<Kind, Bus>> {
 public:
  template <class Config>
  Panel(Bus bus, hal::GpioPin reset, hal::GpioPin backlight, const Config& config)
      : bus_(std::move(bus)), reset_(std::move(reset)), backlight_(std::move(backlight)), kind_(bus_, clock_, config) {}
  ~Panel() override {
    // Dark first. What fails now has nobody to be told.
    static_cast<void>(backlight_.set(false));
    static_cast<void>(kind_.rest());
  }

  hal::Error start() {
    hal::Error error = hal::reset_panel(reset_, clock_);
    if (error == hal::Error::none) error = kind_.driver.start();
    return error == hal::Error::none ? backlight_.set(true) : error;
  }
  auto& display() { return kind_.driver; }

 private:
  hal::SleepingClock clock_;
  Bus bus_;
  hal::GpioPin reset_;
  hal::GpioPin backlight_;
  Kind<Bus> kind_;
};

template <template <class> class Kind, class Config>
Opened start(const PanelWiring& wiring, std::uint32_t usual_hertz, const Config& config) {
  Outcome<OpenWiring> open = OpenWiring::open(wiring, usual_hertz);
  if (!open) return Failure{ExitStatus::device, open.fault().message};
  return std::visit(
      [&](auto& bus) -> Opened {
        using Bus = std::remove_reference_t<decltype(bus)>;
        auto panel = std::make_unique<Panel<Kind, Bus>>(std::move(bus), std::move(open->reset),
                                                        std::move(open->backlight), config);
        if (const hal::Error error = panel->start(); error != hal::Error::none) {
          const ExitStatus status = error == hal::Error::configuration ? ExitStatus::usage : ExitStatus::output;
          return Failure{status, std::string("the panel cannot be started: ") + hal::message(error)};
        }
        return DisplayPointer(std::move(panel));
      },
      open->bus);
}

/// The keys of panels with MIPI's commands; `usual` is what they are without.
Outcome<hal::DcsConfig> take_config(DisplayAddress& address, const hal::DcsConfig& usual) {
  hal::DcsConfig config = usual;
  const auto size = address.take_size("size");
  if (!size) return size.fault();
  if (*size) {
    config.width = (*size)->width;
    config.height = (*size)->height;
  }
  const auto column = address.take_number("column", 0, UINT16_MAX);
  if (!column) return column.fault();
  config.column_offset = static_cast<std::uint16_t>(column->value_or(config.column_offset));
  const auto row = address.take_number("row", 0, UINT16_MAX);
  if (!row) return row.fault();
  config.row_offset = static_cast<std::uint16_t>(row->value_or(config.row_offset));
  const auto degrees = address.take_number("rotate", 0, 270);
  if (!degrees) return degrees.fault();
  if (degrees->value_or(0) % 90 != 0) return address.fault("rotate", "is 0, 90, 180 or 270");
  config.orientation.rotation = static_cast<hal::Rotation>(degrees->value_or(0) / 90);
  for (const auto& [key, member] :
       {std::pair("mirror", &config.orientation.mirrored), {"bgr", &config.bgr}, {"inverted", &config.inverted}}) {
    const auto flag = address.take_flag(key, *member);
    if (!flag) return flag.fault();
    *member = *flag;
  }
  if (const auto format = address.take("format")) {
    if (*format == "rgb565") {
      config.format = hal::PixelFormat::rgb565_swapped;
    } else if (*format == "rgb666") {
      config.format = hal::PixelFormat::rgb666;
    } else if (*format == "rgb444") {
      config.format = hal::PixelFormat::rgb444;
    } else {
      return address.fault("format", "is rgb565, rgb666 or rgb444, not '" + *format + "'");
    }
  }
  return config;
}

}  // namespace

std::string panel_kinds() { return "st7789 ssd0323"; }

Opened open_panel(DisplayAddress& address) {
  const auto usage = [](const hal::Fault& fault) { return Failure{ExitStatus::usage, fault.message}; };
  const bool is_dcs = address.kind() == "st7789";
  if (!is_dcs && address.kind() != "ssd0323")
    return usage({"there is no display '" + address.kind() + "'; there are fbdev drm " + panel_kinds()});
  const Outcome<PanelWiring> wiring = PanelWiring::take(address);
  if (!wiring) return usage(wiring.fault());
  Outcome<hal::DcsConfig> config = hal::kSt7789Module240x240;
  if (is_dcs) config = take_config(address, *config);
  if (!config) return usage(config.fault());
  if (const auto untaken = address.untaken()) return usage(*untaken);

  // Clocks that the data sheets allow.
  if (is_dcs) return start<St7789>(*wiring, 15'000'000, *config);
  return start<Ssd0323>(*wiring, 4'000'000, hal::Ssd0323Config{});
}

}  // namespace zstrip::panel
