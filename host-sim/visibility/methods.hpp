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
  Effects effects;               ///< what selects it; nothing for the z-buffer
  std::string_view description;  ///< one phrase
};

/// The z-buffer first.
std::span<const VisibilityMethod> visibility_methods();

/// All names, separated by commas.
std::string visibility_names();

/// A usage error that lists all names if there is none such.
Result<VisibilityMethod> parse_visibility(const std::string& name);

/// The name of the method in these effects; of the z-buffer without one.
std::string_view visibility_name(Effects effects);

/// `effects` of scene, depth format and method together: a usage error names the method, each effect that it cannot
/// draw, and the methods that can. `depth_given` names in messages what has chosen the depth format, where it is known.
Result<Done> check_visibility(
    Effects effects, std::string_view depth_given = "the depth format (--depth-format, or the scene file's key)");

}  // namespace zstrip::sim
