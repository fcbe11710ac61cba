// The `zstrip bake` that a choice of `zstrip fit` stands for.
#pragma once

#include <string>
#include <vector>

#include "cli/bake_command.hpp"

namespace zstrip::sim {

/// Returns the words behind `zstrip`, from `bake` on, that bake the same.
std::vector<std::string> bake_words(const BakeArguments& arguments);

/// Returns the words as a line for a POSIX shell, with `zstrip` in front.
std::string shell_line(const std::vector<std::string>& words);

}  // namespace zstrip::sim
