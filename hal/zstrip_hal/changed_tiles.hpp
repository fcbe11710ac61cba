// A display that is sent only what changed: the tiles of each strip whose hash differs from that of the frame before.
//
// It serves where the bus is slower than the renderer, as SPI usually is. It needs no framebuffer: four bytes of RAM a
// tile remember the picture.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

#include "zstrip_hal/display.hpp"
#include "zstrip_hal/error.hpp"
#include "zstrip_hal/present.hpp"

namespace zstrip::hal {

/// Pixels from the left to the right of a tile of ChangedTiles: a whole number of bytes in each format.
inline constexpr std::uint16_t kTileColumns = 16;

/// The number of tiles that the strips of a frame have: what ChangedTiles needs. `width`: the display's, in pixels.
constexpr std::uint32_t changed_tiles(const StripLayout& layout, std::uint16_t width, std::uint16_t tile_rows = 16) {
  const std::uint32_t columns = layout.columns == 0 ? width : layout.columns;
  return layout.count * ((columns + kTileColumns - 1) / kTileColumns) * ((layout.rows + tile_rows - 1U) / tile_rows);
}

/// Wraps a display: each write() sends the smallest rectangle that has all tiles that changed, or nothing. `tiles`: as
/// many as changed_tiles() says; what lies beyond them is always sent. A strip with fewer than `tile_rows` rows has
/// tiles of its height. Frames may write other areas than the frame before; then everything is sent.
///
/// A change of a tile is missed with a probability of 2^-32, and never if only one word of four bytes changed. After
/// an error the next frame is sent whole. `panel` must outlive it, and must not be written to in another way without
/// forget(). The same thread may use it as the panel.
template <Display Panel, std::size_t tiles, std::uint16_t tile_rows = 16>
class ChangedTiles {
 public:
  /// The rows whose multiples are the borders of strips, as the panel needs them.
  static constexpr std::uint16_t kRowStep = [] {
    if constexpr (requires { Panel::kRowStep; }) return Panel::kRowStep;
    return std::uint16_t{1};
  }();

  /// Does not access the panel.
  explicit constexpr ChangedTiles(Panel& panel) : panel_(panel) {}

  /// See the concept Display.
  constexpr std::uint16_t width() const { return panel_.width(); }
  /// See the concept Display.
  constexpr std::uint16_t height() const { return panel_.height(); }
  /// See the concept Display.
  constexpr PixelFormat format() const { return panel_.format(); }

  /// Starts the panel, if that is a function of its own. The next frame is sent whole.
  Error start() requires requires(Panel& panel) { panel.start(); }
  {
    forget();
    return panel_.start();
  }
  /// Lets the next frame be sent whole: when the panel was started, lost its power or was drawn to in another way.
  void forget() {
    for (std::uint32_t& hash : hashes_) hash = kUnknown;
  }

  /// See the concept Display.
  Error begin_frame() {
    next_ = 0;
    return checked(panel_.begin_frame());
  }
  /// See the concept Display. Moves the pixels that it sends to the front of `pixels`.
  Error write(const Area& area, std::span<std::byte> pixels) {
    const std::uint32_t stride = bytes_per_row(area.width, format());
    if (!contains(width(), height(), area) || pixels.size() < std::size_t{stride} * area.height) {
      return checked(panel_.write(area, pixels));  // the panel names the error
    }
    const Area changed = changed_part(area, pixels.data(), stride);
    if (changed.width == 0) return Error::none;
    pixels = pixels.subspan(std::size_t{stride} * (changed.top - area.top));
    const std::uint32_t bytes = bytes_per_row(changed.width, format());
    if (bytes != stride) {
      const std::byte* from = pixels.data() + bytes_per_row(narrow(changed.left - area.left), format());
      std::byte* to = pixels.data();
      for (unsigned row = 0; row < changed.height; ++row, from += stride, to += bytes) move_forward(from, to, bytes);
    }
    return checked(panel_.write(changed, pixels.first(std::size_t{bytes} * changed.height)));
  }
  /// See the concept Display.
  Error wait() { return checked(panel_.wait()); }
  /// See the concept Display.
  Error end_frame() {
    // Areas that this frame did not write may have been covered by others.
    for (std::size_t i = next_; i < tiles; ++i) hashes_[i] = kUnknown;
    return checked(panel_.end_frame());
  }

 private:
  static constexpr std::uint32_t kUnknown = 0;  // no tile has this hash
  static constexpr std::uint16_t narrow(std::uint32_t value) { return static_cast<std::uint16_t>(value); }

  Error checked(Error error) {
    if (error != Error::none) forget();
    return error;
  }

  /// One step of the hash: for a given `hash` every word has its own result, and for a given word every hash. The
  /// rotation lets high bits reach low ones, which a multiplication does not.
  static constexpr std::uint32_t mixed(std::uint32_t hash, std::uint32_t word) {
    return (std::rotl(hash, 5) ^ word) * 0x9E3779B1U;  // 2^32 by the golden ratio, prime
  }
  /// True if words of four bytes may be read from `at`.
  static bool is_aligned(const std::byte* at) { return reinterpret_cast<std::uintptr_t>(at) % 4 == 0; }

  /// Continues the hash of a tile's place with its pixels: tiles of other areas are not taken for it.
  static std::uint32_t hash_of(std::uint32_t hash, const std::byte* pixels, std::uint32_t bytes, std::uint32_t stride,
                               unsigned rows) {
    for (; rows > 0; --rows, pixels += stride) {
      const std::byte* at = pixels;
      const std::byte* const end = at + bytes;
      if (is_aligned(at)) {
        for (; end - at >= 4; at += 4) {
          std::uint32_t word = 0;
          __builtin_memcpy(&word, __builtin_assume_aligned(at, 4), sizeof word);
          hash = mixed(hash, word);
        }
      }
      for (; at != end; ++at) hash = mixed(hash, std::to_integer<std::uint32_t>(*at));
    }
    return hash == kUnknown ? 1 : hash;
  }

  /// Remembers the hashes of an area; returns the smallest part of it that has all tiles that changed, or one without
  /// columns.
  Area changed_part(const Area& area, const std::byte* pixels, std::uint32_t stride) {
    const auto part = [](std::uint32_t whole, std::uint32_t first, std::uint32_t size) {
      return narrow(whole - first < size ? whole - first : size);
    };
    std::uint32_t left = area.width, top = area.height, right = 0, bottom = 0;
    for (std::uint32_t y = 0; y < area.height; y += tile_rows) {
      for (std::uint32_t x = 0; x < area.width; x += kTileColumns, ++next_) {
        const std::uint16_t columns = part(area.width, x, kTileColumns), rows = part(area.height, y, tile_rows);
        if (next_ < tiles) {
          const std::byte* const first = pixels + y * stride + bytes_per_row(narrow(x), format());
          const std::uint32_t place =
              mixed((area.left + x) << 16 | (area.top + y), std::uint32_t{columns} << 16 | rows);
          const std::uint32_t hash = hash_of(place, first, bytes_per_row(columns, format()), stride, rows);
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

  /// Copies `bytes` to a place that begins before them.
  static void move_forward(const std::byte* from, std::byte* to, std::uint32_t bytes) {
    if (is_aligned(from) && is_aligned(to)) {
      for (; bytes >= 4; bytes -= 4, from += 4, to += 4) {
        std::uint32_t word = 0;
        __builtin_memcpy(&word, __builtin_assume_aligned(from, 4), sizeof word);
        __builtin_memcpy(__builtin_assume_aligned(to, 4), &word, sizeof word);
      }
    }
    for (; bytes > 0; --bytes) *to++ = *from++;
  }

  Panel& panel_;
  std::size_t next_ = 0;  // the tile that the next write begins with
  std::array<std::uint32_t, tiles> hashes_{};
};

}  // namespace zstrip::hal
