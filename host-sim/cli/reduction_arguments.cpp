// The options that make a model smaller, shared by the commands that read one.
#include "cli/reduction_arguments.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <bit>
#include <charconv>
#include <string_view>

#include "cli/parse.hpp"
#include "image/resample.hpp"
#include "render/stage.hpp"

namespace zstrip::sim {
namespace {

/// Reads the whole text as a number.
template <typename T>
bool read_number(std::string_view text, T& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && end == text.data() + text.size();
}

}  // namespace

void add_reduction_options(CLI::App& command, ReductionArguments& arguments) {
  command
      .add_option(
          "--texture-size", arguments.texture_size,
          "Limit for the longer side of a model's textures, a power of two from 1 to 2048; larger textures are shrunk. "
          "0: vertices get the colours of opaque textures, which are left out")
      ->type_name("N");
  command
      .add_option("--triangles", arguments.triangles,
                  "Limit for a model's triangles, a number or a share such as 25%; those that change its shape least "
                  "are removed")
      ->type_name("N|N%");
  command.add_flag("--lod", arguments.lod,
                   "Levels of detail: far instances are drawn with fewer triangles, at most half a pixel off");
}

Result<Reduction> parse_reduction(const ReductionArguments& arguments, const std::string& scene) {
  Reduction reduction;
  if (const std::optional<std::string>& text = arguments.texture_size) {
    std::uint32_t& side = reduction.texture_side;
    const bool is_number = read_number(*text, side);
    reduction.fold_textures = is_number && side == 0;
    if (!is_number || (!reduction.fold_textures && !std::has_single_bit(side)) || side > kMaxTextureSide) {
      return usage(fmt::format("--texture-size '{}' must be 0 or a power of two from 1 to {}", *text, kMaxTextureSide));
    }
  }
  if (const std::optional<std::string>& text = arguments.triangles) {
    const bool is_share = text->ends_with('%');
    double percent = 100;
    const bool valid = is_share ? read_number(std::string_view(*text).substr(0, text->size() - 1), percent) &&
                                      percent > 0 && percent <= 100
                                : read_number(*text, reduction.triangles) && reduction.triangles > 0;
    if (!valid) {
      return usage(fmt::format("--triangles '{}' must be a number above 0, or a share such as 25%", *text));
    }
    reduction.triangle_share = percent / 100;
  }
  const bool given = arguments.texture_size || arguments.triangles;
  if (given && kind_of_scene(scene) != SceneKind::model) {
    return usage(fmt::format("{} is for model files; '{}' is not one",
                             arguments.texture_size ? "--texture-size" : "--triangles", scene));
  }
  return reduction;
}

}  // namespace zstrip::sim
