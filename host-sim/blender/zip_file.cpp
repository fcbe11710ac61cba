// Writes zip archives without compression.
#include "blender/zip_file.hpp"

#include <zlib.h>

namespace zstrip::sim {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::uint32_t kLocalHeader = 0x04034B50, kCentralHeader = 0x02014B50, kEndOfDirectory = 0x06054B50;
constexpr std::uint16_t kVersion = 20;                // 2.0: folders in names
constexpr std::uint16_t kMadeBy = 3 << 8 | kVersion;  // 3: attributes are those of Unix
constexpr std::uint16_t kFirstDate = 1 << 5 | 1;      // 1980-01-01
constexpr std::uint32_t kPlainFile = 0100644U << 16;  // readable by all, written by the owner
constexpr std::uint16_t kStored = 0;

void put16(Bytes& to, std::size_t value) {
  to.push_back(static_cast<std::uint8_t>(value));
  to.push_back(static_cast<std::uint8_t>(value >> 8));
}

void put32(Bytes& to, std::size_t value) {
  put16(to, value & 0xFFFF);
  put16(to, value >> 16);
}

void put_text(Bytes& to, std::string_view text) { to.insert(to.end(), text.begin(), text.end()); }

/// Writes the fields that a local header and a central one share, from "version needed" to the length of extra fields.
void put_shared(Bytes& to, const ZipEntry& entry) {
  put16(to, kVersion);
  put16(to, 0);  // flags
  put16(to, kStored);
  put16(to, 0);  // time
  put16(to, kFirstDate);
  put32(to, crc32(0, reinterpret_cast<const Bytef*>(entry.content.data()), static_cast<uInt>(entry.content.size())));
  put32(to, entry.content.size());  // compressed
  put32(to, entry.content.size());
  put16(to, entry.name.size());
  put16(to, 0);  // extra fields
}

}  // namespace

Bytes to_zip(std::span<const ZipEntry> entries) {
  Bytes zip, directory;
  for (const ZipEntry& entry : entries) {
    put32(directory, kCentralHeader);
    put16(directory, kMadeBy);
    put_shared(directory, entry);
    put16(directory, 0);  // comment
    put16(directory, 0);  // disk
    put16(directory, 0);  // internal attributes
    put32(directory, kPlainFile);
    put32(directory, zip.size());
    put_text(directory, entry.name);
    put32(zip, kLocalHeader);
    put_shared(zip, entry);
    put_text(zip, entry.name);
    put_text(zip, entry.content);
  }
  const std::size_t begin = zip.size();
  zip.insert(zip.end(), directory.begin(), directory.end());
  put32(zip, kEndOfDirectory);
  put16(zip, 0);  // disk
  put16(zip, 0);  // disk of the directory
  put16(zip, entries.size());
  put16(zip, entries.size());
  put32(zip, directory.size());
  put32(zip, begin);
  put16(zip, 0);  // comment
  return zip;
}

}  // namespace zstrip::sim
