// Parses the set of characters of a font; see characters.hpp.
#include "font/characters.hpp"

#include <fmt/format.h>

#include <set>
#include <span>

#include "zstrip/effects/overlay/utf8.hpp"

namespace zstrip::sim {

std::vector<std::uint32_t> code_points_of(const std::string& text) {
  std::vector<std::uint32_t> points;
  std::span<const char> rest(text);
  while (!rest.empty()) {
    points.push_back(detail::take_code_point(rest));
    if (points.back() == detail::kNoCodePoint) return {};
  }
  return points;
}

std::string name_of_character(std::uint32_t code_point) { return fmt::format("U+{:04X}", code_point); }

Result<std::vector<std::uint32_t>> parse_characters(const std::string& text) {
  const auto wrong = [](const std::string& what) { return Failure{ExitStatus::usage, "--characters " + what}; };
  const std::vector<std::uint32_t> given = code_points_of(text);
  if (given.empty()) return wrong(text.empty() ? "names none" : "are not UTF-8");
  std::set<std::uint32_t> found;
  for (std::size_t i = 0; i < given.size(); ++i) {
    const std::uint32_t first = given[i];
    const bool is_range = i + 2 < given.size() && given[i + 1] == '-';
    if (is_range) i += 2;
    const std::uint32_t last = given[i];
    if (first > last) {
      return wrong(
          fmt::format("has a range that descends, {} to {}", name_of_character(first), name_of_character(last)));
    }
    for (std::uint32_t point = first; point <= last; ++point) found.insert(point);
  }
  return std::vector<std::uint32_t>(found.begin(), found.end());
}

}  // namespace zstrip::sim
