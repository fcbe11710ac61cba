// Takes names in turn.
#include "measured/sample.hpp"

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <string_view>

namespace zstrip::measured {

std::vector<std::string> sample(const std::vector<std::string>& names, std::size_t count, std::size_t day) {
  std::vector<std::string> result;
  for (std::size_t i = 0; i < std::min(count, names.size()); ++i) {
    result.push_back(names[(day * count + i) % names.size()]);
  }
  return result;
}

std::vector<std::string> sample_of_today(const std::vector<std::string>& names, std::size_t count) {
  const char* const all = std::getenv("ZSTRIP_LONG");
  if (all != nullptr && std::string_view(all) == "1") return names;
  const std::time_t now = std::time(nullptr);
  std::tm today{};
  localtime_r(&now, &today);
  return sample(names, count, static_cast<std::size_t>(today.tm_yday));
}

}  // namespace zstrip::measured
