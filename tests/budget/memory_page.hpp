// The tables in docs/memory.md, and their place in the page.
#pragma once

#include <span>
#include <string>

#include "usage.hpp"

namespace zstrip::budget {

/// The tables as text, `compiler` being what made the programs.
std::string memory_tables(std::span<const Usage> usages, const std::string& compiler);

/// The page with what stands between its two marks replaced. Throws std::runtime_error if they are not there.
std::string page_with_tables(const std::string& page, const std::string& tables);

/// "arm-none-eabi-g++ 12.2.1".
std::string compiler_version();

}  // namespace zstrip::budget
