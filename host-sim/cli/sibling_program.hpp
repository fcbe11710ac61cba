// Programs next to the command, which take its place: rendering, planning and baking need neither the measurements,
// zstrip-measure, nor the window, zstrip-view, and few scenes the rare pipelines of zstrip-any.
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
inline constexpr SiblingCommand kFitCommand{"fit", "Make a model small enough for a board, and bake it"};
inline constexpr SiblingCommand kViewCommand{
    .name = "view",
    .description = "Show a scene in a window as a device would draw it",
    .program = "zstrip-view",
    .how = "install SDL 2 (libsdl2-dev), configure again and build the target zstrip-view"};
inline constexpr std::array kSiblingCommands{kBenchCommand, kAccuracyCommand, kTuneCommand, kFitCommand, kViewCommand};

/// Adds the subcommands to the help of the command.
void add_sibling_commands(CLI::App& app);

/// Every subcommand of the command, with every pipeline.
inline constexpr SiblingCommand kAnyPipeline{
    .name = "", .description = "", .program = "zstrip-any", .how = "build the target zstrip-any"};

/// Replaces this process by the program. Returns only if that fails: an exit status, after it has printed the reason.
/// With ZSTRIP_BUILDS in the environment it prints nothing for a program that is not there, and returns kNotBuilt:
/// host-sim/run then builds it.
int become(const SiblingCommand& command, char** argv);
inline constexpr int kNotBuilt = 75;

/// If the first word is one of the subcommands, becomes its program, and returns only if that fails, like become.
/// Returns nothing for other words.
std::optional<int> run_sibling_program(int argc, char** argv);

}  // namespace zstrip::sim
