// Opens the panels with a controller of their own: lines, bus, reset, start sequence, backlight.
#include "open_panel.hpp"

#include <array>
#include <initializer_list>
#include <optional>
#include <string_view>
#include <utility>

#include "zstrip_hal/bit_banged_spi.hpp"
#include "zstrip_hal/ssd0323.hpp"
#include "zstrip_hal/st7789.hpp"
#include "zstrip_hal_linux/gpio.hpp"
#include "zstrip_hal_linux/sleeping_clock.hpp"
#include "zstrip_hal_linux/spidev.hpp"

namespace zstrip::panel {
namespace {

using hal::GpioPin;
using hal::Outcome;
using Opened = std::variant<DisplayPointer, Failure>;

Failure usage(const hal::Fault& fault) { return {ExitStatus::usage, fault.message}; }
Failure device(const hal::Fault& fault) { return {ExitStatus::device, fault.message}; }

/// The line that a key names, as an output; a pin without a line if the address does not have the key.
std::variant<GpioPin, Failure> take_pin(DisplayAddress& address, const std::string& key, bool level) {
  const std::optional<std::string> name = address.take(key);
  if (!name) return GpioPin();
  const auto in_words = [&key](const hal::Fault& fault) { return device({key + ": " + fault.message}); };
  const Outcome<hal::GpioLine> line = hal::find_gpio_line(*name);
  if (!line) return in_words(line.fault());
  Outcome<GpioPin> pin = GpioPin::request(*line, level);
  if (!pin) return in_words(pin.fault());
  return std::move(*pin);
}

/// Lines that every panel has beside its bus.
struct Lines {
  GpioPin reset;
  GpioPin backlight;
};

/// A panel that was started. What it stands on is older, and ends later.
template <class Bus, template <class> class Driver>
class Panel final : public DisplayAdapter<Panel<Bus, Driver>> {
 public:
  template <class Config>
  Panel(Bus bus, Lines lines, const Config& config)
      : bus_(std::move(bus)), lines_(std::move(lines)), driver_(bus_, clock_, config) {}
  ~Panel() override {
    static_cast<void>(lines_.backlight.set(false));
    if (started_) static_cast<void>(driver_.stop());
  }

  hal::Error start() {
    hal::Error error = hal::reset_panel(lines_.reset, clock_);
    if (error == hal::Error::none) error = driver_.panel.start();
    started_ = error == hal::Error::none;
    return started_ ? lines_.backlight.set(true) : error;
  }
  auto& display() { return driver_.panel; }

 private:
  hal::SleepingClock clock_;
  Bus bus_;
  Lines lines_;
  Driver<Bus> driver_;
  bool started_ = false;
};

// What a panel is made of and how it is put to rest, for each kind of driver.

template <class Bus>
struct St7789 {
  St7789(Bus& bus, hal::SleepingClock& clock, const hal::DcsConfig& config) : panel(bus, clock, config) {}
  hal::Error stop() { return panel.sleep(); }
  hal::St7789<Bus, hal::SleepingClock> panel;
};

template <class Bus>
struct Ssd0323 {
  Ssd0323(Bus& bus, hal::SleepingClock&, const hal::Ssd0323Config& config) : panel(bus, config) {}
  /// Black, which for an OLED is off.
  hal::Error stop() { return panel.start(); }
  hal::Ssd0323<Bus> panel;
};

template <template <class> class Driver, class Bus, class Config>
Opened start(Bus bus, Lines lines, const Config& config) {
  auto panel = std::make_unique<Panel<Bus, Driver>>(std::move(bus), std::move(lines), config);
  if (const hal::Error error = panel->start(); error != hal::Error::none)
    return Failure{ExitStatus::output, std::string("the panel cannot be started: ") + hal::message(error)};
  return DisplayPointer(std::move(panel));
}

/// Opens bus and lines, and starts the panel.
template <template <class> class Driver, class Config>
Opened open_on_bus(DisplayAddress& address, const Config& config, std::uint32_t usual_hertz) {
  const std::optional<std::string> spidev = address.take("spidev");
  const auto hertz = address.take_number("speed", 1'000, 1'000'000'000);
  if (!hertz) return usage(hertz.fault());

  // clock, data, select, dc, reset, backlight: reset and select rest high.
  const std::array<std::pair<const char*, bool>, 6> keys{
      {{"clock", false}, {"data", false}, {"select", true}, {"dc", false}, {"reset", true}, {"backlight", false}}};
  DisplayAddress given = address;
  const auto has = [&given](const char* key) { return given.take(key).has_value(); };
  const bool has_clock = has("clock"), has_data = has("data"), has_select = has("select");
  if (!has("dc")) return usage(address.fault("dc", "is missing: the line that tells commands from data"));
  if (spidev && (has_clock || has_data || has_select))
    return usage(address.fault("spidev", "does without clock, data and select: they are the controller's"));
  if (!spidev && (!has_clock || !has_data))
    return usage(address.fault("spidev", "is missing, or clock and data for a bus that is driven bit by bit"));
  if (!spidev && *hertz) return usage(address.fault("speed", "is only for spidev"));
  if (has("reset"), has("backlight"); const auto untaken = given.untaken()) return usage(*untaken);

  std::array<GpioPin, 6> pins;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    auto pin = take_pin(address, keys[i].first, keys[i].second);
    if (const Failure* failure = std::get_if<Failure>(&pin)) return *failure;
    pins[i] = std::move(std::get<GpioPin>(pin));
  }
  auto& [clock, data, select, data_command, reset, backlight] = pins;
  Lines lines{std::move(reset), std::move(backlight)};

  if (spidev) {
    Outcome<hal::SpidevBus> bus =
        hal::SpidevBus::open(*spidev, hertz->value_or(usual_hertz), std::move(data_command));
    if (!bus) return device(bus.fault());
    return start<Driver>(std::move(*bus), std::move(lines), config);
  }
  using Bus = hal::BitBangedSpi<GpioPin, GpioPin, GpioPin, GpioPin>;
  return start<Driver>(Bus(std::move(clock), std::move(data), std::move(data_command), std::move(select)),
                       std::move(lines), config);
}

}  // namespace
}  // namespace zstrip::panel
