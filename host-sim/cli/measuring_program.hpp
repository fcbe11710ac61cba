// The subcommands that measure are a program of their own, zstrip-measure, beside the command: rendering, planning and
// baking do not need it.
#pragma once

#include <array>
#include <optional>

namespace CLI {
class App;
}

namespace zstrip::sim {

struct MeasuringCommand {
  const char* name;
  const char* description;  ///< for help
};
inline constexpr MeasuringCommand kBenchCommand{"bench",
                                                "Measure instructions, time and memory of the benchmark workloads"};
inline constexpr MeasuringCommand kAccuracyCommand{
    "accuracy", "Measure what accuracy costs: errors, time and memory of all settings"};
inline constexpr MeasuringCommand kTuneCommand{"tune",
                                               "Find the cheapest settings within limits of error, memory and time"};
inline constexpr std::array kMeasuringCommands{kBenchCommand, kAccuracyCommand, kTuneCommand};

/// Adds them to the help of the command.
void add_measuring_commands(CLI::App& app);

/// If the first word is one of them, zstrip-measure takes the place of this process; only if that fails, this returns:
/// an exit status, after saying why. Nothing if the first word is none of them.
std::optional<int> run_measuring_program(int argc, char** argv);

}  // namespace zstrip::sim
