// What two programs for boards are compared by: sections, and symbols under names that do not tell which set of effects
// a template was made for.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <utility>

namespace zstrip::effects_cost {

/// A symbol's name without return type, parameters, the namespaces that all of zstrip is in, and sets of effects among
/// its template arguments. Several functions may share it: draw_strip of every set of effects, parts that the compiler
/// has split off.
std::string reader_name(const std::string& symbol);

/// A reader_name without any template argument.
std::string without_arguments(const std::string& reader_name);

/// All in bytes.
struct FirmwareSizes {
  std::map<std::string, std::uint32_t> sections;
  std::map<std::pair<std::string, std::string>, std::uint32_t> symbols;  ///< by section and reader_name
};

/// Of a linked program. Throws std::runtime_error if it is not one.
FirmwareSizes sizes_of(const std::filesystem::path& program);

}  // namespace zstrip::effects_cost
