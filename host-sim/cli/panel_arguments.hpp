// The options for the picture on a simulated panel.
#pragma once

#include <optional>
#include <string>

#include "panel/simulated_panel.hpp"
#include "result.hpp"

namespace CLI {
class App;
}

namespace zstrip::sim {

/// The options as given on the command line.
struct PanelArguments {
  std::optional<std::string> panel;
  bool changes = false;
  std::optional<std::string> bus;
  std::optional<std::string> rotation;
  bool mirror = false;
};

/// Adds the options; `arguments` must live as long as the command.
void add_panel_options(CLI::App& command, PanelArguments& arguments);

/// Returns nothing without --panel. `size` and `format` are the values of --size and --format, if given.
Result<std::optional<PanelRequest>> parse_panel(const PanelArguments& arguments, const std::optional<std::string>& size,
                                                const std::optional<std::string>& format);

/// Returns the clock in "spi@40MHz".
Result<double> parse_bus_hertz(const std::string& text);

/// Returns "SPI at 40 MHz".
std::string bus_words(const PanelRequest& request);

}  // namespace zstrip::sim
