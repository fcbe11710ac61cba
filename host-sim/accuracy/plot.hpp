// Plots cost against error as SVG.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "accuracy/campaign.hpp"

namespace zstrip::sim {

/// Returns the colour group of a point: "default", the name of its changed knob, or "several".
std::string group_of(const AccuracyPoint& point);
/// Returns #rrggbb; the colours can be distinguished with impaired colour vision.
std::string_view colour_of_group(std::string_view group);

/// Returns the recommended settings for a campaign's scene: the fastest point on the front whose perceived error
/// exceeds the default's by at most a twentieth and which takes no more RAM.
const AccuracyPoint* recommended(const Campaign& campaign);

/// Returns "time on m3, instructions a frame", or the label for the host.
std::string time_label(const Campaign& campaign);

/// Returns one plot for a page. Its script finds the points by data-point, their index in the campaign.
std::string plot_svg(const Campaign& campaign);

/// Returns the plot for a separate file: with a title, a legend of colours, and the names of points with one changed
/// knob.
std::string plot_file_svg(const Campaign& campaign);

}  // namespace zstrip::sim
