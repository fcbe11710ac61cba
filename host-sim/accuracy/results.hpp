// The results of campaigns as files: CSV and JSON.
#pragma once

#include <span>
#include <string>

#include "accuracy/campaign.hpp"

namespace zstrip::sim {

/// Returns one line for each scene and settings, sorted by name: the time on each target, side by side, then the
/// figures that all targets share (the flash of the program is the Cortex-M3's, if it was measured). Fields are empty
/// if a figure was not measured or is not defined.
std::string accuracy_csv(std::span<const Campaign> campaigns);
/// Returns the causes of the error: one line for each scene, cause and settings of its knobs, sorted by the scenes'
/// names.
std::string causes_csv(std::span<const Campaign> campaigns);
/// Returns an array with one object for each campaign; accuracy/README.md documents the keys.
std::string accuracy_json(std::span<const Campaign> campaigns);

}  // namespace zstrip::sim
