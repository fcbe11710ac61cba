// Sends only the changed tiles of each strip to a display: those whose hash differs from that of the frame before.
//
// It serves where the bus is slower than the renderer, as SPI usually is. It needs no framebuffer: four bytes of RAM a
// tile remember the picture. Strips with fingerprints need not even be drawn.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "zstrip_hal/display.hpp"
#include "zstrip_hal/error.hpp"
#include "zstrip_hal/present.hpp"

namespace zstrip::hal {

/// Pixels from the left to the right of a tile of ChangedTiles: a whole number of bytes in each format.
inline constexpr std::uint16_t kTileColumns = 16;

/// The number of tiles of all strips of a frame, an argument of ChangedTiles. `width`: the display's, in pixels.
constexpr std::uint32_t changed_tiles(const StripLayout& layout, std::uint16_t width, std::uint16_t tile_rows = 16) {
  const std::uint32_t columns = layout.columns == 0 ? width : layout.columns;
  return layout.count * ((columns + kTileColumns - 1) / kTileColumns) * ((layout.rows + tile_rows - 1U) / tile_rows);
}

namespace detail {

/// Returns the hash of a tile: of its place, its size and its rows of pixels. It is never 0.
std::uint32_t hash_rows(std::uint32_t place, const std::byte* pixels, std::uint32_t bytes, std::uint32_t stride,
                        std::uint32_t rows);

/// Returns a hash of four words, never 0.
std::uint32_t hash_strip(std::uint32_t fingerprint, std::uint32_t place, std::uint32_t size, std::uint32_t tile);

/// Moves rows of `bytes` bytes to `to`, which begins before them or where they do: without gaps.
void pack_rows(const std::byte* from, std::byte* to, std::uint32_t bytes, std::uint32_t stride, std::uint32_t rows);

}  // namespace detail

/// Wraps a display: each write() sends the smallest rectangle that has all tiles that changed, or nothing. `tiles`: as
/// many as changed_tiles() says; tiles beyond them are always sent. A strip with fewer than `tile_rows` rows has
/// tiles of its height. Frames may write other areas than the frame before; then everything is sent. The areas of one
/// frame must not overlap: the later one would not be sent again over a change of the earlier one. `strips`: the strips
/// whose fingerprints it remembers, four bytes each; further ones are always drawn.
///
/// A change of a tile is missed with a probability of about 2^-32. After an error the next frame is drawn and sent
/// whole. `panel` must outlive it, and must not be written to in another way without forget(). The same thread may use
/// it as the panel.
template <Display Panel, std::size_t tiles, std::uint16_t tile_rows = 16, std::size_t strips = 24>
class ChangedTiles {
 public:
  /// The rows whose multiples are the borders of strips, as the panel needs them.
  static constexpr std::uint16_t kRowStep = [] {
    if constexpr (requires { Panel::kRowStep; }) return Panel::kRowStep;
    return std::uint16_t{1};
  }();

  static_assert(tile_rows % kRowStep == 0, "the panel takes areas that begin at multiples of its kRowStep");

  /// The number of strips whose fingerprints are remembered.
  static constexpr std::size_t kStrips = strips;

  /// Does not access the panel.
  explicit constexpr ChangedTiles(Panel& panel) : panel_(panel) {}

  /// See the concept Display.
  constexpr std::uint16_t width() const { return panel_.width(); }
  /// See the concept Display.
  constexpr std::uint16_t height() const { return panel_.height(); }
  /// See the concept Display.
  constexpr DisplayFormat format() const { return panel_.format(); }

  /// Starts the panel, if that is a function of its own. The next frame is sent whole.
  Error start() requires requires(Panel& panel) { panel.start(); }
  {
    forget();
    return panel_.start();
  }
  /// Lets the next frame be drawn and sent whole: when the panel was started, lost its power or was drawn to in another
  /// way.
  void forget() {
    for (std::uint32_t& hash : hashes_) hash = kUnknown;
    for (std::uint32_t& strip : strips_) strip = kUnknown;
    fingerprint_ = kUnknown;
  }

  /// See the concept Display.
  Error begin_frame() {
    next_ = 0;
    next_strip_ = 0;
    fingerprint_ = kUnknown;
    return checked(panel_.begin_frame());
  }
  /// See the concept RemembersStrips. Otherwise the fingerprint is remembered with the write() that follows.
  bool shows(const Area& area, std::uint32_t fingerprint) {
    fingerprint_ = fingerprint;
    if (fingerprint == kUnknown || next_strip_ >= strips) return false;
    if (strips_[next_strip_] != strip_of(area, fingerprint)) return false;
    next_ += tiles_of(area);
    ++next_strip_;
    return true;
  }
  /// See the concept Display. Moves the pixels that it sends to the front of `pixels`.
  Error write(const Area& area, std::span<std::byte> pixels) {
    const std::uint32_t stride = bytes_per_row(area.width, format());
    if (!contains(width(), height(), area) || pixels.size() < std::size_t{stride} * area.height) {
      return checked(panel_.write(area, pixels));  // the panel names the error
    }
    if (next_strip_ < strips) strips_[next_strip_] = strip_of(area, fingerprint_);
    ++next_strip_;
    fingerprint_ = kUnknown;
    const Area changed = changed_part(area, pixels.data(), stride);
    if (changed.width == 0) return Error::none;
    pixels = pixels.subspan(std::size_t{stride} * (changed.top - area.top));
    const std::uint32_t bytes = bytes_per_row(changed.width, format());
    if (bytes != stride) {
      const std::uint32_t left = bytes_per_row(narrow(changed.left - area.left), format());
      detail::pack_rows(pixels.data() + left, pixels.data(), bytes, stride, changed.height);
    }
    return checked(panel_.write(changed, pixels.first(std::size_t{bytes} * changed.height)));
  }
  /// See the concept Display.
  Error wait() { return checked(panel_.wait()); }
  /// See the concept Display.
  Error end_frame() {
    // Areas that this frame did not write may have been covered by others.
    for (std::size_t i = next_; i < tiles; ++i) hashes_[i] = kUnknown;
    for (std::size_t i = next_strip_; i < strips; ++i) strips_[i] = kUnknown;
    return checked(panel_.end_frame());
  }

 private:
  static constexpr std::uint32_t kUnknown = 0;
  static constexpr std::uint16_t narrow(std::uint32_t value) { return static_cast<std::uint16_t>(value); }

  Error checked(Error error) {
    if (error != Error::none) forget();
    return error;
  }

  static constexpr std::uint32_t tiles_of(const Area& area) {
    return (area.width + kTileColumns - 1U) / kTileColumns * ((area.height + tile_rows - 1U) / tile_rows);
  }
  /// Returns one hash of the next strip's fingerprint, area and first tile, which it remembers.
  std::uint32_t strip_of(const Area& area, std::uint32_t fingerprint) const {
    if (fingerprint == kUnknown) return kUnknown;
    return detail::hash_strip(fingerprint, std::uint32_t{area.left} << 16 | area.top,
                              std::uint32_t{area.width} << 16 | area.height, static_cast<std::uint32_t>(next_));
  }

  /// Remembers the hashes of an area; returns the smallest part of it that has all tiles that changed, or one without
  /// columns.
  Area changed_part(const Area& area, const std::byte* pixels, std::uint32_t stride) {
    const auto part = [](std::uint32_t whole, std::uint32_t first, std::uint32_t size) {
      return narrow(whole - first < size ? whole - first : size);
    };
    const std::uint32_t tile_bytes = bytes_per_row(kTileColumns, format());
    std::uint32_t left = area.width, top = area.height, right = 0, bottom = 0;
    for (std::uint32_t y = 0; y < area.height; y += tile_rows) {
      for (std::uint32_t x = 0; x < area.width; x += kTileColumns, ++next_) {
        const std::uint16_t columns = part(area.width, x, kTileColumns), rows = part(area.height, y, tile_rows);
        if (next_ < tiles) {
          const std::uint32_t place = (area.left + x) << 16 | (area.top + y);
          const std::uint32_t hash =
              detail::hash_rows(place, pixels + y * stride + x / kTileColumns * tile_bytes,
                                columns == kTileColumns ? tile_bytes : bytes_per_row(columns, format()), stride, rows);
          if (hashes_[next_] == hash) continue;
          hashes_[next_] = hash;
        }
        left = x < left ? x : left, right = x + columns > right ? x + columns : right;
        top = y < top ? y : top, bottom = y + rows;
      }
    }
    if (left >= right) return {};
    return {narrow(area.left + left), narrow(area.top + top), narrow(right - left), narrow(bottom - top)};
  }

  Panel& panel_;
  std::size_t next_ = 0;                  // the tile that the next write begins with
  std::size_t next_strip_ = 0;            // the number of writes and of strips left out in this frame
  std::uint32_t fingerprint_ = kUnknown;  // of the next write
  std::array<std::uint32_t, tiles> hashes_{};
  std::array<std::uint32_t, strips> strips_{};  // strip_of each strip of the last frame
};

}  // namespace zstrip::hal
