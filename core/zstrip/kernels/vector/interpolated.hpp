// A value that is interpolated along a row, for eight pixels at a time.
#pragma once

#include "zstrip/kernels/vector/fragments.hpp"

#if ZSTRIP_HAS_VECTORS

namespace zstrip::detail::vectors {

/// A value of four adjacent pixels, and of the next four. Modulo 2^32.
struct Interpolated {
  Words first, last;
  std::uint32_t step;  ///< a pixel
  Words step_8;

  Interpolated(std::uint32_t start, std::uint32_t step_x)
      // Settled, because GCC would take each multiple from another word.
      : Interpolated(in_all_words(start), settled(in_all_words(step_x))) {}
  /// All words of `start` are equal, and so are those of `steps`.
  Interpolated(Words start, Words steps)
      : first(start + multiples_0_to_3(steps)), last(first + (steps << 2)), step(steps[0]), step_8(steps << 3) {}
  Halves upper() const { return upper_halves(first, last); }
  void next() {
    first += step_8;
    last += step_8;
  }
  void move(std::int32_t pixels) {
    const Words by = in_all_words(step * static_cast<std::uint32_t>(pixels));
    first += by;
    last += by;
  }
};

/// Calls draw(offset) for eight of `length` >= 8 pixels at a time, and next() after each. For the rest it calls
/// move(pixels) with a negative number and draws the last eight pixels: a fragment that is drawn twice does not pass
/// the second test.
template <class Draw, class Next, class Move>
[[gnu::always_inline]] inline void for_each_eight(std::int32_t length, const Draw& draw, const Next& next,
                                                  const Move& move) {
  std::int32_t done = 0;
  do {
    draw(done);
    done += 8;
    next();
  } while (done <= length - 8);
  if (done == length) return;
  move(length - 8 - done);
  draw(length - 8);
}

}  // namespace zstrip::detail::vectors

#endif
