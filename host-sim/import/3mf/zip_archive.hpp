// Reads files out of a zip archive, which is a package of 3MF.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "result.hpp"

namespace zstrip::sim {

class ZipArchive {
 public:
  /// `bytes` must outlive the archive. The failure's message is a reason.
  static Result<ZipArchive> open(std::string_view bytes);

  /// Calls visit(name) for each file, in the order of names.
  template <class Visit>
  void for_each_name(const Visit& visit) const {
    for (const auto& [name, entry] : entries_) visit(name);
  }
  /// Returns the contents of a file; a leading '/' in its name has no meaning, nor has the case of its letters. All
  /// files together have at most 64 times the bytes of the archive, and 64 MB. The failure's message is a reason.
  Result<std::string> read(std::string_view name);

 private:
  struct Entry {
    unsigned method = 0;
    std::size_t offset = 0, packed = 0, unpacked = 0;
  };
  std::string_view bytes_;
  std::map<std::string, Entry> entries_;  ///< by name in small letters
  std::uint64_t left_ = 0;                ///< bytes that may still be unpacked
};

}  // namespace zstrip::sim
