// The options of a simulated panel, and the checks of their combinations.
#include "cli/panel_arguments.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <vector>

#include "cli/nearest_name.hpp"
#include "cli/one_of.hpp"
#include "cli/parse.hpp"
#include "image/to_rgb.hpp"
#include "render/picture_display.hpp"
#include "report/frame_record.hpp"
#include "text/text.hpp"
#include "zstrip_hal/scanned_panel.hpp"

namespace zstrip::sim {
namespace {

Result<const PanelKind*> parse_kind(const std::string& text) {
  std::vector<std::string_view> names;
  for (const PanelKind& kind : panel_kinds()) {
    if (text == kind.name) return &kind;
    names.emplace_back(kind.name);
  }
  return usage(unknown_name("--panel", text, names));
}

struct Bus {
  BusKind kind = BusKind::spi;
  Nanoseconds cycle{};
};

constexpr std::string_view kBusNames[] = {"spi", "i2c", "qspi", "rgb"};
constexpr std::string_view kBusWords[] = {"SPI", "I2C", "QSPI", "RGB"};

std::string_view bus_word(BusKind kind) { return kBusWords[static_cast<std::size_t>(kind)]; }

/// Parses "spi@40MHz", "i2c@400kHz", "qspi@40MHz" or "rgb@9MHz"; without a speed, uses the fastest that the data sheet
/// allows.
Result<Bus> parse_bus(const std::string& text, const PanelKind& kind) {
  const std::size_t at = text.find('@');
  const std::string name = text.substr(0, at);
  const auto found = std::ranges::find(kBusNames, name);
  if (found == std::end(kBusNames)) return usage(unknown_name("--bus", name, kBusNames) + "; for example spi@40MHz");
  Bus bus{.kind = static_cast<BusKind>(found - std::begin(kBusNames))};
  bus.cycle = kind.fastest(bus.kind);
  if (bus.cycle == 0ns) {
    return usage(fmt::format("--bus {}: the {} has no {}, only {}", name, kind.name, bus_word(bus.kind),
                             bus_word(kind.usual_bus())));
  }
  if (at == std::string::npos) return bus;

  const Result<double> hertz = parse_bus_hertz(text);
  if (!hertz) return hertz.failure();
  bus.cycle = Nanoseconds(std::llround(1e9 / *hertz));
  if (const Nanoseconds longest = longest_cycle(bus.kind); longest != 0ns && bus.cycle > longest) {
    return usage(fmt::format("--bus {}: the {} has to read a strip within {} ms, which takes at least {:.0f}kHz", text,
                             kind.name, hal::kMaxScanMicroseconds / 1000,
                             std::ceil(1e6 / static_cast<double>(longest.count()))));
  }
  return bus;
}

Result<hal::Rotation> parse_rotation(const std::string& text) {
  if (text == "0") return hal::Rotation::none;
  if (text == "90") return hal::Rotation::by_90;
  if (text == "180") return hal::Rotation::by_180;
  if (text == "270") return hal::Rotation::by_270;
  return usage(fmt::format("--rotation '{}' must be 0, 90, 180 or 270 degrees, clockwise", text));
}

/// `size` is the picture's size; width and height are exchanged if the panel is on its side.
Result<PanelModule> parse_module(const std::string& size, const PanelKind& kind, bool sideways) {
  const auto wanted = parse_size(size);
  if (!wanted) return wanted.failure();
  std::vector<std::string> sizes;
  for (const PanelModule& module : kind.modules) {
    const std::uint16_t width = sideways ? module.height : module.width;
    const std::uint16_t height = sideways ? module.width : module.height;
    if (wanted->first == width && wanted->second == height) return module;
    sizes.push_back(fmt::format("{}x{}", width, height));
  }
  return usage(fmt::format("--size {}: {} on the {} are {}{}", size, sideways ? "rotated pictures" : "pictures",
                           kind.name, fmt::join(sizes, ", "),
                           !sideways && has_orientation(kind, {hal::Rotation::by_90, false})
                               ? "; --rotation 90 or 270 exchanges width and height"
                               : ""));
}

Result<hal::DisplayFormat> parse_panel_format(const std::string& text, const PanelKind& kind) {
  const Result<PixelFormat> format = parse_format(text);
  if (!format) return format.failure();
  std::vector<std::string_view> names;
  for (const hal::DisplayFormat each : kind.formats) {
    if (each == hal_format(*format)) return each;
    names.emplace_back(name(core_format(each)));
  }
  return usage(fmt::format("--format {}: the {} takes {}", text, kind.name, fmt::join(names, " or ")));
}

}  // namespace

void add_panel_options(CLI::App& command, PanelArguments& arguments) {
  PanelArguments& a = arguments;
  std::vector<std::string_view> names;
  for (const PanelKind& kind : panel_kinds()) names.emplace_back(kind.name);
  command
      .add_option("--panel", a.panel,
                  fmt::format("Shows the picture as this panel with zstrip's driver would: {}", fmt::join(names, ", ")))
      ->transform(lower_case())
      ->type_name("NAME");
  command
      .add_option(
          "--bus", a.bus,
          "The panel's bus and its clock: spi@40MHz, i2c@400kHz, qspi@50MHz, rgb@9MHz (default: the fastest it allows)")
      ->transform(lower_case())
      ->type_name("BUS");
  command.add_option("--rotation", a.rotation, "Rotates the picture on the panel, clockwise: 0, 90, 180 or 270")
      ->type_name("DEGREES");
  command.add_flag("--mirror", a.mirror, "Mirrors the picture on the panel, left and right");
  command.add_flag("--changes", a.changes, "Sends the panel only what changed since the frame before");
}

Result<std::optional<PanelRequest>> parse_panel(const PanelArguments& arguments, const std::optional<std::string>& size,
                                                const std::optional<std::string>& format) {
  if (!arguments.panel) {
    const char* const alone = arguments.bus        ? "--bus"
                              : arguments.rotation ? "--rotation"
                              : arguments.mirror   ? "--mirror"
                              : arguments.changes  ? "--changes"
                                                   : nullptr;
    if (alone != nullptr) return usage(fmt::format("{} needs --panel with the name of a panel", alone));
    return std::optional<PanelRequest>{};
  }
  const Result<const PanelKind*> kind = parse_kind(*arguments.panel);
  if (!kind) return kind.failure();
  const Result<Bus> bus =
      parse_bus(arguments.bus.value_or(std::string(kBusNames[static_cast<std::size_t>((*kind)->usual_bus())])), **kind);
  if (!bus) return bus.failure();
  const Result<hal::Rotation> rotation = parse_rotation(arguments.rotation.value_or("0"));
  if (!rotation) return rotation.failure();
  PanelRequest request{.kind = *kind,
                       .module = (*kind)->modules.front(),
                       .orientation = {*rotation, arguments.mirror},
                       .format = (*kind)->formats.front(),
                       .bus = bus->kind,
                       .cycle = bus->cycle,
                       .changes = arguments.changes};
  if (!has_orientation(**kind, request.orientation)) {
    const std::string given = arguments.rotation ? "--rotation " + *arguments.rotation : "--mirror";
    return usage(fmt::format("{}: a {} cannot show a picture so", given, (*kind)->name));
  }
  if (request.changes && request.bus == BusKind::rgb) {
    return usage(fmt::format("--changes: a {} has no memory, and needs every strip in each refresh", (*kind)->name));
  }
  if (size) {
    const Result<PanelModule> module = parse_module(*size, **kind, is_sideways(request.orientation));
    if (!module) return module.failure();
    request.module = *module;
  }
  if (format) {
    const Result<hal::DisplayFormat> parsed = parse_panel_format(*format, **kind);
    if (!parsed) return parsed.failure();
    request.format = *parsed;
  }
  const bool sideways = is_sideways(request.orientation);
  const std::uint16_t width = sideways ? request.module.height : request.module.width;
  if (request.format == hal::DisplayFormat::rgb444 && width % 2 != 0) {
    return usage(fmt::format("--format rgb444 needs an even width (or rotation {})", sideways ? "0, 180" : "90, 270"));
  }
  return std::optional<PanelRequest>{request};
}

Result<double> parse_bus_hertz(const std::string& text) {
  const std::size_t at = text.find('@');
  const std::string_view speed = at == std::string::npos ? std::string_view{} : std::string_view(text).substr(at + 1);
  double value = 0;
  const auto [end, error] = std::from_chars(speed.data(), speed.data() + speed.size(), value);
  const std::string unit = lower(std::string(speed.substr(static_cast<std::size_t>(end - speed.data()))));
  const double factor = unit == "mhz" ? 1e6 : unit == "khz" ? 1e3 : unit == "hz" ? 1 : 0;
  const double hertz = error == std::errc{} ? value * factor : 0;
  if (hertz >= 1e3 && hertz <= 1e9) return hertz;
  return usage(fmt::format("--bus '{}' must have a speed of 1kHz to 1000MHz, for example spi@40MHz", text));
}

std::string bus_words(const PanelRequest& request) {
  const double megahertz = 1e3 / static_cast<double>(request.cycle.count());
  const std::string_view name = bus_word(request.bus);
  return megahertz < 1 ? fmt::format("{} at {:.4g} kHz", name, megahertz * 1e3)
                       : fmt::format("{} at {:.4g} MHz", name, megahertz);
}

}  // namespace zstrip::sim
