// A validator to replace CLI::IsMember, which gives no reason if a value is not a number.
#include "cli/one_of.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "cli/nearest_name.hpp"
#include "text/text.hpp"

namespace zstrip::sim {

CLI::Validator one_of(std::vector<std::string> values) {
  std::string description = fmt::format("{{{}}}", fmt::join(values, ","));
  const auto reason = [values = std::move(values)](std::string& given) {
    const auto known = std::ranges::find(values, lower(given), [](const std::string& value) { return lower(value); });
    if (known == values.end()) {
      return unknown_value(given, std::vector<std::string_view>(values.begin(), values.end()));
    }
    given = *known;
    return std::string();
  };
  return {reason, std::move(description), ""};
}

CLI::Validator lower_case() {
  return {[](std::string& given) {
            given = lower(std::move(given));
            return std::string();
          },
          "", ""};
}

}  // namespace zstrip::sim
