// A validator in place of CLI::IsMember, which gives no reason for a value that is no number among numbers.
#include "cli/one_of.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>

#include "cli/nearest_name.hpp"

namespace zstrip::sim {

CLI::Validator one_of(std::vector<std::string> values) {
  std::string description = fmt::format("{{{}}}", fmt::join(values, ","));
  const auto reason = [values = std::move(values)](const std::string& given) {
    if (std::ranges::find(values, given) != values.end()) return std::string();
    return unknown_value(given, std::vector<std::string_view>(values.begin(), values.end()));
  };
  return {reason, std::move(description), ""};
}

}  // namespace zstrip::sim
