// Reads files out of a zip archive, which is a package of 3MF.
#include "import/3mf/zip_archive.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <initializer_list>
#include <limits>
#include <optional>
#include <utility>

#include "text/text.hpp"

namespace zstrip::sim {
namespace {

constexpr std::string_view kEnd = "PK\5\6", kListed = "PK\1\2", kLocal = "PK\3\4";
constexpr std::string_view kWideEnd = "PK\6\6", kWideEndPlace = "PK\6\7";  // of zip64
constexpr unsigned kStored = 0, kDeflated = 8;
constexpr std::size_t kIsWide = 0xFFFFFFFF, kIsWideCount = 0xFFFF;  // the number has 64 bits and stands elsewhere

Failure damaged(std::string reason) { return {ExitStatus::input, std::move(reason)}; }

/// The little-endian number at a place; empty beyond the end.
std::optional<std::size_t> number_at(std::string_view bytes, std::size_t at, std::size_t size) {
  if (at > bytes.size() || bytes.size() - at < size) return std::nullopt;
  std::size_t number = 0;
  for (std::size_t i = 0; i < size; ++i) {
    number |= std::size_t{static_cast<std::uint8_t>(bytes[at + i])} << 8 * i;
  }
  return number;
}

std::string plain_name(std::string_view name) {
  if (name.starts_with('/')) name.remove_prefix(1);
  return lower(std::string(name));
}

Result<std::string> inflated(std::string_view packed, std::size_t size) {
  std::string bytes(size, '\0');
  z_stream stream{};
  if (inflateInit2(&stream, -MAX_WBITS) != Z_OK) return damaged("no memory to unpack it");
  // zlib's type has no const; it does not write.
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
  stream.avail_in = static_cast<uInt>(packed.size());
  stream.next_out = reinterpret_cast<Bytef*>(bytes.data());
  stream.avail_out = static_cast<uInt>(bytes.size());
  const int status = inflate(&stream, Z_FINISH);
  const bool whole = status == Z_STREAM_END && stream.avail_out == 0;
  inflateEnd(&stream);
  if (!whole) return damaged("a file in it is damaged");
  return bytes;
}

/// Replaces numbers that are kIsWide by the next ones of the zip64 field, if there is one. All writers that use lib3mf
/// have such a field for each file, however small.
void widen(std::string_view fields, std::initializer_list<std::size_t*> numbers) {
  constexpr std::size_t kZip64 = 1;
  std::size_t at = 0;
  while (at < fields.size() && number_at(fields, at, 2) != kZip64) at += 4 + number_at(fields, at + 2, 2).value_or(0);
  at += 4;
  for (std::size_t* const number : numbers) {
    if (*number != kIsWide) continue;
    *number = number_at(fields, at, 8).value_or(kIsWide);
    at += 8;
  }
}

}  // namespace

Result<ZipArchive> ZipArchive::open(std::string_view bytes) {
  ZipArchive archive;
  archive.bytes_ = bytes;
  archive.left_ = std::uint64_t{64} * bytes.size() + (std::uint64_t{64} << 20);
  const std::size_t end = bytes.rfind(kEnd);
  if (end == std::string_view::npos) return damaged("it is not a zip archive, or its end is missing");
  std::optional<std::size_t> count = number_at(bytes, end + 10, 2), listed = number_at(bytes, end + 16, 4);
  if ((listed == kIsWide || count == kIsWideCount) && end >= 20 && bytes.substr(end - 20).starts_with(kWideEndPlace)) {
    const std::size_t wide = number_at(bytes, end - 12, 8).value_or(bytes.size());
    if (wide < bytes.size() && bytes.substr(wide).starts_with(kWideEnd)) {
      count = number_at(bytes, wide + 32, 8), listed = number_at(bytes, wide + 48, 8);
    }
  }
  if (!count || !listed) return damaged("its list of files is cut off");
  std::size_t at = std::min(*listed, bytes.size());
  for (std::size_t i = 0; i < *count; ++i) {
    const auto field = [&](std::size_t offset, std::size_t size) { return number_at(bytes, at + offset, size); };
    const std::optional<std::size_t> last = field(42, 4);
    if (!last || !bytes.substr(at).starts_with(kListed)) return damaged("its list of files is damaged");
    const std::size_t name = *field(28, 2), skipped = *field(30, 2) + *field(32, 2);
    if (bytes.size() - at < 46 + name) return damaged("its list of files is damaged");
    Entry entry{static_cast<unsigned>(*field(10, 2)), *last, *field(20, 4), *field(24, 4)};
    widen(bytes.substr(at + 46 + name).substr(0, *field(30, 2)), {&entry.unpacked, &entry.packed, &entry.offset});
    entry.offset = std::min(entry.offset, bytes.size());
    archive.entries_.emplace(plain_name(bytes.substr(at + 46, name)), entry);
    at += 46 + name + skipped;
  }
  return archive;
}

Result<std::string> ZipArchive::read(std::string_view name) {
  const auto found = entries_.find(plain_name(name));
  if (found == entries_.end()) return damaged(fmt::format("it lacks '{}'", printable(std::string(name))));
  const Entry& entry = found->second;
  const std::optional<std::size_t> of_name = number_at(bytes_, entry.offset + 26, 2),
                                   of_rest = number_at(bytes_, entry.offset + 28, 2);
  if (!of_name || !of_rest || !bytes_.substr(entry.offset).starts_with(kLocal)) {
    return damaged("a file in it is damaged");
  }
  const std::size_t begin = entry.offset + 30 + *of_name + *of_rest;
  if (begin > bytes_.size() || bytes_.size() - begin < entry.packed) return damaged("a file in it is cut off");
  if (entry.unpacked > left_ || entry.unpacked > std::numeric_limits<uInt>::max()) {
    return damaged("it unpacks to more than a file of its size may");
  }
  // The sum that is limited is that of the unpacked sizes.
  if (entry.method == kStored && entry.packed != entry.unpacked) {
    return damaged("a file in it that is not packed has two sizes");
  }
  left_ -= entry.unpacked;
  const std::string_view packed = bytes_.substr(begin, entry.packed);
  if (entry.method == kStored) return std::string(packed);
  if (entry.method != kDeflated) return damaged("a file in it is packed by another method than deflate");
  return inflated(packed, entry.unpacked);
}

}  // namespace zstrip::sim
