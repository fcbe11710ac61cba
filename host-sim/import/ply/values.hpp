// The numbers behind the header of a PLY file, as text or bytes, each within the file.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "import/ply/header.hpp"

namespace zstrip::sim {

/// Returns the next number of a file; empty if the file has ended. A word that is not a number gives NaN.
class PlyValues {
 public:
  PlyValues(std::string_view data, PlyFormat format) : rest_(data), format_(format) {}

  std::optional<double> next(PlyType type);
  /// Skips the rest of a line of text.
  void skip_line();
  /// True if a text has no more words.
  bool is_at_end() const;
  /// The most elements of this kind that the rest of the file can hold.
  std::uint64_t room_for(const PlyElement& element) const;

 private:
  std::optional<double> next_word();

  std::string_view rest_;
  PlyFormat format_;
};

}  // namespace zstrip::sim
