// The page that shows the cost of accuracy: one HTML file that opens from disk and needs no other file.
#pragma once

#include <string>
#include <vector>

#include "accuracy/campaign.hpp"
#include "result.hpp"

namespace zstrip::sim {

/// Pictures of one point, as PNG files.
struct PointPictures {
  std::size_t point = 0;  ///< index in the campaign
  std::vector<std::uint8_t> drawn, heat;
};
struct PageScene {
  Campaign campaign;
  std::vector<std::uint8_t> truth;  ///< PNG
  std::vector<PointPictures> pictures;
};

/// Draws the pictures of the most important points: those with one changed knob, and those on the front.
Result<PageScene> with_pictures(const AccuracyScene& scene, Campaign campaign, unsigned jobs);

/// Returns the command line that measures this point again.
std::string command_of(const AccuracyPoint& point, const AccuracyRequest& request);

std::string accuracy_page(const std::vector<PageScene>& scenes);

}  // namespace zstrip::sim
