// The words for what a visibility method does besides, the same on the command line and in scene files.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "result.hpp"
#include "zstrip/effects.hpp"
#include "zstrip/visibility.hpp"

namespace zstrip::sim {

/// Whether VisibilityOptions::iterations and ::key mean something to a method.
bool uses_iterations(Effects method);
bool uses_sort_key(Effects method);

/// The methods that do, separated by commas, for messages.
std::string methods_with_iterations();
std::string methods_with_sort_key();

/// What is left out before its pixels are drawn.
struct CullChoice {
  bool back_faces = true, small = true;  ///< also without method::culling
  bool spheres = false;                  ///< meshlets by their bounding spheres
  bool temporal = false;                 ///< meshlets that were hidden in the last frame are drawn last

  /// Whether it takes method::culling.
  bool is_special() const { return !back_faces || !small || spheres || temporal; }
};

/// For help texts.
inline constexpr std::string_view kCullWords = "back-faces, small, spheres, temporal";

/// The list takes the place of the usual one; an empty list is the usual one, "none" stands alone. A usage error has
/// what is wrong with a list, without naming its option or key.
Result<CullChoice> parse_cull(std::span<const std::string> words);

std::optional<SortKey> known_sort_key(std::string_view word);

}  // namespace zstrip::sim
