// Zip archives of files that are small enough to store as they are.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace zstrip::sim {

struct ZipEntry {
  std::string_view name;     ///< with '/' between folders, in ASCII; at most 65535 bytes
  std::string_view content;  ///< all entries together must stay below 4 GB
};

/// Returns the archive: entries in their order, stored without compression, all dated 1980-01-01, so that the same
/// entries always give the same bytes. At most 65535 entries. Format: APPNOTE.TXT of PKWARE, 4.3.
std::vector<std::uint8_t> to_zip(std::span<const ZipEntry> entries);

}  // namespace zstrip::sim
