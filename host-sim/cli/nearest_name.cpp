// Levenshtein's distance to each known name.
#include "cli/nearest_name.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace zstrip::sim {
namespace {

std::size_t distance(std::string_view from, std::string_view to) {
  std::vector<std::size_t> row(to.size() + 1);  // distances of the prefix of `from` so far to every prefix of `to`
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < from.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i + 1);
    for (std::size_t j = 0; j < to.size(); ++j) {
      const std::size_t replaced = diagonal + (from[i] == to[j] ? 0 : 1);
      diagonal = std::exchange(row[j + 1], std::min({replaced, row[j] + 1, row[j + 1] + 1}));
    }
  }
  return row.back();
}

}  // namespace

std::string_view nearest_name(std::string_view text, std::span<const std::string_view> names) {
  return *std::ranges::min_element(names, {}, [text](std::string_view name) { return distance(text, name); });
}

std::string unknown_name(std::string_view option, std::string_view text, std::span<const std::string_view> names) {
  return fmt::format("{} '{}' is unknown, did you mean {}? Known are {}", option, text, nearest_name(text, names),
                     fmt::join(names, ", "));
}

}  // namespace zstrip::sim
