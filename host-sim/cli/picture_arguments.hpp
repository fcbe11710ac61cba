// Options that a scene file may set as well: what is given on the command line wins.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "compose/scene_file.hpp"
#include "result.hpp"
#include "zstrip/budget.hpp"
#include "zstrip/effects.hpp"
#include "zstrip/view.hpp"

namespace CLI {
class App;
}

namespace zstrip::sim {

/// [picture] of a scene file, the picture that a blob was baked for; nothing for other scenes.
Result<PictureSettings> settings_of(const std::string& scene);

/// As given on the command line.
struct ViewArguments {
  std::optional<std::string> size{};
  std::optional<std::string> format{};
  std::optional<bool> dither{};
  std::optional<std::uint32_t> samples{};
  std::optional<bool> edges{};
};
/// --format, --dither, --samples and --edges. `arguments` must live as long as the command.
void add_quality_options(CLI::App& command, ViewArguments& arguments);

/// 320x240 in RGB565, not dithered, with one sample a pixel, by default.
Result<View> parse_view(const ViewArguments& arguments, const PictureSettings& settings);
/// Whether a picture of this size and format, which a panel has given, is dithered, and its samples.
Result<View> parse_quality(const ViewArguments& arguments, const PictureSettings& settings, const View& view);

/// What with_edges is to do.
std::optional<bool> parse_edges(const ViewArguments& arguments, const PictureSettings& settings);
/// Of what with_edges is told, before the scene is known.
Effects edge_effects(const std::optional<bool>& edges);

Result<DepthFormat> parse_depth_format(const std::optional<std::string>& given, const PictureSettings& settings);

/// What has chosen the depth format, for messages: the option if it is given, or the scene file's key.
std::string_view depth_option(const std::optional<std::string>& given);

/// As given on the command line.
struct MemoryArguments {
  std::optional<std::string> ram{};
  std::optional<std::string> strip_rows{};
  std::optional<std::string> strip_columns{};
};
/// Into the budget of a picture of this size; a usage error also where it cannot be cut so.
Result<Done> parse_memory(const MemoryArguments& arguments, const PictureSettings& settings, const View& view,
                          Budget& budget);

}  // namespace zstrip::sim
