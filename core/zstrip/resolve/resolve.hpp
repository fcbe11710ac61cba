// Converts the working strip from RGB565 to the format of the panel.
#pragma once

#include <cstddef>
#include <cstdint>

#include "zstrip/view.hpp"

namespace zstrip::detail {

/// Returns the luma of an RGB565 pixel, 0..255: channels replicated to 8 bits, weights 77, 150, 29 of 256, rounded.
constexpr std::uint8_t luma(std::uint16_t pixel) {
  const std::uint32_t r5 = pixel >> 11;
  const std::uint32_t g6 = (pixel >> 5) & 0x3FU;
  const std::uint32_t b5 = pixel & 0x1FU;
  const std::uint32_t r = (r5 << 3) | (r5 >> 2);
  const std::uint32_t g = (g6 << 2) | (g6 >> 4);
  const std::uint32_t b = (b5 << 3) | (b5 >> 2);
  return static_cast<std::uint8_t>((77 * r + 150 * g + 29 * b + 128) >> 8);
}

/// Converts a row to gray4. `out` has bytes_per_row(width, gray4) bytes; the left pixel is in the high nibble, and an
/// odd last nibble is 0.
inline void resolve_gray4(const std::uint16_t* pixels, std::uint16_t width, std::byte* out) {
  for (std::uint32_t x = 0; x < width; x += 2) {
    const std::uint32_t left = luma(pixels[x]) >> 4;
    const std::uint32_t right = x + 1U < width ? luma(pixels[x + 1]) >> 4 : 0;
    *out++ = static_cast<std::byte>((left << 4) | right);
  }
}

/// Converts a row to mono: the left pixel is in the highest bit, lit if luma >= 128; unused bits of the last byte are
/// 0.
inline void resolve_mono(const std::uint16_t* pixels, std::uint16_t width, std::byte* out) {
  for (std::uint32_t x = 0; x < width; x += 8) {
    std::uint32_t bits = 0;
    for (std::uint32_t i = 0; i < 8; ++i) {
      bits = (bits << 1) | (x + i < width ? luma(pixels[x + i]) >> 7 : 0U);
    }
    *out++ = static_cast<std::byte>(bits);
  }
}

/// Converts a row to rgb444: channels keep their upper 4 bits. `out` has bytes_per_row(width, rgb444) bytes; an odd
/// last nibble is 0.
inline void resolve_rgb444(const std::uint16_t* pixels, std::uint16_t width, std::byte* out) {
  const auto bits = [pixels](std::uint32_t x) {
    const std::uint32_t pixel = pixels[x];
    return ((pixel >> 4) & 0xF00U) | ((pixel >> 3) & 0xF0U) | ((pixel >> 1) & 0xFU);
  };
  for (std::uint32_t x = 0; x < width; x += 2) {
    const std::uint32_t left = bits(x);
    const bool pair = x + 1U < width;
    const std::uint32_t right = pair ? bits(x + 1U) : 0U;
    *out++ = static_cast<std::byte>(left >> 4);
    *out++ = static_cast<std::byte>((left << 4) | (right >> 8));
    if (pair) *out++ = static_cast<std::byte>(right);
  }
}

/// Converts a row to one byte a channel, widened by repeating the upper bits: xrgb8888 if `words`, else rgb666.
inline void resolve_wide(const std::uint16_t* pixels, std::uint16_t width, bool words, std::byte* out) {
  for (std::uint32_t x = 0; x < width; ++x) {
    const std::uint32_t pixel = pixels[x];
    const std::uint32_t r5 = pixel >> 11, g6 = (pixel >> 5) & 0x3FU, b5 = pixel & 0x1FU;
    const auto r = static_cast<std::byte>((r5 << 3) | (r5 >> 2));
    const auto g = static_cast<std::byte>((g6 << 2) | (g6 >> 4));
    const auto b = static_cast<std::byte>((b5 << 3) | (b5 >> 2));
    constexpr std::byte kSixBits{0xFC};
    *out++ = words ? b : r & kSixBits;
    *out++ = words ? g : g & kSixBits;
    *out++ = words ? r : b & kSixBits;
    if (words) *out++ = std::byte{0};
  }
}

using PixelPairs [[gnu::may_alias]] = std::uint32_t;

/// Fills `blocks` > 0 blocks of sixteen pixels.
inline void fill_blocks_portably(PixelPairs* to, std::uint32_t pair, std::uint32_t blocks) {
  for (; blocks >= 4; blocks -= 4, to += 32) {
    for (int i = 0; i < 32; ++i) to[i] = pair;
  }
  for (; blocks != 0; --blocks, to += 8) {
    for (int i = 0; i < 8; ++i) to[i] = pair;
  }
}
inline void fill_blocks(PixelPairs* to, std::uint32_t pair, std::uint32_t blocks) {
#if defined(__arm__)
  // Compilers make eight stores of the loop; a store-multiple is one instruction. r3 to r6 have the pair four times:
  // Thumb-1 stores low registers only, and r7 may be the frame pointer.
  asm volatile(
      ".syntax unified\n\t"
      "movs r3, %2\n\tmovs r4, %2\n\tmovs r5, %2\n\tmovs r6, %2\n"
      "1: stmia %0!, {r3, r4, r5, r6}\n\t"
      "stmia %0!, {r3, r4, r5, r6}\n\t"
      "subs %1, %1, #1\n\t"
      "bne 1b"
      : "+l"(to), "+l"(blocks)
      : "l"(pair)
      : "r3", "r4", "r5", "r6", "cc", "memory");
#else
  fill_blocks_portably(to, pair, blocks);
#endif
}

inline void fill_pixels(std::uint16_t* pixels, std::uint32_t count, std::uint16_t colour) {
  if (count != 0 && reinterpret_cast<std::uintptr_t>(pixels) % 4 != 0) *pixels++ = colour, --count;
  if (const std::uint32_t blocks = count / 16; blocks != 0) {
    fill_blocks(reinterpret_cast<PixelPairs*>(pixels), colour * 0x00010001U, blocks);
    pixels += blocks * 16;
    count %= 16;
  }
  for (; count != 0; --count) *pixels++ = colour;
}

/// Swaps the bytes of each of two pixels.
inline std::uint32_t swapped(std::uint32_t pair) {
#if defined(__arm__) && __ARM_ARCH >= 6
  asm("rev16 %0, %1" : "=l"(pair) : "l"(pair));  // GCC 12 makes five instructions of the C++ line below
  return pair;
#else
  return ((pair & 0x00FF00FFU) << 8) | ((pair >> 8) & 0x00FF00FFU);
#endif
}

/// Swaps the bytes of each pixel in place, two pixels at a time, in aligned words. On processors that need aligned
/// words (Cortex-M0), GCC calls memcpy for a word that may be misaligned.
inline void swap_bytes(std::uint16_t* pixels, std::uint32_t count) {
  const auto swap = [](std::uint16_t& pixel) { pixel = static_cast<std::uint16_t>((pixel << 8) | (pixel >> 8)); };
  if (count != 0 && reinterpret_cast<std::uintptr_t>(pixels) % 4 != 0) swap(*pixels++), --count;
  auto* pairs = reinterpret_cast<PixelPairs*>(pixels);
  for (; count >= 2; count -= 2, ++pairs) *pairs = swapped(*pairs);
  if (count != 0) swap(*reinterpret_cast<std::uint16_t*>(pairs));
}

/// Implements convert_pixels. Inlined, so that only the known format is linked if the compiler knows it.
[[gnu::always_inline]] inline void convert_rows(PixelFormat format, std::uint16_t width, std::uint16_t rows,
                                                std::uint16_t* pixels, std::byte* out) {
  if (format == PixelFormat::rgb565) return;
  if (format == PixelFormat::rgb565_swapped) {
    swap_bytes(pixels, std::uint32_t{rows} * width);
    return;
  }
  for (std::uint32_t y = 0; y < rows; ++y) {
    const std::uint16_t* const row = pixels + y * width;
    std::byte* const out_row = out + y * bytes_per_row(width, format);
    if (format == PixelFormat::gray4) {
      resolve_gray4(row, width, out_row);
    } else if (format == PixelFormat::mono) {
      resolve_mono(row, width, out_row);
    } else if (format == PixelFormat::rgb444) {
      resolve_rgb444(row, width, out_row);
    } else {
      resolve_wide(row, width, format == PixelFormat::xrgb8888, out_row);
    }
  }
}

}  // namespace zstrip::detail
