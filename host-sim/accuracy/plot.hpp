// Cost against error as SVG.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "accuracy/campaign.hpp"

namespace zstrip::sim {

/// The colour group of a point: "default", the name of the knob that it turns, "several".
std::string group_of(const AccuracyPoint& point);
/// #rrggbb, also distinguishable with impaired colour vision.
std::string_view colour_of_group(std::string_view group);

/// The settings for a campaign's scene: of the front the fastest point that looks no worse than the default by more
/// than a twentieth and takes no more RAM.
const AccuracyPoint* recommended(const Campaign& campaign);

/// "time on m3, instructions a frame" or that of the host.
std::string time_label(const Campaign& campaign);

/// One picture, for a page, whose script finds the points by data-point, their places in the campaign.
std::string plot_svg(const Campaign& campaign);

/// The same for a file of its own: with a title, what the colours mean, and the names of the points that turn one knob.
std::string plot_file_svg(const Campaign& campaign);

}  // namespace zstrip::sim
