// Writes RGB565 pixels into video memory of any true colour layout.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "zstrip_hal/display.hpp"
#include "zstrip_hal/error.hpp"

namespace zstrip::hal {

/// The bits of a colour in a pixel.
struct BitField {
  std::uint8_t offset = 0;  ///< number of the lowest bit
  std::uint8_t length = 0;  ///< 1..16
  friend constexpr bool operator==(const BitField&, const BitField&) = default;
};

/// A pixel is a number of `bytes` bytes, the lowest first (all supported Linux machines are little endian). Bits that
/// belong to no colour are set: if they mean opacity, the pixel is opaque.
struct PixelLayout {
  std::uint8_t bytes = 0;  ///< 2, 3 or 4
  BitField red, green, blue;
  friend constexpr bool operator==(const PixelLayout&, const PixelLayout&) = default;
};

inline constexpr PixelLayout kRgb565Layout{2, {11, 5}, {5, 6}, {0, 5}};
inline constexpr PixelLayout kXrgb8888Layout{4, {16, 8}, {8, 8}, {0, 8}};

/// Video memory of width x height pixels, rows `stride` bytes apart.
struct VideoMemory {
  std::span<std::byte> bytes;
  std::uint16_t width = 0;
  std::uint16_t height = 0;
  std::uint32_t stride = 0;
};

/// Longer fields repeat the source's bits from the top (all ones stay all ones); shorter ones take its upper bits.
class PixelWriter {
 public:
  /// Returns none if the layout has fields that overlap, are empty or do not fit into the pixel.
  static std::optional<PixelWriter> create(const PixelLayout& layout);

  /// Writes the first 2 * area.width * area.height bytes of `pixels` (DisplayFormat::rgb565) to `area` of `memory`.
  /// Errors: area, pixels_too_small; also where `memory` is smaller than its sizes need.
  Error write(const VideoMemory& memory, const Area& area, std::span<const std::byte> pixels) const;

 private:
  explicit PixelWriter(const PixelLayout& layout);
  template <int bytes_per_pixel>
  void write_row(std::byte* to, const std::byte* from, std::uint16_t width) const;

  PixelLayout layout_;
  bool copies_ = false;  ///< the layout is RGB565
  // Each bit of the result is one bit of the source, so each of a pixel's two bytes has its own table.
  std::array<std::uint32_t, 256> of_low_{};
  std::array<std::uint32_t, 256> of_high_{};
};

}  // namespace zstrip::hal
