// Parts of a frame: strips in any order, rectangles, and the mask of the drawn pixels.
#include <algorithm>

#include "zstrip/area.hpp"
#include "zstrip/pixels/colour.hpp"
#include "zstrip/resolve/convert.hpp"
#include "zstrip_player/player.hpp"

namespace zstrip {
namespace {

constexpr std::uint8_t kDrawn = 255;

/// Marks the pixels that have another colour than the background.
void mask_colours(PixelFormat format, std::uint16_t background, const std::byte* pixels, std::span<std::uint8_t> mask) {
  const std::uint32_t size = bytes_per_row(1, format);
  alignas(4) std::byte seen[4];
  if (size == 2) {
    convert_pixels(format, 1, 1, &background, reinterpret_cast<std::byte*>(&background));
    __builtin_memcpy(seen, &background, 2);
  } else {
    convert_pixels(format, 1, 1, &background, seen);
  }
  for (std::uint8_t& drawn : mask) {
    drawn = std::equal(seen, seen + size, pixels) ? 0 : kDrawn;
    pixels += size;
  }
}

}  // namespace

/// Sets the mask of the strip that was drawn last. Depth tells which pixels have the background's colour.
void Player::mask_strip(const Rect& area, const std::byte* pixels, std::uint8_t* mask) const {
  const std::span<std::uint8_t> all(mask,
                                    static_cast<std::size_t>(area.width()) * static_cast<std::size_t>(area.height()));
  const Effects effects = drawn_with_.effects;
  // With shadows a strip ends with cells that are not 0 where nothing was drawn.
  const bool has_depth = !effects.any(effect::depth_formats | effect::depth_ranges) && effects.methods == 0 &&
                         baked_.scene.shadow == nullptr;
  const bool dithered = baked_.scene.fog != nullptr && dithers_colours(view_);  // so is the background
  if (dithered) {
    std::ranges::fill(all, has_depth ? std::uint8_t{0} : kDrawn);
  } else {
    mask_colours(view_.format, detail::rgb565(staged_.scene.background), pixels, all);
  }
  if (!has_depth) return;
  const auto columns = static_cast<std::int32_t>(sample_columns(view_));
  const auto rows = static_cast<std::int32_t>(sample_rows(view_));
  const Rect& samples = state_.depth_area;
  const std::uint16_t* depth = state_.depth;
  for (std::int32_t y = samples.top; y < samples.bottom; ++y) {
    for (std::int32_t x = samples.left; x < samples.right; ++x) {
      if (*depth++ == 0) continue;
      const std::int32_t column = x / columns - area.left, row = y / rows - area.top;
      // With effect::edges the strip that is drawn has one more pixel on each side.
      if (column < 0 || column >= area.width() || row < 0 || row >= area.height()) continue;
      mask[row * area.width() + column] = kDrawn;
    }
  }
}

bool Player::draw_strip(std::uint16_t number, DrawnStrip& drawn) {
  drawn = {};
  fault_ = Fault::none;
  if (!is_open_) return fail(Fault::not_open);
  if (!is_fitted_) return fail(Fault::not_fitted);
  const bool is_kept = kept_strip_ == number;
  // A number that the plan lacks fails here; only after it the strip has an area.
  if (!is_kept) {
    if (const Status status = draw_into(number, strip(0)); !status) return fail(Fault::strip, status);
  }
  const Rect area = plan_.strip_area(number, view_);
  const std::size_t bytes =
      static_cast<std::size_t>(area.height()) * bytes_per_row(static_cast<std::uint16_t>(area.width()), view_.format);
  std::byte* const pixels = strip(0).data();
  // fit has reserved memory for the mask after that for the pixels.
  auto* const mask = masked_ ? reinterpret_cast<std::uint8_t*>(pixels + bytes) : nullptr;
  if (!is_kept && mask != nullptr) mask_strip(area, pixels, mask);
  kept_strip_ = number;
  drawn.area = area;
  drawn.pixels = {pixels, bytes};
  if (mask != nullptr) {
    drawn.mask = {mask, static_cast<std::size_t>(area.width()) * static_cast<std::size_t>(area.height())};
  }
  return true;
}

bool Player::draw_area(const Rect& area, std::span<std::byte> pixels, std::size_t stride, std::span<std::uint8_t> mask,
                       std::size_t mask_stride) {
  fault_ = Fault::none;
  if (!is_open_) return fail(Fault::not_open);
  if (!is_fitted_) return fail(Fault::not_fitted);
  if (const Status checked = detail::check_area_pixels(view_, area, pixels.size(), stride); !checked) {
    return fail(Fault::area, checked);
  }
  if (!mask.empty()) {
    if (!masked_) return fail(Fault::no_mask);
    const auto width = static_cast<std::uint32_t>(area.width());
    const auto further = static_cast<std::uint32_t>(area.height() - 1);
    if (mask_stride < width) {
      return fail(
          Fault::area,
          {.error = Error::pixels_too_small, .needed = width, .available = static_cast<std::uint32_t>(mask_stride)});
    }
    if (mask.size() < width || (mask.size() - width) / mask_stride < further) {
      return fail(Fault::area, {.error = Error::pixels_too_small,
                                .needed = static_cast<std::uint32_t>(mask_stride * further + width),
                                .available = static_cast<std::uint32_t>(mask.size())});
    }
  }
  const auto across = plan_.columns_of_strips(view_);
  const auto last_column = static_cast<std::uint32_t>(area.right - 1) / plan_.strip_columns;
  const auto last_row = static_cast<std::uint32_t>(area.bottom - 1) / plan_.strip_rows;
  for (std::uint32_t row = static_cast<std::uint32_t>(area.top) / plan_.strip_rows; row <= last_row; ++row) {
    for (std::uint32_t column = static_cast<std::uint32_t>(area.left) / plan_.strip_columns; column <= last_column;
         ++column) {
      DrawnStrip drawn;
      if (!draw_strip(static_cast<std::uint16_t>(row * across + column), drawn)) return false;
      detail::copy_to_area(view_.format, drawn.area, drawn.pixels.data(), area, pixels.data(), stride);
      if (mask.empty()) continue;
      const Rect part = drawn.area.cut_to(area);
      for (std::int32_t y = part.top; y < part.bottom; ++y) {
        std::copy_n(drawn.mask.data() + (y - drawn.area.top) * drawn.area.width() + (part.left - drawn.area.left),
                    part.width(),
                    mask.data() + static_cast<std::size_t>(y - area.top) * mask_stride + (part.left - area.left));
      }
    }
  }
  return true;
}

}  // namespace zstrip
