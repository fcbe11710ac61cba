// What the table says of a picture: checksums find every difference, box and sums say what kind of difference it is.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "portable/crc32.hpp"
#include "zstrip/view.hpp"

namespace zstrip::targets {

/// Collects the strips of one or more frames of the same view.
class PictureSummary {
 public:
  explicit PictureSummary(const View& view) : view_(view) {}

  /// Rows [top, top + rows) of a frame, as the renderer wrote them.
  void add_pixels(std::span<const std::byte> pixels, std::uint32_t top, std::uint32_t rows);
  /// The z-buffer of the same rows.
  void add_depth(std::span<const std::uint16_t> codes);
  void add_depth(std::span<const std::uint32_t> codes);

  /// zlib's CRC-32 of all bytes of all rows, from top to bottom.
  std::uint32_t crc32() const { return pixels_.value(); }
  /// zlib's CRC-32 of the depth codes as little-endian words.
  std::uint32_t depth_crc32() const { return depth_.value(); }
  /// The smallest rectangle that holds all pixels that are not zero, which is the built-in scenes' background;
  /// all zeros if there are none.
  const Rect& box() const { return box_; }
  /// Sums of the channels as the format keeps them: 5, 6 and 5 bits for rgb565; the level three times for grey.
  std::uint64_t red() const { return red_; }
  std::uint64_t green() const { return green_; }
  std::uint64_t blue() const { return blue_; }

 private:
  void add_pixel(std::int32_t x, std::int32_t y, std::uint32_t pixel);

  View view_;
  board::Crc32 pixels_, depth_;
  Rect box_{};
  std::uint64_t red_ = 0, green_ = 0, blue_ = 0;
};

}  // namespace zstrip::targets
