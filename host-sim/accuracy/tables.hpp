// The figures of docs/measured/accuracy.csv and accuracy-causes.csv as tables in Markdown.
#pragma once

#include <string>

#include "accuracy/recorded.hpp"

namespace zstrip::sim {

/// A page: presets, anti-aliasing, causes, then every setting of each scene with a link to its plot.
std::string accuracy_tables(const RecordedTable& settings, const RecordedTable& causes);

}  // namespace zstrip::sim
