// See program_parts.hpp.
#include "bake/program_parts.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "bake/moving_meshes_text.hpp"
#include "image/to_rgb.hpp"
#include "panel/simulated_panel.hpp"
#include "report/frame_record.hpp"
#include "text/text.hpp"
#include "visibility/methods.hpp"
#include "zstrip_hal/st7789.hpp"

namespace zstrip::sim {
namespace {

using Panel = hal::St7789Controller;

/// The memory of the scene's player.
constexpr std::string_view kPlayer =
    R"(constexpr zstrip::FitOptions kOptions{.strip_buffers = @::kBudget.strip_buffers > 1 ? 2 : 1,
                                      .split_columns = @::kBudget.split_columns,
                                      .strip_rows = @::kPlan.strip_rows};
// Memory for arena and strips of the header's plan (--ram makes them smaller), for moving data, and for gaps.
std::byte memory[@::kPlan.bytes() + kOptions.strip_buffers * @::kPlan.strip_pixel_bytes(@::kView) +
                 @::kScene.instances.size_bytes() + @::kScene.lines.size_bytes())";
/// Memory for the tables of the overlay, with room for the player's text.
constexpr std::string_view kOverlayTables =
    R"( +
                 (@::kOverlay.fonts.size() + 1) * sizeof(zstrip::Font) +
                 (@::kOverlay.labels.size() + 1) * sizeof(zstrip::Label))";

/// Returns the module with a glass of this size, or null.
const PanelModule* module_of(std::uint16_t width, std::uint16_t height) {
  const auto is_panel = [](const PanelKind& kind) { return std::string_view(kind.name) == "st7789"; };
  for (const PanelModule& module : std::ranges::find_if(panel_kinds(), is_panel)->modules) {
    if (module.width == width && module.height == height) return &module;
  }
  return nullptr;
}

}  // namespace

std::string with_namespace(std::string text, const std::string& name_space) {
  for (std::size_t at = 0; (at = text.find('@', at)) != std::string::npos;) {
    text.replace(at, 1, name_space);
    at += name_space.size();
  }
  return text;
}

bool bends(const BakedScene& baked) { return baked.skins.move(); }

std::string at_rest_words(const BakedScene& baked) {
  return std::string("{@::kScene, @::kCamera, @::kAnimation, @::kTurn") + (baked.levels.empty() ? "" : ", @::kLevels") +
         "}";
}

std::string pose_call(const BakedScene& baked, std::string_view time) {
  return fmt::format("@::{}({})", pose_function_of(baked.skins), time);
}

std::string pose_words(const BakedScene& baked) {
  return baked.skins.meshes.empty() ? "the morph targets are not posed" : "the skin is not posed";
}

std::string first_line(const BakedScene& baked) {
  return fmt::format("// {} in {}x{} pixels, {}.", printable(baked.source), baked.view.width, baked.view.height,
                     format_words(baked.view));
}

std::string player_text(const BakedScene& baked) {
  std::string text(kPlayer);
  if (baked.scene.overlay != nullptr) text += kOverlayTables;
  return text + " + 96];\nzstrip::Player player(memory, zstrip::drawn_with<@::kEffects>);\n";
}

bool lies_sideways(const View& view) {
  return view.width > Panel::kColumns ||
         (module_of(view.width, view.height) == nullptr && module_of(view.height, view.width) != nullptr);
}

UprightModule upright_module(const View& view) {
  const bool sideways = lies_sideways(view);
  UprightModule upright{sideways ? view.height : view.width, sideways ? view.width : view.height};
  if (const PanelModule* const module = module_of(upright.width, upright.height); module != nullptr) {
    upright.column_offset = module->column_offset;
    upright.row_offset = module->row_offset;
    upright.columns_after = Panel::kColumns - upright.width - upright.column_offset;
    upright.rows_after = Panel::kRows - upright.height - upright.row_offset;
  }
  return upright;
}

std::string panel_config(const View& view) {
  const bool sideways = lies_sideways(view);
  const std::uint16_t width = sideways ? view.height : view.width, height = sideways ? view.width : view.height;
  std::string config = fmt::format(".width = {}, .height = {},", width, height);
  if (const PanelModule* const module = module_of(width, height); module != nullptr) {
    if (module->column_offset != 0) config += fmt::format(" .column_offset = {},", module->column_offset);
    if (module->row_offset != 0) config += fmt::format(" .row_offset = {},", module->row_offset);
  }
  if (sideways) config += "\n    .orientation = {.rotation = zstrip::hal::Rotation::by_90},";
  if (view.format == PixelFormat::rgb666 || view.format == PixelFormat::rgb444) {
    config += fmt::format("\n    .format = zstrip::hal::DisplayFormat::{},", name(view.format));
  }
  return "{" + config + " .inverted = true}";
}

Result<Done> check_panel(const View& view) {
  const bool fits = (view.width <= Panel::kColumns && view.height <= Panel::kRows) ||
                    (view.width <= Panel::kRows && view.height <= Panel::kColumns);
  if (fits) return Done{};
  return Failure{ExitStatus::usage, fmt::format("--size {}x{}: the program is for an ST7789, which has {}x{} pixels at "
                                                "most; choose its size, as 240x240",
                                                view.width, view.height, Panel::kColumns, Panel::kRows)};
}

Result<Done> check_format(const View& view) {
  // RGB565 is sent as bytes, the high one first.
  if (view.format != PixelFormat::rgb565 && Panel::pixel_format(static_cast<hal::DisplayFormat>(view.format)) == 0) {
    return Failure{
        ExitStatus::usage,
        fmt::format("--format {}: the program is for an ST7789, which takes rgb565_swapped, rgb666 or rgb444",
                    name(view.format))};
  }
  if (view.format == PixelFormat::rgb444 && view.width % 2 != 0) {
    return Failure{
        ExitStatus::usage,
        fmt::format("--size {}x{} with --format rgb444: the program sends two pixels in three bytes; choose an "
                    "even width, or rgb565_swapped",
                    view.width, view.height)};
  }
  return Done{};
}

Result<Done> check_rgb565(const View& view, std::string_view advice) {
  if (view.format == PixelFormat::rgb565 || view.format == PixelFormat::rgb565_swapped) return Done{};
  return Failure{ExitStatus::usage, fmt::format("--format {}: {}", name(view.format), advice)};
}

Result<Done> check_names(const BakedScene& baked, const std::string& name_space,
                         std::initializer_list<const char*> names) {
  if (std::ranges::find(names, name_space) != names.end()) {
    return Failure{ExitStatus::usage,
                   fmt::format("--namespace {}: the program has that name itself; choose another one", name_space)};
  }
  if (baked.effects.methods == 0) return Done{};
  return Failure{
      ExitStatus::usage,
      fmt::format("zstrip::Player, which draws in programs and sketches, has no --visibility {}; leave it out",
                  visibility_name(baked.effects))};
}

}  // namespace zstrip::sim
