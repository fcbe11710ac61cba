// The numbers behind the header of a PLY file, as text or bytes, each within the file.
#include "import/ply/values.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <limits>

namespace zstrip::sim {
namespace {

constexpr std::string_view kSpaces = " \t\r\n";

/// Reads an unsigned number of the file's byte order.
std::uint64_t bits_of(std::string_view bytes, bool swapped) {
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const auto byte = static_cast<std::uint8_t>(bytes[swapped ? i : bytes.size() - 1 - i]);
    bits = bits << 8 | byte;
  }
  return bits;
}

double to_number(std::uint64_t bits, PlyType type) {
  switch (type) {
    case PlyType::int8: return static_cast<std::int8_t>(bits);
    case PlyType::int16: return static_cast<std::int16_t>(bits);
    case PlyType::int32: return static_cast<std::int32_t>(bits);
    case PlyType::float32: return double{std::bit_cast<float>(static_cast<std::uint32_t>(bits))};
    case PlyType::float64: return std::bit_cast<double>(bits);
    case PlyType::uint8:
    case PlyType::uint16:
    case PlyType::uint32: break;
  }
  return static_cast<double>(bits);
}

}  // namespace

std::optional<double> PlyValues::next_word() {
  rest_.remove_prefix(std::min(rest_.find_first_not_of(kSpaces), rest_.size()));
  if (rest_.empty()) return std::nullopt;
  std::string_view word = rest_.substr(0, rest_.find_first_of(kSpaces));
  rest_.remove_prefix(word.size());
  if (word.starts_with('+')) word.remove_prefix(1);
  double number = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  if (error != std::errc() || end != word.data() + word.size()) return std::numeric_limits<double>::quiet_NaN();
  return number;
}

std::optional<double> PlyValues::next(PlyType type) {
  if (format_ == PlyFormat::text) return next_word();
  const std::size_t bytes = bytes_of(type);
  if (rest_.size() < bytes) return std::nullopt;
  const std::uint64_t bits = bits_of(rest_.substr(0, bytes), format_ == PlyFormat::big_endian);
  rest_.remove_prefix(bytes);
  return to_number(bits, type);
}

void PlyValues::skip_line() { rest_.remove_prefix(std::min(rest_.find_first_of("\r\n"), rest_.size())); }

bool PlyValues::is_at_end() const { return rest_.find_first_not_of(kSpaces) == std::string_view::npos; }

std::uint64_t PlyValues::room_for(const PlyElement& element) const {
  std::uint64_t least = 0;
  for (const PlyProperty& property : element.properties) {
    const std::size_t bytes = bytes_of(property.is_list ? property.count_type : property.type);
    least += format_ == PlyFormat::text ? 2 : bytes;  // a digit and a blank
  }
  return least == 0 ? 0 : (rest_.size() + 1) / least;
}

}  // namespace zstrip::sim
