// What two programs for boards are compared by: bytes of sections, and names of symbols that do not tell which set of
// effects a template was made for.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <string>

namespace zstrip::effects_cost {

/// Of a linked program. Both throw std::runtime_error if it is not one.
std::map<std::string, std::uint32_t> section_bytes(const std::filesystem::path& program);
std::set<std::string> symbol_names(const std::filesystem::path& program);  ///< as budget::reader_name says

}  // namespace zstrip::effects_cost
