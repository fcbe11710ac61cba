// Parses and opens the wiring of a panel on a Linux machine.
#include "panel_wiring.hpp"

#include <charconv>
#include <string_view>
#include <system_error>
#include <utility>

namespace zstrip::panel {
namespace {

using hal::GpioInput;
using hal::GpioPin;
using hal::Outcome;

/// Returns a pin without a line if there is no `name`; else the result of Pin::request() for the line and `level`.
template <class Pin, class... Level>
Outcome<Pin> open_pin(const char* key, const std::optional<std::string>& name, Level... level) {
  if (!name) return Pin();
  const auto in_words = [key](const hal::Fault& fault) { return hal::Fault{std::string(key) + ": " + fault.message}; };
  const Outcome<hal::GpioLine> line = hal::find_gpio_line(*name);
  if (!line) return in_words(line.fault());
  Outcome<Pin> pin = Pin::request(*line, level...);
  if (!pin) return in_words(pin.fault());
  return pin;
}

/// Parses an address of 7 bits that devices may have; decimal, or hexadecimal as 0x3c.
std::optional<std::uint8_t> i2c_address(std::string_view text) {
  const bool hexadecimal = text.starts_with("0x") || text.starts_with("0X");
  if (hexadecimal) text.remove_prefix(2);
  std::uint8_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, hexadecimal ? 16 : 10);
  if (error != std::errc{} || end != text.data() + text.size() || value < 0x08 || value > 0x77) return std::nullopt;
  return value;
}

Outcome<PanelWiring> take_i2c(DisplayAddress& address, PanelWiring wiring) {
  if (address.kind() != "ssd1306") return address.fault("i2c", "is only for ssd1306: other controllers have none");
  if (wiring.spidev || wiring.clock || wiring.data || wiring.select || wiring.miso || wiring.data_command ||
      wiring.hertz)
    return address.fault("i2c",
                         "does without spidev, speed, clock, data, select, miso and dc: it has two wires of its own");
  if (const auto text = address.take("address")) {
    const auto value = i2c_address(*text);
    if (!value) return address.fault("address", "must be 0x08 to 0x77, as 0x3c, not '" + *text + "'");
    wiring.address = *value;
  }
  return wiring;
}

}  // namespace

Outcome<PanelWiring> PanelWiring::take(DisplayAddress& address) {
  PanelWiring wiring;
  for (const auto& [key, name] : {std::pair("spidev", &wiring.spidev),
                                  {"clock", &wiring.clock},
                                  {"data", &wiring.data},
                                  {"select", &wiring.select},
                                  {"miso", &wiring.miso},
                                  {"i2c", &wiring.i2c},
                                  {"dc", &wiring.data_command},
                                  {"reset", &wiring.reset},
                                  {"backlight", &wiring.backlight}}) {
    auto taken = address.take_name(key);
    if (!taken) return taken.fault();
    *name = std::move(*taken);
  }
  const auto hertz = address.take_number("speed", 1'000, 1'000'000'000);
  if (!hertz) return hertz.fault();
  wiring.hertz = *hertz;
  if (wiring.i2c) return take_i2c(address, std::move(wiring));

  if (!wiring.data_command) return address.fault("dc", "is missing: the line that tells commands from data");
  if (wiring.spidev && (wiring.clock || wiring.data || wiring.select || wiring.miso))
    return address.fault("spidev", "does without clock, data, select and miso: they are those of its controller");
  if (!wiring.spidev && (!wiring.clock || !wiring.data))
    return address.fault("spidev", "is missing, or clock and data for a bus that is driven bit by bit");
  if (!wiring.spidev && wiring.hertz) return address.fault("speed", "is only for spidev: other lines are slower");
  return wiring;
}

Outcome<OpenWiring> OpenWiring::open(const PanelWiring& wiring, std::uint32_t usual_hertz) {
  // All lines are inactive: chip select and reset are active low.
  Outcome<GpioPin> reset = open_pin<GpioPin>("reset", wiring.reset, true);
  if (!reset) return reset.fault();
  Outcome<GpioPin> backlight = open_pin<GpioPin>("backlight", wiring.backlight, false);
  if (!backlight) return backlight.fault();
  if (wiring.i2c) {
    Outcome<hal::I2cdevBus> bus = hal::I2cdevBus::open(*wiring.i2c, wiring.address);
    if (!bus) return bus.fault();
    return OpenWiring{std::move(*bus), std::move(*reset), std::move(*backlight)};
  }
  Outcome<GpioPin> data_command = open_pin<GpioPin>("dc", wiring.data_command, false);
  if (!data_command) return data_command.fault();
  if (wiring.spidev) {
    Outcome<hal::SpidevBus> bus =
        hal::SpidevBus::open(*wiring.spidev, wiring.hertz.value_or(usual_hertz), std::move(*data_command));
    if (!bus) return bus.fault();
    return OpenWiring{std::move(*bus), std::move(*reset), std::move(*backlight)};
  }
  Outcome<GpioPin> clock = open_pin<GpioPin>("clock", wiring.clock, false);
  if (!clock) return clock.fault();
  Outcome<GpioPin> data = open_pin<GpioPin>("data", wiring.data, false);
  if (!data) return data.fault();
  Outcome<GpioPin> select = open_pin<GpioPin>("select", wiring.select, true);
  if (!select) return select.fault();
  Outcome<GpioInput> miso = open_pin<GpioInput>("miso", wiring.miso);
  if (!miso) return miso.fault();
  return OpenWiring{
      BitBangedBus(std::move(*clock), std::move(*data), std::move(*data_command), std::move(*select), std::move(*miso)),
      std::move(*reset), std::move(*backlight)};
}

}  // namespace zstrip::panel
