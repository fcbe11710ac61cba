// docs/measured/gallery.csv: instructions and flash of the scenes of docs/gallery.md, by processor, preset and memory.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "measured/table.hpp"

namespace zstrip::gallery {

inline constexpr const char* kScenes[] = {"lighthouse", "astronaut", "train", "robot", "watch", "chess", "home", "fox"};
inline constexpr const char* kMachines[] = {"m3", "m0"};
inline constexpr const char* kPresets[] = {"size", "speed"};  ///< ZSTRIP_PRESET
inline constexpr const char* kKilobytes[] = {"22", "48"};     ///< --ram of `zstrip bake`

/// Without rows and notes.
measured::Table gallery_format();

/// What project/count.cpp prints.
struct Counted {
  std::string strip_rows, crc32;
  std::vector<std::uint64_t> instructions;  ///< of each frame
};
/// Throws std::runtime_error.
Counted parse_counted(const std::string& printed);

/// The mean of the frames, the one that takes most, and the program's bytes of flash.
measured::Row row_of(const std::string& scene, const std::string& machine, const std::string& preset,
                     const std::string& kilobytes, const Counted& counted, std::uint32_t flash);

/// The table for readers: docs/measured/gallery.md.
std::string gallery_page(const measured::Table& table);

/// A row of docs/gallery.md: "| `chess` | 60,648 |" with the flash of 22 KB, and its instructions, "| 47.6 | 30.1 |";
/// those of a Cortex-M3 with preset size.
struct PageRow {
  std::string begin, end;
};
PageRow row_of_page(const measured::Table& table, const std::string& scene);

}  // namespace zstrip::gallery
