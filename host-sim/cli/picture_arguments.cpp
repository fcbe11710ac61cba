// Options that a scene file may set as well.
#include "cli/picture_arguments.hpp"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <tuple>

#include "cli/parse.hpp"
#include "render/stage.hpp"

namespace zstrip::sim {
namespace {

std::string pixels(const std::optional<std::string>& given, const std::optional<std::uint16_t>& setting) {
  if (given) return *given;
  return setting ? std::to_string(*setting) : "auto";
}

}  // namespace

Result<PictureSettings> settings_of(const std::string& scene) {
  if (kind_of_scene(scene) != SceneKind::composed || !std::filesystem::exists(scene)) return PictureSettings{};
  const Result<SceneFile> file = read_scene_file(scene);
  if (!file) return file.failure();
  PictureSettings settings = file->picture;
  if (std::optional<std::string>& sets = settings.visibility.sets) {
    sets = (std::filesystem::path(scene).parent_path() / *sets).string();
  }
  return settings;
}

void add_dither_option(CLI::App& command, ViewArguments& arguments) {
  command.add_flag_function(
      "--dither,!--no-dither", [&arguments](std::int64_t count) { arguments.dither = count > 0; },
      "Hide the steps between colours in a pattern, where they get fewer bits (default: no)");
}

bool dithers(const ViewArguments& arguments, const PictureSettings& settings) {
  return arguments.dither.value_or(settings.dither.value_or(false));
}

Result<View> parse_view(const ViewArguments& arguments, const PictureSettings& settings) {
  View view{.width = 320,
            .height = 240,
            .format = settings.format.value_or(PixelFormat::rgb565),
            .dither = dithers(arguments, settings)};
  if (settings.size) std::tie(view.width, view.height) = *settings.size;
  if (arguments.size) {
    const auto parsed = parse_size(*arguments.size);
    if (!parsed) return parsed.failure();
    std::tie(view.width, view.height) = *parsed;
  }
  if (arguments.format) {
    const Result<PixelFormat> parsed = parse_format(*arguments.format);
    if (!parsed) return parsed.failure();
    view.format = *parsed;
  }
  return view;
}

Result<DepthFormat> parse_depth_format(const std::optional<std::string>& given, const PictureSettings& settings) {
  if (given) return parse_depth_format(*given);
  return settings.depth_format.value_or(DepthFormat::z16);
}

std::string_view depth_option(const std::optional<std::string>& given) {
  return given ? "--depth-format" : "'depth_format' in the scene file";
}

Result<Done> parse_memory(const MemoryArguments& arguments, const PictureSettings& settings, const View& view,
                          Budget& budget) {
  if (arguments.ram) {
    const Result<std::uint32_t> bytes = parse_bytes(*arguments.ram);
    if (!bytes) return bytes.failure();
    budget.bytes = *bytes;
  } else if (settings.ram) {
    budget.bytes = *settings.ram;
  }
  return parse_strips(pixels(arguments.strip_rows, settings.strip_rows),
                      pixels(arguments.strip_columns, settings.strip_columns), view, budget);
}

}  // namespace zstrip::sim
