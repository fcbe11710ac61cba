// The words for options of a visibility method, the same on the command line and in scene files.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "result.hpp"
#include "zstrip/effects.hpp"
#include "zstrip/visibility.hpp"

namespace zstrip::sim {

/// True if the method uses VisibilityOptions::iterations and ::key.
bool uses_iterations(Effects method);
bool uses_sort_key(Effects method);

/// Returns the methods that use them, separated by commas, for messages.
std::string methods_with_iterations();
std::string methods_with_sort_key();

/// Selects the parts that are discarded before their pixels are drawn.
struct CullChoice {
  bool back_faces = true, small = true;  ///< also without method::culling
  bool spheres = false;                  ///< meshlets by their bounding spheres
  bool temporal = false;                 ///< meshlets that were hidden in the last frame are drawn last

  /// True if the choice needs method::culling.
  bool is_special() const { return !back_faces || !small || spheres || temporal; }
};

/// Names for help texts.
inline constexpr std::string_view kCullWords = "back-faces, small, spheres, temporal";

/// Replaces the usual list by `words`; an empty list is the usual one, and "none" must be the only word. A usage error
/// says what is wrong with the list, but does not name its option or key.
Result<CullChoice> parse_cull(std::span<const std::string> words);

std::optional<SortKey> known_sort_key(std::string_view word);

}  // namespace zstrip::sim
