// The lines of an emulated PL061, from the emulator's trace, as the panel at their other end sees them.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "panel/panel_model.hpp"

namespace zstrip::linux_guest {

/// Which line is what; -1: not wired, which for `select` is always selected.
struct PanelLines {
  int clock, data, data_command, select, reset;
};

/// Bytes and resets reach the panel at the times of the trace (of the clock on the wall, which the guest's follows).
/// Returns the first fault of the wires themselves, as data that changes while the clock is high; empty if there is
/// none. Of the first `skipped` changes only the levels count. Throws std::runtime_error for a trace that is none.
std::string replay(const std::filesystem::path& trace, const PanelLines& lines, sim::PanelModel& panel,
                   std::size_t skipped = 0);

/// How many changes the trace has by now.
std::size_t changes_of(const std::filesystem::path& trace);

/// The last level of a line; -1: it was never set.
int last_level(const std::filesystem::path& trace, int line);

}  // namespace zstrip::linux_guest
