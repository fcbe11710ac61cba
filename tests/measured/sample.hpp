// Which rows of a table a test measures that would take too long for all of them.
#pragma once

#include <string>
#include <vector>

namespace zstrip::measured {

/// `count` of them, other ones each day: after so many days each had its turn.
std::vector<std::string> sample(const std::vector<std::string>& names, std::size_t count, std::size_t day);

/// Those of today, by the day of the year; all with the environment's ZSTRIP_LONG=1.
std::vector<std::string> sample_of_today(const std::vector<std::string>& names, std::size_t count);

}  // namespace zstrip::measured
