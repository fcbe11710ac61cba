// How a panel is wired to a Linux machine.
#include "panel_wiring.hpp"

#include <utility>

namespace zstrip::panel {
namespace {

using hal::GpioPin;
using hal::Outcome;

/// A pin without a line if `name` is none.
Outcome<GpioPin> open_pin(const char* key, const std::optional<std::string>& name, bool level) {
  if (!name) return GpioPin();
  const auto in_words = [key](const hal::Fault& fault) { return hal::Fault{std::string(key) + ": " + fault.message}; };
  const Outcome<hal::GpioLine> line = hal::find_gpio_line(*name);
  if (!line) return in_words(line.fault());
  Outcome<GpioPin> pin = GpioPin::request(*line, level);
  if (!pin) return in_words(pin.fault());
  return pin;
}

}  // namespace

Outcome<PanelWiring> PanelWiring::take(DisplayAddress& address) {
  PanelWiring wiring;
  wiring.spidev = address.take("spidev");
  wiring.clock = address.take("clock");
  wiring.data = address.take("data");
  wiring.select = address.take("select");
  wiring.data_command = address.take("dc");
  wiring.reset = address.take("reset");
  wiring.backlight = address.take("backlight");
  const auto hertz = address.take_number("speed", 1'000, 1'000'000'000);
  if (!hertz) return hertz.fault();
  wiring.hertz = *hertz;

  if (!wiring.data_command) return address.fault("dc", "is missing: the line that tells commands from data");
  if (wiring.spidev && (wiring.clock || wiring.data || wiring.select))
    return address.fault("spidev", "does without clock, data and select: they are those of its controller");
  if (!wiring.spidev && (!wiring.clock || !wiring.data))
    return address.fault("spidev", "is missing, or clock and data for a bus that is driven bit by bit");
  if (!wiring.spidev && wiring.hertz) return address.fault("speed", "is only for spidev: other lines are slower");
  return wiring;
}

Outcome<OpenWiring> OpenWiring::open(const PanelWiring& wiring, std::uint32_t usual_hertz) {
  // All lines rest: chip select and reset are active while low.
  Outcome<GpioPin> data_command = open_pin("dc", wiring.data_command, false);
  if (!data_command) return data_command.fault();
  Outcome<GpioPin> reset = open_pin("reset", wiring.reset, true);
  if (!reset) return reset.fault();
  Outcome<GpioPin> backlight = open_pin("backlight", wiring.backlight, false);
  if (!backlight) return backlight.fault();
  if (wiring.spidev) {
    Outcome<hal::SpidevBus> bus =
        hal::SpidevBus::open(*wiring.spidev, wiring.hertz.value_or(usual_hertz), std::move(*data_command));
    if (!bus) return bus.fault();
    return OpenWiring{std::move(*bus), std::move(*reset), std::move(*backlight)};
  }
  Outcome<GpioPin> clock = open_pin("clock", wiring.clock, false);
  if (!clock) return clock.fault();
  Outcome<GpioPin> data = open_pin("data", wiring.data, false);
  if (!data) return data.fault();
  Outcome<GpioPin> select = open_pin("select", wiring.select, true);
  if (!select) return select.fault();
  return OpenWiring{BitBangedBus(std::move(*clock), std::move(*data), std::move(*data_command), std::move(*select)),
                    std::move(*reset), std::move(*backlight)};
}

}  // namespace zstrip::panel
