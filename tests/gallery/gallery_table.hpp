// docs/measured/gallery.csv: instructions of the scenes of docs/gallery.md, by processor, preset and memory.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "measured/table.hpp"

namespace zstrip::gallery {

inline constexpr const char* kScenes[] = {"lighthouse", "astronaut", "train", "robot", "watch", "chess", "home"};
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

/// The mean of the frames, and the one that takes most.
measured::Row row_of(const std::string& scene, const std::string& machine, const std::string& preset,
                     const std::string& kilobytes, const Counted& counted);

/// The table for readers: docs/measured/gallery.md.
std::string gallery_page(const measured::Table& table);

/// A row of docs/gallery.md: "| `chess` |", and its figures of a Cortex-M3 with preset size, "| 47.6 | 30.1 |".
struct PageRow {
  std::string begin, end;
};
PageRow row_of_page(const measured::Table& table, const std::string& scene);

}  // namespace zstrip::gallery
