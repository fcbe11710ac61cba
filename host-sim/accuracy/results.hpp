// The results of campaigns as files: CSV and JSON.
#pragma once

#include <span>
#include <string>

#include "accuracy/campaign.hpp"

namespace zstrip::sim {

/// One line a point; empty fields where a figure has no meaning.
std::string accuracy_csv(std::span<const Campaign> campaigns);
/// Where the error comes from: one line a scene, cause and settings of its knobs.
std::string causes_csv(std::span<const Campaign> campaigns);
/// An array with one object a campaign; the keys are documented in accuracy/README.md.
std::string accuracy_json(std::span<const Campaign> campaigns);

}  // namespace zstrip::sim
