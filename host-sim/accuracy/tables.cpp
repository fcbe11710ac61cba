// One function for each table.
#include "accuracy/tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace zstrip::sim {
namespace {

using Row = RecordedTable::Row;

/// Returns a number with so many decimals, `-` if it was not measured.
std::string number(const std::string& field, int decimals, double unit = 1) {
  return field.empty() ? "-" : fmt::format("{:.{}f}", std::stod(field) / unit, decimals);
}

/// Returns a depth in the scene's units; values close to 0 become 0.
std::string length(const std::string& field) {
  if (field.empty()) return "-";
  const double value = std::stod(field);
  return value < 1e-9 ? "0" : fmt::format("{:.2g}", value);
}

std::string integer(const std::string& field) { return field.empty() ? "-" : field; }

/// Returns the change relative to `standard`; `=` if there is none.
std::string change(const std::string& field, const std::string& standard) {
  if (field.empty() || standard.empty()) return "-";
  if (field == standard) return "=";
  return fmt::format("{:+.0f} %", 100 * (std::stod(field) / std::stod(standard) - 1));
}

std::vector<std::string> scenes_of(const RecordedTable& table) {
  std::vector<std::string> scenes;
  for (const Row& row : table.rows()) {
    if (scenes.empty() || scenes.back() != row[0]) scenes.push_back(row[0]);
  }
  return scenes;
}

/// The presets. A preset that does not change a scene is the default there, and has no row.
std::string presets(const RecordedTable& table) {
  std::string text =
      "| Scene | Preset | M0 | M3 | M4F | RAM | scene | visible error | FLIP "
      "|\n|---|---|---|---|---|---|---|---|---|\n";
  const auto add = [&](const std::string& scene, const Row* row, const char* preset) {
    if (row == nullptr) return;
    const auto field = [&](const char* name) { return table.field(*row, name); };
    text += fmt::format("| {} | `{}` | {} | {} | {} | {} | {} | {} | {} |\n", scene, preset, integer(field("m0")),
                        integer(field("m3")), integer(field("m4f")), field("ram_bytes"), field("scene_bytes"),
                        number(field("perceived"), 2), number(field("flip"), 3));
  };
  for (const std::string& scene : scenes_of(table)) {
    const Row* tiny = table.find({scene, "shading=flat detail=50 strips=4"});
    add(scene, tiny != nullptr ? tiny : table.find({scene, "strips=4"}), "tiny");
    add(scene, table.find({scene, "default"}), "balanced");
    add(scene, table.find({scene, "perspective=1"}), "exact");
  }
  return text;
}

/// Pictures without anti-aliasing, with edges only, with samples.
std::string anti_aliasing(const RecordedTable& table) {
  std::string text =
      "| Scene | visible error: none, **edges**, 2, 4 samples | FLIP | flicker | M3, million instructions | RAM, KB "
      "| scene in flash, KB |\n|---|---|---|---|---|---|---|\n";
  for (const std::string& scene : scenes_of(table)) {
    const auto all = [&](const char* name, int decimals, double unit = 1) {
      std::string figures;
      for (const std::string settings : {"default", "samples=edges", "samples=2", "samples=4"}) {
        const Row* row = table.find({scene, settings});
        const char* bold = settings == "samples=edges" ? "**" : "";
        figures += fmt::format("{0}{1}{2}{1}", figures.empty() ? "" : ", ", bold,
                               row == nullptr ? "-" : number(table.field(*row, name), decimals, unit));
      }
      return figures;
    };
    text += fmt::format("| {} | {} | {} | {} | {} | {} | {} |\n", scene, all("perceived", 2), all("flip", 3),
                        all("flicker", 1), all("m3", 2, 1e6), all("ram_bytes", 1, 1024), all("scene_bytes", 1, 1024));
  }
  return text;
}

std::string causes_at_the_default(const RecordedTable& table) {
  std::string text =
      "| Scene | Cause | visible error | wrong pixels, % | silhouette | depth, codes | depth, units | texture, texels "
      "| colour: mean, 99.9 % | flicker |\n|---|---|---|---|---|---|---|---|---|---|\n";
  for (const Row& row : table.rows()) {
    const auto field = [&](const char* name) { return table.field(row, name); };
    if (field("settings") != "default") continue;
    text += fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} | {}, {} | {} |\n", row[0], row[1],
                        number(field("perceived"), 2), number(field("wrong_pixels"), 2), field("silhouette"),
                        number(field("depth_codes"), 2), length(field("depth_view")), number(field("texture"), 1),
                        number(field("colour_mean"), 2), number(field("colour_p999"), 1), number(field("flicker"), 2));
  }
  return text;
}

/// The default with its figures; below it each setting, costs as a change of these figures, errors unchanged.
std::string settings_of(const RecordedTable& table, const std::string& scene) {
  constexpr std::array kCosts{"m0", "m3", "ram_bytes", "scene_bytes", "program_bytes"};
  std::string text =
      "| Setting | M0 | M3 | RAM | scene | code | visible error | FLIP | wrong pixels, % | texture, texels "
      "| depth, codes | flicker |\n|---|---|---|---|---|---|---|---|---|---|---|---|\n";
  const Row* standard = table.find({scene, "default"});
  if (standard == nullptr) return text;
  const auto add = [&](const Row& row) {
    std::string settings = table.field(row, "settings");
    for (std::size_t at = 0; (at = settings.find(' ', at)) != std::string::npos; at += 2) settings.replace(at, 1, ", ");
    text += "| " + settings + " |";
    for (const char* cost : kCosts) {
      const std::string of = table.field(*standard, cost);
      text += fmt::format(" {} |", &row == standard ? integer(of) : change(table.field(row, cost), of));
    }
    const auto field = [&](const char* name) { return table.field(row, name); };
    text += fmt::format(" {} | {} | {} | {} | {} | {} |\n", number(field("perceived"), 2), number(field("flip"), 3),
                        number(field("wrong_pixels"), 2), number(field("texture"), 1), number(field("depth_codes"), 1),
                        number(field("flicker"), 2));
  };
  add(*standard);
  for (const Row& row : table.rows()) {
    if (row[0] == scene && &row != standard) add(row);
  }
  return text;
}

}  // namespace

std::string accuracy_tables(const RecordedTable& settings, const RecordedTable& causes) {
  std::string text =
      "# Accuracy: what was measured\n\n"
      "Tables and plots of [accuracy.csv](accuracy.csv) and [accuracy-causes.csv](accuracy-causes.csv), written by\n"
      "`tests/measure accuracy`. [Accuracy](../accuracy.md) says what is measured, and what the figures mean.\n\n"
      "## Presets\n" +
      presets(settings) + "\n## Anti-aliasing\n" + anti_aliasing(settings) + "\n## Causes\n" +
      causes_at_the_default(causes) +
      "\n## Settings\n"
      "The default has instructions, bytes and errors. Each setting has its change of instructions and bytes, and\n"
      "its errors. `=` means no change, `-` not measured or without meaning; *code* is the whole program's flash\n"
      "on a Cortex-M3.\n";
  for (const std::string& scene : scenes_of(settings)) {
    text += fmt::format("\n### {0}\n![{0}: instructions on a Cortex-M3 against visible error](accuracy-{0}.svg)\n\n",
                        scene) +
            settings_of(settings, scene);
  }
  return text;
}

}  // namespace zstrip::sim
