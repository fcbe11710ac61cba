// Depth and colour of a strip, twice: one for each implementation that is compared.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "random.hpp"
#include "zstrip/base/statistics.hpp"
#include "zstrip/pixels/target.hpp"

namespace zstrip::kernels_test {

/// Cells of one kind. Arrays of their own, so that a sanitizer sees what is read or written beside them.
inline constexpr std::size_t kMaxCells = 4096;
using Cells = std::array<std::uint16_t, kMaxCells>;
struct Storage {
  Cells &depth, &colour;
};
inline Cells portable_depth, portable_colour, own_depth, own_colour, depth_before;

/// A strip of `width` times `height` cells without one to spare: at the beginning of its arrays, or at their end.
class Picture {
 public:
  Picture(const Storage& storage, std::int32_t width, std::int32_t height, bool at_end)
      : storage_(storage),
        width_(width),
        height_(height),
        first_(at_end ? kMaxCells - static_cast<std::size_t>(width * height) : 0) {}

  std::uint16_t* depth() const { return storage_.depth.data() + first_; }
  std::uint16_t* colour() const { return storage_.colour.data() + first_; }
  std::int32_t width() const { return width_; }
  std::int32_t height() const { return height_; }

  detail::StripTarget target(std::int32_t left, std::int32_t top, Statistics* statistics) const {
    return {.area = {left, top, left + width_, top + height_},
            .view_left = left - 40,
            .view_top = top - 40,
            .first_column = left,
            .first_row = top,
            .depth = depth(),
            .colour = colour(),
            .depth_stride = width_,
            .colour_stride = width_,
            .statistics = statistics};
  }

 private:
  Storage storage_;
  std::int32_t width_, height_;
  std::size_t first_;
};

/// Two pictures with the same contents, of codes around `code` and of far and near ones.
struct Pictures {
  Picture portable, own;

  Pictures(Random& random, std::int32_t width, std::int32_t height, std::uint32_t code)
      : Pictures(static_cast<std::size_t>(width * height), width, height, random.below(2) == 0) {
    for (std::size_t i = 0; i < count_; ++i) {
      const std::int32_t kind = random.below(10);
      const std::uint32_t near_code = code + static_cast<std::uint32_t>(random.between(-2, 2));
      portable.depth()[i] = static_cast<std::uint16_t>(kind < 4    ? 0
                                                       : kind == 4 ? 65535
                                                       : kind == 5 ? random.word()
                                                                   : near_code);
      portable.colour()[i] = static_cast<std::uint16_t>(random.word());
    }
    for (const auto& [from, to] : {std::pair(&portable_depth, &own_depth), std::pair(&portable_colour, &own_colour),
                                   std::pair(&portable_depth, &depth_before)}) {
      std::copy_n(from->begin() + compared_from_, compared_, to->begin() + compared_from_);
    }
  }

  /// With the cells beside them.
  bool equal() const { return same(portable_depth, own_depth) && same(portable_colour, own_colour); }
  /// Whether anything was drawn.
  bool changed() const { return !same(portable_depth, depth_before); }

 private:
  static constexpr std::size_t kBeside = 16;

  Pictures(std::size_t count, std::int32_t width, std::int32_t height, bool at_end)
      : portable({portable_depth, portable_colour}, width, height, at_end),
        own({own_depth, own_colour}, width, height, at_end),
        count_(count),
        compared_(static_cast<std::ptrdiff_t>(std::min(count + kBeside, kMaxCells))),
        compared_from_(at_end ? static_cast<std::ptrdiff_t>(kMaxCells) - compared_ : 0) {}

  bool same(const Cells& a, const Cells& b) const {
    return std::equal(a.begin() + compared_from_, a.begin() + compared_from_ + compared_, b.begin() + compared_from_);
  }

  std::size_t count_;
  std::ptrdiff_t compared_, compared_from_;
};

}  // namespace zstrip::kernels_test
