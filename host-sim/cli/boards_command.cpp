// `zstrip boards`: lists the boards and panels that options name, for people and for programs that offer them.
#include "cli/boards_command.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "bench/board_model.hpp"
#include "image/to_rgb.hpp"
#include "panel/simulated_panel.hpp"
#include "pico/flash_map.hpp"
#include "render/picture_display.hpp"
#include "report/frame_record.hpp"
#include "result.hpp"
#include "text/text.hpp"

namespace zstrip::sim {
namespace {

using Json = nlohmann::ordered_json;

/// Returns the clock of a bus whose bit takes `cycle`; null for a bus that the panel does not have.
Json megahertz(Nanoseconds cycle) {
  if (cycle == Nanoseconds{}) return nullptr;
  return 1e3 / static_cast<double>(cycle.count());
}

std::vector<std::string_view> formats_of(const PanelKind& panel) {
  std::vector<std::string_view> names;
  for (const hal::DisplayFormat format : panel.formats) names.emplace_back(name(core_format(format)));
  return names;
}

std::string boards_json() {
  Json boards = Json::array(), uf2 = Json::array(), panels = Json::array(), formats = Json::array();
  for (const BoardModel& board : board_models()) {
    boards.push_back({{"name", board.name},
                      {"description", board.description},
                      {"core_mhz", board.core_mhz},
                      {"cores", board.cores},
                      {"ram_bytes", board.ram_bytes},
                      {"reserved_ram", kReservedRam},
                      {"spi_mhz", board.spi_mhz},
                      {"dma", board.dma}});
  }
  for (const pico::Board* const board : pico::kBoards) uf2.push_back(board->name);
  for (const PanelKind& panel : panel_kinds()) {
    Json sizes = Json::array();
    for (const PanelModule& module : panel.modules) sizes.push_back({module.width, module.height});
    panels.push_back({{"name", panel.name},
                      {"sizes", sizes},
                      {"formats", formats_of(panel)},
                      {"spi_mhz", megahertz(panel.fastest_spi)},
                      {"i2c_mhz", megahertz(panel.fastest_i2c)},
                      {"qspi_mhz", megahertz(panel.fastest_qspi)},
                      {"rgb_mhz", megahertz(panel.fastest_rgb)},
                      {"rotates", has_orientation(panel, {.rotation = hal::Rotation::by_90})}});
  }
  for (int index = 0; index <= static_cast<int>(kLastPixelFormat); ++index) {
    formats.push_back(name(static_cast<PixelFormat>(index)));
  }
  const Json object = {{"boards", boards}, {"uf2_boards", uf2}, {"panels", panels}, {"formats", formats}};
  return object.dump(2) + '\n';
}

std::string boards_table() {
  std::string text = fmt::format("{:<10} {:>8} {:>5} {:>8}  {}\n", "board", "KB RAM", "MHz", "MHz SPI", "description");
  for (const BoardModel& board : board_models()) {
    text += fmt::format("{:<10} {:>8} {:>5} {:>8}  {}\n", board.name, board.ram_bytes / 1024, board.core_mhz,
                        board.spi_mhz, board.description);
  }
  text += fmt::format("\n{:<10} {:<40}  {}\n", "panel", "sizes", "formats");
  for (const PanelKind& panel : panel_kinds()) {
    std::vector<std::string> sizes;
    for (const PanelModule& module : panel.modules) sizes.push_back(fmt::format("{}x{}", module.width, module.height));
    text += fmt::format("{:<10} {:<40}  {}\n", panel.name, fmt::format("{}", fmt::join(sizes, ", ")),
                        fmt::join(formats_of(panel), ", "));
  }
  return text;
}

}  // namespace

void add_boards_command(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("boards", "List the boards and panels that other commands know");
  const auto json = std::make_shared<bool>(false);
  command->add_flag("--json", *json, "JSON instead of tables");
  command->footer("Examples:\n  zstrip boards\n  zstrip boards --json");
  command->callback([json, &exit_code] {
    write_text(stdout, *json ? boards_json() : boards_table());  // main checks the stream's state
    exit_code = static_cast<int>(ExitStatus::ok);
  });
}

}  // namespace zstrip::sim
