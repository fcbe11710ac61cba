// A started panel with its bus and driver, and the picture that it should show.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "controllers.hpp"
#include "picture.hpp"

namespace zstrip::panels {

using hal::Area;
using hal::Error;

/// 400 ns a bit: slow enough for each controller.
inline constexpr sim::BusTiming kSlow{.byte = sim::Nanoseconds(3200), .cycle = sim::Nanoseconds(400)};

/// The line of a panel's reset.
struct ResetLine {
  sim::PanelModel* panel;
  Error set(bool high) {
    panel->set_reset(high);
    return Error::none;
  }
};

template <class C>
struct Bench {
  typename C::Config config;
  decltype(C::model(config)) panel;
  sim::ModelBus bus;
  typename C::Driver display;
  Picture expected;

  explicit Bench(const typename C::Config& wanted)
      : config(wanted),
        panel(C::model(wanted)),
        bus(*panel, kSlow),
        display(C::driver(bus, config)),
        expected(black(display.width(), display.height())) {
    bus.wait(120'000);  // since power-on
  }

  Area whole() const { return {0, 0, display.width(), display.height()}; }

  Error write(const Area& area, const Picture& picture) {
    std::vector<std::byte> bytes = bytes_of(picture, area, display.format());
    bytes.push_back(std::byte{0xFF});  // more than the area needs: not to be sent
    if (const Error error = display.write(area, bytes); error != Error::none) return error;
    const Error error = display.wait();
    if (error == Error::none) copy(picture, area, expected);
    return error;
  }

  /// What is wrong with what is seen; empty if nothing is.
  std::string fault() const {
    if (!panel->complaints().empty()) return panel->complaints().front();
    if (!panel->darkness().empty()) return panel->darkness();
    return difference(picture_of(panel->seen()), on_glass(expected, config.orientation));
  }
};

}  // namespace zstrip::panels
