// The least edit distance to a known name, or the least difference from a number.
#include "cli/nearest_name.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <optional>

#include "compose/retired.hpp"
#include "text/edit_distance.hpp"
#include "text/text.hpp"

namespace zstrip::sim {
namespace {

std::optional<std::int64_t> whole_number(std::string_view text) {
  std::int32_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

bool are_numbers(std::span<const std::string_view> names) {
  return std::ranges::all_of(names, [](std::string_view name) { return whole_number(name).has_value(); });
}

}  // namespace

std::string_view nearest_name(std::string_view text, std::span<const std::string_view> names) {
  if (const auto number = whole_number(text); number && are_numbers(names)) {
    return *std::ranges::min_element(names, {},
                                     [&](std::string_view name) { return std::abs(*number - *whole_number(name)); });
  }
  const std::string given = lower(std::string(text));
  return *std::ranges::min_element(
      names, {}, [&given](std::string_view name) { return edit_distance(given, lower(std::string(name))); });
}

std::string unknown_value(std::string_view text, std::span<const std::string_view> names) {
  const std::string_view instead = instead_of(text);
  const std::string reason = !instead.empty() ? fmt::format("is gone: {}.", instead)
                             : are_numbers(names) && !whole_number(text)
                                 ? "is not a number."
                                 : fmt::format("is unknown, did you mean {}?", nearest_name(text, names));
  return fmt::format("'{}' {} Known are {}", text, reason, fmt::join(names, ", "));
}

std::string unknown_name(std::string_view option, std::string_view text, std::span<const std::string_view> names) {
  return fmt::format("{} {}", option, unknown_value(text, names));
}

}  // namespace zstrip::sim
