// Figures that were written down before (docs/accuracy.csv), to be drawn again.
#pragma once

#include <string>
#include <vector>

#include "accuracy/campaign.hpp"
#include "result.hpp"

namespace zstrip::sim {

/// What stands between the commas of a line; no field after the last of them. Quotes mean nothing.
std::vector<std::string> csv_fields(const std::string& line);

/// The scenes of a table as `host-sim/accuracy/document` writes it, with the instructions of the Cortex-M3; in its
/// order, lines without these left out. Failures: ExitStatus::input for a file that cannot be read or has another form.
Result<std::vector<Campaign>> read_recorded(const std::string& file);

}  // namespace zstrip::sim
