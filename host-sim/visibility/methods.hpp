// The visibility methods by their names on the command line.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "result.hpp"
#include "zstrip/effects.hpp"

namespace zstrip::sim {

struct VisibilityMethod {
  std::string_view name;
  Effects effects;               ///< the effects that select it; empty for the z-buffer
  std::string_view description;  ///< one phrase
};

/// Returns all methods, the z-buffer first.
std::span<const VisibilityMethod> visibility_methods();

/// Returns all names, separated by commas.
std::string visibility_names();

/// Returns the method of this name; the usage error lists all names.
Result<VisibilityMethod> parse_visibility(const std::string& name);

/// Returns the name of the method in these effects; without a method, that of the z-buffer.
std::string_view visibility_name(Effects effects);

/// Checks the effects of scene, depth format and method together. The usage error names the method, each effect that it
/// cannot draw, and the methods that can. `depth_given` is the name in messages of the option that selected the depth
/// format, if it is known.
Result<Done> check_visibility(
    Effects effects, std::string_view depth_given = "the depth format (--depth-format, or the scene file's key)");

}  // namespace zstrip::sim
