// The failure of a file whose contents are not those of its format.
#pragma once

#include <fmt/format.h>

#include <string>

#include "result.hpp"

namespace zstrip::sim {

/// Returns a message that begins with a verb; the reason stands in brackets.
inline Failure unreadable_model(const std::string& reason) {
  return {ExitStatus::input,
          fmt::format("cannot be read as a model ({}); export it again, for example as .glb", reason)};
}

}  // namespace zstrip::sim
