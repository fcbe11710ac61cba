// Opens panels with their own controller: wiring, reset, start sequence, backlight.
#include "open_panel.hpp"

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <iterator>
#include <memory>
#include <optional>
#include <string_view>
#include <system_error>
#include <type_traits>
#include <utility>

#include "panel_wiring.hpp"
#include "zstrip_hal/gc9a01.hpp"
#include "zstrip_hal/ili9341.hpp"
#include "zstrip_hal/ili9342.hpp"
#include "zstrip_hal/ili9488.hpp"
#include "zstrip_hal/output_pin.hpp"
#include "zstrip_hal/ssd0323.hpp"
#include "zstrip_hal/ssd1306.hpp"
#include "zstrip_hal/ssd1351.hpp"
#include "zstrip_hal/st7735.hpp"
#include "zstrip_hal/st7789.hpp"
#include "zstrip_hal/st7796.hpp"
#include "zstrip_hal_linux/sleeping_clock.hpp"

namespace zstrip::panel {
namespace {

using hal::Outcome;
using Opened = std::variant<DisplayPointer, Failure>;

/// A panel with all objects that it needs.
template <class Driver, class Bus>
class Panel final : public DisplayAdapter<Panel<Driver, Bus>> {
 public:
  template <class Config>
  Panel(Bus bus, hal::GpioPin reset, hal::GpioPin backlight, const Config& config)
      : bus_(std::move(bus)),
        reset_(std::move(reset)),
        backlight_(std::move(backlight)),
        driver_(make(bus_, clock_, config)) {}
  ~Panel() override {
    // Switches the backlight off first. Errors of a destructor cannot be reported.
    static_cast<void>(backlight_.set(false));
    if (!is_stranger_) static_cast<void>(driver_.sleep());
  }

  hal::Error start() {
    hal::Error error = hal::reset_panel(reset_, clock_);
    if (error == hal::Error::none) error = driver_.start();
    is_stranger_ = error == hal::Error::wrong_id;
    return error == hal::Error::none ? backlight_.set(true) : error;
  }
  Driver& display() { return driver_; }

 private:
  template <class Config>
  static Driver make(Bus& bus, hal::SleepingClock& clock, const Config& config) {
    if constexpr (std::is_constructible_v<Driver, Bus&, hal::SleepingClock&, const Config&>) {
      return Driver(bus, clock, config);
    } else {
      return Driver(bus, config);
    }
  }

  hal::SleepingClock clock_;
  Bus bus_;
  hal::GpioPin reset_;
  hal::GpioPin backlight_;
  Driver driver_;
  bool is_stranger_ = false;  ///< another controller, for which these commands have other meanings
};

/// Formats the three bytes of an id.
std::string in_hex(std::uint32_t id) {
  char text[12];
  std::snprintf(text, sizeof text, "%02x %02x %02x", static_cast<unsigned>(id >> 16 & 0xFF),
                static_cast<unsigned>(id >> 8 & 0xFF), static_cast<unsigned>(id & 0xFF));
  return text;
}

/// Returns, after Error::wrong_id, the controller that answers and the remedy, in words.
template <class Driver>
std::string what_answers(Driver& driver, const hal::DcsConfig& config) {
  std::uint32_t found = 0;
  if (const hal::Error error = driver.read_id(found); error != hal::Error::none)
    return std::string("the panel's id cannot be read: ") + hal::message(error);
  if (found == 0 || found == 0xFFFFFF) {
    return "the panel does not answer: its id reads " + in_hex(found) + ", not " + in_hex(config.id) +
           "; check its supply and the wire from its data output, or leave id out where there is none";
  }
  return "another panel answers: its id is " + in_hex(found) + ", not " + in_hex(config.id) +
         "; name its controller, or give its id as id=0x... if the module's maker has set one";
}

// The drivers of panels, with the bus as parameter.
template <class Bus>
using St7789 = hal::St7789<Bus, hal::SleepingClock>;
template <class Bus>
using Ili9341 = hal::Ili9341<Bus, hal::SleepingClock>;
template <class Bus>
using St7735 = hal::St7735<Bus, hal::SleepingClock>;
template <class Bus>
using St7735Rows132 = hal::St7735<Bus, hal::SleepingClock, hal::St7735Rows132Controller>;
template <class Bus>
using Gc9a01 = hal::Gc9a01<Bus, hal::SleepingClock>;
template <class Bus>
using St7796 = hal::St7796<Bus, hal::SleepingClock>;
template <class Bus>
using Ili9342 = hal::Ili9342<Bus, hal::SleepingClock>;
template <class Bus>
using Ili9488 = hal::Ili9488<Bus, hal::SleepingClock>;
template <class Bus>
using Ssd1351 = hal::Ssd1351<Bus>;
template <class Bus>
using Ssd1306 = hal::Ssd1306<Bus>;
template <class Bus>
using Ssd0323 = hal::Ssd0323<Bus>;

/// `usual_hertz` is the highest clock that the data sheet allows.
template <template <class> class Driver, class Config>
Opened start(const PanelWiring& wiring, std::uint32_t usual_hertz, const Config& config) {
  Outcome<OpenWiring> open = OpenWiring::open(wiring, usual_hertz);
  if (!open) return Failure{ExitStatus::device, open.fault().message};
  return std::visit(
      [&](auto& bus) -> Opened {
        using Bus = std::remove_reference_t<decltype(bus)>;
        auto panel = std::make_unique<Panel<Driver<Bus>, Bus>>(std::move(bus), std::move(open->reset),
                                                               std::move(open->backlight), config);
        const hal::Error error = panel->start();
        if constexpr (requires(std::uint32_t id) { panel->display().read_id(id); }) {
          if (error == hal::Error::wrong_id) return Failure{ExitStatus::device, what_answers(panel->display(), config)};
        }
        if (error != hal::Error::none) {
          const ExitStatus status = error == hal::Error::configuration ? ExitStatus::usage : ExitStatus::output;
          return Failure{status, std::string("the panel cannot be started: ") + hal::message(error)};
        }
        return DisplayPointer(std::move(panel));
      },
      open->bus);
}

/// A controller with MIPI's commands.
struct DcsKind {
  std::string_view name;
  const hal::DcsConfig& module;  ///< the usual one
  std::uint32_t id;
  std::uint32_t hertz;  ///< the highest clock that the data sheet allows
  Opened (*start)(const PanelWiring& wiring, std::uint32_t hertz, const hal::DcsConfig& config);
};
constexpr DcsKind kDcsKinds[] = {
    {"st7789", hal::kSt7789Module240x240, hal::St7789Controller::kId, 15'000'000, start<St7789, hal::DcsConfig>},
    {"ili9341", hal::kIli9341Module240x320, hal::Ili9341Controller::kId, 10'000'000, start<Ili9341, hal::DcsConfig>},
    {"st7735", hal::kSt7735Module128x160, hal::St7735Controller::kId, 15'000'000, start<St7735, hal::DcsConfig>},
    {"gc9a01", hal::kGc9a01Module240x240, hal::Gc9a01Controller::kId, 100'000'000, start<Gc9a01, hal::DcsConfig>},
    {"st7796", hal::kSt7796Module320x480, hal::St7796Controller::kId, 15'000'000, start<St7796, hal::DcsConfig>},
    {"ili9342", hal::kIli9342Module320x240, hal::Ili9342Controller::kId, 10'000'000, start<Ili9342, hal::DcsConfig>},
    {"ili9488", hal::kIli9488Module320x480, hal::Ili9488Controller::kId, 20'000'000, start<Ili9488, hal::DcsConfig>},
};

/// Takes the key `rotate`, in degrees clockwise, and `mirror`.
Outcome<hal::Orientation> take_orientation(DisplayAddress& address) {
  const auto degrees = address.take_number("rotate", 0, 270);
  if (!degrees) return degrees.fault();
  if (degrees->value_or(0) % 90 != 0) return address.fault("rotate", "is 0, 90, 180 or 270");
  const auto mirrored = address.take_flag("mirror");
  if (!mirrored) return mirrored.fault();
  return hal::Orientation{static_cast<hal::Rotation>(degrees->value_or(0) / 90), *mirrored};
}

/// Takes the key `id`: the controller's own id, or three bytes in hexadecimal. 0 if it is missing.
Outcome<std::uint32_t> take_id(DisplayAddress& address, std::uint32_t usual, bool can_read) {
  const std::optional<std::string> value = address.take("id");
  if (!value || *value == "no") return std::uint32_t{0};
  if (!can_read) return address.fault("id", "needs miso, the line on which the panel answers");
  if (*value == "yes") return usual;
  std::string_view digits = *value;
  if (digits.starts_with("0x") || digits.starts_with("0X")) digits.remove_prefix(2);
  std::uint32_t id = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), id, 16);
  if (error != std::errc{} || end != digits.data() + digits.size() || id == 0 || id >= 0xFFFFFF)
    return address.fault("id", "is three bytes, as 0x858552, not '" + *value + "'");
  return id;
}

/// Takes the keys of panels with MIPI's commands; `usual` has the defaults.
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
  const auto orientation = take_orientation(address);
  if (!orientation) return orientation.fault();
  config.orientation = *orientation;
  for (const auto& [key, member] : {std::pair("bgr", &config.bgr), {"inverted", &config.inverted}}) {
    const auto flag = address.take_flag(key, *member);
    if (!flag) return flag.fault();
    *member = *flag;
  }
  if (const auto format = address.take("format")) {
    if (*format == "rgb565") {
      config.format = hal::DisplayFormat::rgb565_swapped;
    } else if (*format == "rgb666") {
      config.format = hal::DisplayFormat::rgb666;
    } else if (*format == "rgb444") {
      config.format = hal::DisplayFormat::rgb444;
    } else {
      return address.fault("format", "is rgb565, rgb666 or rgb444, not '" + *format + "'");
    }
  }
  const bool sideways = is_sideways(config.orientation);
  const auto [width, other] =
      sideways ? std::pair(config.height, config.width) : std::pair(config.width, config.height);
  if (config.format == hal::DisplayFormat::rgb444 && width % 2 != 0) {
    const char* const remedy = other % 2 != 0 ? "" : sideways ? " (or rotate=0, 180)" : " (or rotate=90, 270)";
    return address.fault("format", std::string("rgb444 needs an even width") + remedy);
  }
  return config;
}

}  // namespace

std::string panel_kinds() {
  std::string kinds;
  for (const DcsKind& kind : kDcsKinds) kinds += std::string(kind.name) + ' ';
  return kinds + "ssd1351 ssd1306 ssd0323";
}

Opened open_panel(DisplayAddress& address) {
  const auto usage = [](const hal::Fault& fault) { return Failure{ExitStatus::usage, fault.message}; };
  const std::string& kind = address.kind();
  const auto* const dcs = std::ranges::find(kDcsKinds, std::string_view(kind), &DcsKind::name);
  const bool is_dcs = dcs != std::end(kDcsKinds);
  if (!is_dcs && kind != "ssd1351" && kind != "ssd1306" && kind != "ssd0323")
    return usage({"there is no display '" + kind + "'; there are fbdev drm sdl " + panel_kinds()});
  if (const auto refused = address.refused_device()) return usage(*refused);
  const Outcome<PanelWiring> wiring = PanelWiring::take(address);
  if (!wiring) return usage(wiring.fault());

  if (is_dcs) {
    Outcome<hal::DcsConfig> config = take_config(address, dcs->module);
    if (!config) return usage(config.fault());
    const Outcome<std::uint32_t> id = take_id(address, dcs->id, wiring->can_read());
    if (!id) return usage(id.fault());
    config->id = *id;
    if (const auto untaken = address.untaken()) return usage(*untaken);
    // A glass of so few rows is that of a module of 128x128 pixels.
    const bool has_132_rows =
        kind == "st7735" && config->row_offset + config->height <= hal::St7735Rows132Controller::kRows;
    return (has_132_rows ? start<St7735Rows132, hal::DcsConfig> : dcs->start)(*wiring, dcs->hertz, *config);
  }
  if (address.take("id")) return usage(address.fault("id", "cannot be read: this controller has none"));
  const Outcome<hal::Orientation> orientation = take_orientation(address);
  if (!orientation) return usage(orientation.fault());
  if (const auto untaken = address.untaken()) return usage(*untaken);
  if (kind == "ssd1351") return start<Ssd1351>(*wiring, 20'000'000, hal::Ssd1351Config{.orientation = *orientation});
  if (kind == "ssd1306") return start<Ssd1306>(*wiring, 10'000'000, hal::Ssd1306Config{.orientation = *orientation});
  return start<Ssd0323>(*wiring, 4'000'000, hal::Ssd0323Config{.orientation = *orientation});
}

}  // namespace zstrip::panel
