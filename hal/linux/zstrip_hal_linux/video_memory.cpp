// Writes RGB565 pixels into video memory of any true colour layout.
#include "zstrip_hal_linux/video_memory.hpp"

#include <bit>
#include <cstring>

namespace zstrip::hal {
namespace {

static_assert(std::endian::native == std::endian::little);

constexpr std::uint32_t bits(const BitField& field) { return ((1U << field.length) - 1U) << field.offset; }

/// Returns the part of `colour` (RGB565) that lies in `source`, spread over `target`.
std::uint32_t spread(std::uint32_t colour, const BitField& source, const BitField& target) {
  std::uint32_t result = 0;
  for (int bit = 0; bit < target.length; ++bit) {
    // Fill the target from the top with the source's bits, repeated.
    const int from = source.offset + source.length - 1 - bit % source.length;
    const int to = target.offset + target.length - 1 - bit;
    result |= (colour >> from & 1U) << to;
  }
  return result;
}

std::uint32_t convert(std::uint32_t colour, const PixelLayout& layout) {
  return spread(colour, kRgb565Layout.red, layout.red) | spread(colour, kRgb565Layout.green, layout.green) |
         spread(colour, kRgb565Layout.blue, layout.blue);
}

bool is_valid(const PixelLayout& layout) {
  if (layout.bytes < 2 || layout.bytes > 4) return false;
  std::uint32_t used = 0;
  for (const BitField& field : {layout.red, layout.green, layout.blue}) {
    if (field.length < 1 || field.length > 16 || field.offset + field.length > 8 * layout.bytes) return false;
    if ((used & bits(field)) != 0) return false;
    used |= bits(field);
  }
  return true;
}

}  // namespace

std::optional<PixelWriter> PixelWriter::create(const PixelLayout& layout) {
  if (!is_valid(layout)) return std::nullopt;
  return PixelWriter(layout);
}

PixelWriter::PixelWriter(const PixelLayout& layout) : layout_(layout), copies_(layout == kRgb565Layout) {
  const std::uint32_t unused = ~(bits(layout.red) | bits(layout.green) | bits(layout.blue));
  for (std::uint32_t value = 0; value < 256; ++value) {
    of_low_[value] = convert(value, layout) | unused;
    of_high_[value] = convert(value << 8, layout);
  }
}

template <int bytes_per_pixel>
void PixelWriter::write_row(std::byte* to, const std::byte* from, std::uint16_t width) const {
  for (std::uint16_t x = 0; x < width; ++x) {
    const std::uint32_t pixel = of_low_[std::to_integer<std::size_t>(from[0])] |  //
                                of_high_[std::to_integer<std::size_t>(from[1])];
    std::memcpy(to, &pixel, bytes_per_pixel);
    from += 2;
    to += bytes_per_pixel;
  }
}

Error PixelWriter::write(const VideoMemory& memory, const Area& area, std::span<const std::byte> pixels) const {
  if (!contains(memory.width, memory.height, area)) return Error::area;
  const std::size_t row_bytes = std::size_t{2} * area.width;
  if (pixels.size() < row_bytes * area.height) return Error::pixels_too_small;
  const std::size_t last_row = std::size_t{area.top} + area.height - 1U;
  const std::size_t end_in_row = (std::size_t{area.left} + area.width) * layout_.bytes;
  if (last_row * memory.stride + end_in_row > memory.bytes.size()) return Error::area;

  for (std::size_t y = 0; y < area.height; ++y) {
    const std::byte* from = pixels.data() + y * row_bytes;
    std::byte* to = memory.bytes.data() + (area.top + y) * memory.stride + std::size_t{area.left} * layout_.bytes;
    if (copies_) {
      std::memcpy(to, from, row_bytes);
    } else if (layout_.bytes == 2) {
      write_row<2>(to, from, area.width);
    } else if (layout_.bytes == 3) {
      write_row<3>(to, from, area.width);
    } else {
      write_row<4>(to, from, area.width);
    }
  }
  return Error::none;
}

}  // namespace zstrip::hal
