// Subcommands that are separate programs next to the command: rendering, planning and baking need neither the
// measurements, zstrip-measure, nor the window, zstrip-view.
#pragma once

#include <array>
#include <optional>

namespace CLI {
class App;
}

namespace zstrip::sim {

struct SiblingCommand {
  const char* name;
  const char* description;  ///< for help
  const char* program = "zstrip-measure";
  const char* how = "build the target zstrip-measure";  ///< how the user gets it
};
inline constexpr SiblingCommand kBenchCommand{"bench",
                                              "Measure instructions, time and memory of the benchmark workloads"};
inline constexpr SiblingCommand kAccuracyCommand{
    "accuracy", "Measure what accuracy costs: errors, time and memory of all settings"};
inline constexpr SiblingCommand kTuneCommand{"tune",
                                             "Find the cheapest settings within limits of error, memory and time"};
inline constexpr SiblingCommand kViewCommand{
    .name = "view",
    .description = "Show a scene in a window as a device would draw it",
    .program = "zstrip-view",
    .how = "install SDL 2 (libsdl2-dev), configure again and build the target zstrip-view"};
inline constexpr std::array kSiblingCommands{kBenchCommand, kAccuracyCommand, kTuneCommand, kViewCommand};

/// Adds the subcommands to the help of the command.
void add_sibling_commands(CLI::App& app);

/// If the first word is one of them, replaces this process by its program. Returns only if that fails: an exit status,
/// after it has printed the reason. Returns nothing for other words.
std::optional<int> run_sibling_program(int argc, char** argv);

}  // namespace zstrip::sim
