// draw_area: any rectangle of a frame, for a part of a larger picture such as a widget of a user interface. zstrip.hpp
// does not include it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "zstrip/plan.hpp"
#include "zstrip/status.hpp"
#include "zstrip/view.hpp"

namespace zstrip {

namespace detail {

/// `area` must lie in the view, and `bytes` must hold its rows, `stride` bytes apart.
constexpr Status check_area_pixels(const View& view, const Rect& area, std::size_t bytes, std::size_t stride) {
  if (area.empty() || area.cut_to({0, 0, view.width, view.height}) != area) return {.error = Error::view_size};
  const std::uint32_t row = bytes_per_row(static_cast<std::uint16_t>(area.width()), view.format);
  if (stride < row) {
    return {.error = Error::pixels_too_small, .needed = row, .available = static_cast<std::uint32_t>(stride)};
  }
  const auto further_rows = static_cast<std::uint32_t>(area.height() - 1);
  if (bytes < row || (bytes - row) / stride < further_rows) {
    return {.error = Error::pixels_too_small,
            .needed = static_cast<std::uint32_t>(stride * further_rows + row),
            .available = static_cast<std::uint32_t>(bytes)};
  }
  return {};
}

/// Fields of 1 or 4 bits that a pixel of a narrow format consists of.
constexpr std::uint32_t bits_of_field(PixelFormat format) { return format == PixelFormat::mono ? 1 : 4; }
constexpr std::uint32_t fields_of_pixel(PixelFormat format) { return format == PixelFormat::rgb444 ? 3 : 1; }

/// Copies fields of `bits` bits. They are numbered from the highest bit of the first byte; other bits do not change.
constexpr void copy_fields(const std::byte* from, std::uint32_t first, std::byte* to, std::uint32_t to_first,
                           std::uint32_t count, std::uint32_t bits) {
  const std::uint32_t in_byte = 8 / bits, last = in_byte - 1;
  const std::uint32_t mask = (1U << bits) - 1;
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t source = first + i, place = to_first + i;
    const std::uint32_t field =
        std::to_integer<std::uint32_t>(from[source / in_byte]) >> (last - source % in_byte) * bits;
    const std::uint32_t shift = (last - place % in_byte) * bits;
    const std::uint32_t others = std::to_integer<std::uint32_t>(to[place / in_byte]) & ~(mask << shift);
    to[place / in_byte] = static_cast<std::byte>(others | (field & mask) << shift);
  }
}

/// Copies the pixels of a strip that lie in `area`. `strip` has those of `strip_area`, without gaps.
inline void copy_to_area(PixelFormat format, const Rect& strip_area, const std::byte* strip, const Rect& area,
                         std::byte* pixels, std::size_t stride) {
  const Rect part = strip_area.cut_to(area);
  const auto from_column = static_cast<std::uint16_t>(part.left - strip_area.left);
  const auto to_column = static_cast<std::uint16_t>(part.left - area.left);
  const auto width = static_cast<std::uint16_t>(part.width());
  const std::uint32_t strip_stride = bytes_per_row(static_cast<std::uint16_t>(strip_area.width()), format);
  for (std::int32_t y = part.top; y < part.bottom; ++y) {
    const std::byte* const from = strip + static_cast<std::uint32_t>(y - strip_area.top) * strip_stride;
    std::byte* const to = pixels + static_cast<std::size_t>(y - area.top) * stride;
    if (is_narrow(format)) {
      const std::uint32_t fields = fields_of_pixel(format);
      copy_fields(from, from_column * fields, to, to_column * fields, width * fields, bits_of_field(format));
    } else {
      __builtin_memcpy(to + bytes_per_row(to_column, format), from + bytes_per_row(from_column, format),
                       bytes_per_row(width, format));
    }
  }
}

}  // namespace detail

/// Draws the pixels of `area` of the frame that `renderer` has begun: those of the whole picture, in the view's format.
/// Works with every renderer, effect, and mode. Draws each strip that touches `area` into `strip`, a buffer as for
/// draw_strip, and copies its part of the area; so an area takes the time of its strips, and narrow areas take less
/// where strips are tiles (Budget::strip_columns). `pixels`: the address of the upper left pixel of `area`; its rows
/// are `stride` bytes apart, and every row starts at a byte. Writes no bits between the rows or after their last pixel.
/// Error::view_size if the area is empty or leaves the picture, Error::pixels_too_small if rows overlap (`needed` and
/// `available` are then bytes of a row) or `pixels` ends too early, and the errors of draw_strip.
template <class AnyKind>
Status draw_area(AnyKind& renderer, const Rect& area, std::span<std::byte> strip, std::span<std::byte> pixels,
                 std::size_t stride) {
  const Plan plan = renderer.frame().plan();
  const View view = renderer.frame().view();
  if (plan.strips == 0) return {.error = Error::not_begun};
  if (const Status status = detail::check_area_pixels(view, area, pixels.size(), stride); !status) return status;
  const auto first_column = static_cast<std::uint32_t>(area.left) / plan.strip_columns;
  const auto last_column = static_cast<std::uint32_t>(area.right - 1) / plan.strip_columns;
  const auto first_row = static_cast<std::uint32_t>(area.top) / plan.strip_rows;
  const auto last_row = static_cast<std::uint32_t>(area.bottom - 1) / plan.strip_rows;
  for (std::uint32_t row = first_row; row <= last_row; ++row) {
    for (std::uint32_t column = first_column; column <= last_column; ++column) {
      const auto number = static_cast<std::uint16_t>(row * plan.columns_of_strips(view) + column);
      if (const Status status = renderer.draw_strip(number, strip); !status) return status;
      detail::copy_to_area(view.format, plan.strip_area(number, view), strip.data(), area, pixels.data(), stride);
    }
  }
  return {};
}

}  // namespace zstrip
