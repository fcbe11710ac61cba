// Options that a scene file or a baked scene can also set.
#include "cli/picture_arguments.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <system_error>
#include <tuple>

#include "cli/board_arguments.hpp"
#include "cli/one_of.hpp"
#include "cli/parse.hpp"
#include "render/blob_stage.hpp"
#include "render/stage.hpp"
#include "text/text.hpp"

namespace zstrip::sim {
namespace {

constexpr std::string_view kWholePicture = "max";

std::string pixels(const std::optional<std::string>& given, const std::optional<std::uint16_t>& setting) {
  if (given) return *given;
  return setting ? std::to_string(*setting) : "auto";
}

PictureSettings settings_of_blob(const std::string& path) {
  const Result<BakedPicture> picture = picture_of_blob(path);
  if (!picture) return {};  // errors are reported when the scene is opened
  const View& view = picture->view;
  PictureSettings settings;
  settings.size.emplace(view.width, view.height);
  settings.format = view.format;
  settings.dither = view.dither;
  settings.samples = view.samples;
  settings.depth_format = depth_format(picture->effects);
  settings.perspective = picture->effects & effect::perspective_runs;
  return settings;
}

}  // namespace

Result<PictureSettings> settings_of(const std::string& scene) {
  std::error_code ignored;  // errors of a path are reported when the scene is opened
  if (!std::filesystem::exists(scene, ignored)) return PictureSettings{};
  if (kind_of_scene(scene) == SceneKind::baked) return settings_of_blob(scene);
  if (kind_of_scene(scene) != SceneKind::composed) return PictureSettings{};
  const Result<SceneFile> file = read_scene_file(scene);
  if (!file) return file.failure();
  PictureSettings settings = file->picture;
  if (std::optional<std::string>& sets = settings.visibility.sets) {
    sets = (std::filesystem::path(scene).parent_path() / *sets).string();
  }
  return settings;
}

void add_quality_options(CLI::App& command, ViewArguments& arguments) {
  command
      .add_option("--format", arguments.format,
                  "Pixels: rgb565 (default), rgb565_swapped, gray4, mono, rgb666, rgb444, xrgb8888")
      ->transform(lower_case())
      ->type_name("FORMAT");
  command.add_flag_function(
      "--dither,!--no-dither", [&arguments](std::int64_t count) { arguments.dither = count > 0; },
      "Dither: hide the steps between colours in a pattern (default: no)");
  command
      .add_option(
          "--samples", arguments.samples,
          "Samples a pixel: 1 (default), 2 (side by side) or 4 (two by two). More samples smooth edges; each takes "
          "the memory and time of a pixel")
      ->type_name("N")
      ->transform(one_of({"1", "2", "4"}));
  command.add_flag_function(
      "--edges,!--no-edges", [&arguments](std::int64_t count) { arguments.edges = count > 0; },
      "Smooth only the edges of models, in less time than samples (default: no)");
}

std::optional<bool> parse_edges(const ViewArguments& arguments, const PictureSettings& settings) {
  return arguments.edges ? arguments.edges : settings.edges;
}
Effects edge_effects(const std::optional<bool>& edges) { return edges.value_or(false) ? effect::edges : Effects{}; }

Result<View> parse_quality(const ViewArguments& arguments, const PictureSettings& settings, const View& view) {
  View result = view;
  result.dither = arguments.dither.value_or(settings.dither.value_or(false));
  const std::uint32_t samples = arguments.samples.value_or(settings.samples.value_or(std::uint8_t{1}));
  result.samples = static_cast<std::uint8_t>(samples);
  if (samples_a_side(result) > kMaxViewSize) {
    const auto largest = [](std::uint32_t of_a_pixel) { return kMaxViewSize / of_a_pixel; };
    return Failure{ExitStatus::usage,
                   fmt::format("{} {}: a picture has at most {} samples in a row or column, so that it may be {}x{} "
                               "with them, not {}x{}",
                               arguments.samples ? "--samples" : "the scene's samples,", samples, kMaxViewSize,
                               largest(sample_columns(result)), largest(sample_rows(result)), view.width, view.height)};
  }
  return result;
}

Result<View> parse_view(const ViewArguments& arguments, const PictureSettings& settings) {
  View view{.width = 320, .height = 240, .format = settings.format.value_or(PixelFormat::rgb565)};
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
  return parse_quality(arguments, settings, view);
}

Result<DepthFormat> parse_depth_format(const std::optional<std::string>& given, const PictureSettings& settings) {
  if (given) return parse_depth_format(*given);
  return settings.depth_format.value_or(DepthFormat::z16);
}

std::string_view depth_option(const std::optional<std::string>& given) {
  return given ? "--depth-format" : "'depth_format' in the scene file";
}

Result<RamLimit> parse_memory(const MemoryArguments& arguments, const PictureSettings& settings, const View& view,
                              Budget& budget) {
  const Result<Done> strips = parse_strips(pixels(arguments.strip_rows, settings.strip_rows),
                                           pixels(arguments.strip_columns, settings.strip_columns), view, budget);
  if (!strips) return strips.failure();
  if (arguments.ram) {
    if (lower(*arguments.ram) == kWholePicture) return RamLimit::whole;
    const Result<std::uint32_t> bytes = parse_bytes(*arguments.ram);
    if (!bytes) return bytes.failure();
    budget.bytes = *bytes;
    return RamLimit::given;
  }
  if (arguments.board) {
    const Result<const BoardModel*> board = parse_board(*arguments.board);
    if (!board) return board.failure();
    budget.bytes = (*board)->ram_bytes - kReservedRam;
    return RamLimit::given;
  }
  if (settings.ram) budget.bytes = *settings.ram;
  if (settings.ram || budget.strip_rows != 0) return RamLimit::given;
  budget.bytes = kUsualRam;
  return RamLimit::usual;
}

std::uint8_t usual_strip_buffers(const MemoryArguments& arguments) {
  const BoardModel* const board = arguments.board ? find_board(*arguments.board) : nullptr;
  return board != nullptr && board->dma ? 2 : 1;
}

}  // namespace zstrip::sim
