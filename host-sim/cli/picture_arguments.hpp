// Options that a scene file can also set: a value of the command line wins.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "compose/scene_file.hpp"
#include "plan/ram_limit.hpp"
#include "result.hpp"
#include "zstrip/budget.hpp"
#include "zstrip/effects.hpp"
#include "zstrip/view.hpp"

namespace CLI {
class App;
}

namespace zstrip::sim {

/// Returns [picture] of a scene file, or the picture that a blob was baked for; nothing for other scenes.
Result<PictureSettings> settings_of(const std::string& scene);

/// The options as given on the command line.
struct ViewArguments {
  std::optional<std::string> size{};
  std::optional<std::string> format{};
  std::optional<bool> dither{};
  std::optional<std::uint32_t> samples{};
  std::optional<bool> edges{};
};
/// Adds --format, --dither, --samples and --edges. `arguments` must live as long as the command.
void add_quality_options(CLI::App& command, ViewArguments& arguments);

/// The default is 320x240 in RGB565, not dithered, with one sample a pixel.
Result<View> parse_view(const ViewArguments& arguments, const PictureSettings& settings);
/// Adds dithering and samples to a view whose size and format are those of a panel.
Result<View> parse_quality(const ViewArguments& arguments, const PictureSettings& settings, const View& view);

/// Returns the argument of with_edges.
std::optional<bool> parse_edges(const ViewArguments& arguments, const PictureSettings& settings);
/// Returns the effects for the argument of with_edges, before the scene is known.
Effects edge_effects(const std::optional<bool>& edges);

Result<DepthFormat> parse_depth_format(const std::optional<std::string>& given, const PictureSettings& settings);

/// Returns the source of the depth format, for messages: the option if it is given, or the scene file's key.
std::string_view depth_option(const std::optional<std::string>& given);

/// The help of --ram.
inline constexpr const char* kRamHelp =
    "Limit for arena and strip buffers in bytes, K and M allowed; max: the whole picture in one strip (default: 24K, "
    "or "
    "more if the scene needs it)";

/// The options as given on the command line.
struct MemoryArguments {
  std::optional<std::string> ram{};
  std::optional<std::string> board{};
  std::optional<std::string> strip_rows{};
  std::optional<std::string> strip_columns{};
};
/// Parses into the budget of a picture of this size; also a usage error if the picture cannot be divided like that.
/// Without --ram: the board's, less kReservedRam; without a board and without rows kUsualRam.
Result<RamLimit> parse_memory(const MemoryArguments& arguments, const PictureSettings& settings, const View& view,
                              Budget& budget);
/// Returns 2 if --board has DMA, else 1.
std::uint8_t usual_strip_buffers(const MemoryArguments& arguments);

}  // namespace zstrip::sim
