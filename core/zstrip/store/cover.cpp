// Reads and writes the encoded kinds of covers.
#include "zstrip/store/cover.hpp"

#include <bit>

namespace zstrip::detail {
namespace {

/// Returns a row's cells with x < split.
constexpr std::uint32_t cells_before(std::uint32_t split) { return (1U << split) - 1; }

constexpr bool is_leading(std::uint8_t row) { return (row & (row + 1U)) == 0; }

}  // namespace

CoverKind cover_kind(const Cover& cover, std::uint32_t width, std::uint32_t height) {
  const std::uint8_t whole = whole_row(width);
  bool all = true, leading = true, trailing = true;
  for (std::uint32_t y = 0; y < height; ++y) {
    all = all && cover[y] == whole;
    leading = leading && is_leading(cover[y]);
    trailing = trailing && is_leading(static_cast<std::uint8_t>(whole ^ cover[y]));
  }
  return all ? CoverKind::all : leading ? CoverKind::leading : trailing ? CoverKind::trailing : CoverKind::bitmap;
}

void write_cover(CoverKind kind, const Cover& cover, std::uint32_t width, std::uint32_t height, std::uint8_t* bytes) {
  if (kind == CoverKind::all) return;
  for (std::uint32_t y = 0; y < height; ++y) {
    if (kind == CoverKind::bitmap) {
      bytes[y] = cover[y];
      continue;
    }
    const std::uint8_t before = kind == CoverKind::leading ? cover[y] : whole_row(width) ^ cover[y];
    const auto split = static_cast<std::uint8_t>(std::bit_width(before));
    bytes[y / 2] = static_cast<std::uint8_t>(y % 2 == 0 ? split : bytes[y / 2] | split << 4);
  }
}

Cover read_cover(CoverKind kind, const std::uint8_t* bytes, std::uint32_t width, std::uint32_t height) {
  Cover cover;
  const std::uint32_t whole = whole_row(width);
  if (kind == CoverKind::all) {
    cover.fill(static_cast<std::uint8_t>(whole));
  } else if (kind == CoverKind::bitmap) {
    for (std::uint32_t y = 0; y < height; ++y) cover[y] = static_cast<std::uint8_t>(bytes[y] & whole);
  } else {
    const std::uint32_t inverted = kind == CoverKind::trailing ? 0xFF : 0;
    const auto row = [=](std::uint32_t split) {
      return static_cast<std::uint8_t>((cells_before(split) ^ inverted) & whole);
    };
    for (std::uint32_t y = 0; y < height; y += 2) {
      const std::uint32_t splits = *bytes++;
      cover[y] = row(splits & 0xF);
      cover[y + 1] = row(splits >> 4);
    }
  }
  for (std::uint32_t y = height; y < kTileSide; ++y) cover[y] = 0;
  return cover;
}

}  // namespace zstrip::detail
