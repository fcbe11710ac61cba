// The tables of words.
#include "visibility/method_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "visibility/methods.hpp"

namespace zstrip::sim {
namespace {

std::string names_of(bool (*uses)(Effects)) {
  std::string names;
  for (const VisibilityMethod& method : visibility_methods()) {
    if (uses(method.effects)) names += fmt::format("{}{}", names.empty() ? "" : ", ", method.name);
  }
  return names;
}

}  // namespace

bool uses_iterations(Effects method) { return method.any(method::splitting); }
bool uses_sort_key(Effects method) { return method.any(method::sorted) && !method.any(method::orders); }
std::string methods_with_iterations() { return names_of(uses_iterations); }
std::string methods_with_sort_key() { return names_of(uses_sort_key); }

Result<CullChoice> parse_cull(std::span<const std::string> words) {
  if (words.empty()) return CullChoice{};
  CullChoice choice{.back_faces = false, .small = false};
  const std::pair<std::string_view, bool CullChoice::*> known[] = {{"back-faces", &CullChoice::back_faces},
                                                                   {"small", &CullChoice::small},
                                                                   {"spheres", &CullChoice::spheres},
                                                                   {"temporal", &CullChoice::temporal}};
  for (const std::string& word : words) {
    if (word == "none") {
      if (words.size() == 1) return choice;
      return Failure{ExitStatus::usage, "none goes with nothing else"};
    }
    const auto* const found =
        std::ranges::find(known, std::string_view(word), &std::pair<std::string_view, bool CullChoice::*>::first);
    if (found == std::end(known)) {
      return Failure{ExitStatus::usage, fmt::format("'{}' is not one of: {}, none", word, kCullWords)};
    }
    choice.*found->second = true;
  }
  return choice;
}

std::optional<SortKey> known_sort_key(std::string_view word) {
  if (word == "middle") return SortKey::middle;
  if (word == "nearest") return SortKey::nearest;
  if (word == "farthest") return SortKey::farthest;
  return std::nullopt;
}

}  // namespace zstrip::sim
