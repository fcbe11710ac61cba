// The results of campaigns as files: CSV and JSON.
#pragma once

#include <span>
#include <string>

#include "accuracy/campaign.hpp"

namespace zstrip::sim {

/// One line a scene and settings, in the order of their names: the time on each target, side by side, then what all
/// targets share (the flash of the program is the Cortex-M3's, if that is among them). Empty fields where a figure was
/// not measured or has no meaning.
std::string accuracy_csv(std::span<const Campaign> campaigns);
/// Where the error comes from: one line a scene, cause and settings of its knobs, scenes in the order
/// of their names.
std::string causes_csv(std::span<const Campaign> campaigns);
/// An array with one object a campaign; the keys are documented in accuracy/README.md.
std::string accuracy_json(std::span<const Campaign> campaigns);

}  // namespace zstrip::sim
