// Copies the compressed pixels of PNG files into one file, as libspng wrote them. The chunks acTL, fcTL and fdAT are
// those of the PNG specification, third edition, 11.3.4.
#include "image/animated_png.hpp"

#include <zlib.h>

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace zstrip::sim {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::size_t kSignature = 8;   // bytes
constexpr std::size_t kChunkHead = 8;   // length and type
constexpr std::size_t kChunkCheck = 4;  // CRC-32 of type and content
constexpr std::size_t kSize = 8;        // width and height in IHDR
constexpr std::uint64_t kMaxDelay = 0xFFFF;

void put(Bytes& to, std::uint32_t value, int bytes) {
  while (bytes-- > 0) to.push_back(static_cast<std::uint8_t>(value >> 8 * bytes));
}

std::uint32_t number_at(std::span<const std::uint8_t> from, std::size_t at) {
  return std::uint32_t{from[at]} << 24 | std::uint32_t{from[at + 1U]} << 16 | std::uint32_t{from[at + 2U]} << 8 |
         from[at + 3U];
}

void put_chunk(Bytes& to, std::string_view type, std::span<const std::uint8_t> content) {
  put(to, static_cast<std::uint32_t>(content.size()), 4);
  const std::size_t checked = to.size();
  to.insert(to.end(), type.begin(), type.end());
  to.insert(to.end(), content.begin(), content.end());
  put(to, static_cast<std::uint32_t>(crc32_z(0, to.data() + checked, to.size() - checked)), 4);
}

/// Calls see(type, content) for each chunk of a complete PNG file.
template <typename See>
void for_each_chunk(std::span<const std::uint8_t> png, See see) {
  for (std::size_t at = kSignature; at + kChunkHead + kChunkCheck <= png.size();) {
    const std::size_t bytes = number_at(png, at);
    see(std::string_view(reinterpret_cast<const char*>(png.data()) + at + 4, 4), png.subspan(at + kChunkHead, bytes));
    at += kChunkHead + bytes + kChunkCheck;
  }
}

Bytes animation_control(std::uint32_t frames) {
  Bytes content;
  put(content, frames, 4);
  put(content, 0, 4);  // number of plays: unlimited
  return content;
}

/// `size`: width and height as in IHDR.
Bytes frame_control(std::uint32_t number, std::span<const std::uint8_t> size, std::uint64_t milliseconds) {
  Bytes content;
  content.reserve(26);  // all of them; GCC 12 warns of the growth
  put(content, number, 4);
  content.insert(content.end(), size.begin(), size.end());
  put(content, 0, 4);  // x
  put(content, 0, 4);  // y
  put(content, static_cast<std::uint32_t>(std::min(milliseconds, kMaxDelay)), 2);
  put(content, 1000, 2);  // denominator of the delay, in seconds
  put(content, 0, 1);     // keep the frame until the next one
  put(content, 0, 1);     // replace the former pixels
  return content;
}

}  // namespace

Bytes animated_png(std::span<const Bytes> frames, std::uint32_t milliseconds) {
  Bytes file(frames.front().begin(), frames.front().begin() + kSignature);
  const auto count = static_cast<std::uint32_t>(frames.size());
  const auto time_of = [&](std::uint32_t frame) { return std::uint64_t{milliseconds} * frame / count; };
  std::uint32_t number = 0;  // of chunks fcTL and fdAT
  for (std::uint32_t frame = 0; frame < count; ++frame) {
    for_each_chunk(frames[frame], [&](std::string_view type, std::span<const std::uint8_t> content) {
      if (type == "IHDR") {
        if (frame == 0) {
          put_chunk(file, type, content);
          put_chunk(file, "acTL", animation_control(count));
        }
        put_chunk(file, "fcTL", frame_control(number++, content.first(kSize), time_of(frame + 1) - time_of(frame)));
      } else if (type == "IDAT" && frame == 0) {
        put_chunk(file, type, content);
      } else if (type == "IDAT") {
        Bytes numbered;
        put(numbered, number++, 4);
        numbered.insert(numbered.end(), content.begin(), content.end());
        put_chunk(file, "fdAT", numbered);
      }
    });
  }
  put_chunk(file, "IEND", {});
  return file;
}

}  // namespace zstrip::sim
