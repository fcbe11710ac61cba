// Draws runs of small triangles from the list of a strip, in assembly for Thumb-2. A triangle that continues in the
// next strip is set up once: the values for its next row wait in memory that the bins do not use, in the order of the
// lists. They are dropped unless the next strip that is drawn lies directly below.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "zstrip/geometry/bins.hpp"
#include "zstrip/kernels/thumb/small_run.hpp"

namespace zstrip::detail {

/// The state of a small triangle at the first row of a strip.
struct CarriedTriangle {
  std::uint32_t planes[12];  ///< starts and steps of SmallScan
  std::int32_t width, rows;  ///< of the rest of the triangle's box
  std::int32_t column;       ///< the box's first column in the strip
  std::uint32_t key;         ///< batch and index
};

/// A ring of carried triangles: new ones are written after those that are still to be read. It lies at the end of the
/// bins' spare memory, and is all zeros when a frame begins.
struct CarriedTriangles {
  CarriedTriangle *read, *write, *begin, *end;  ///< empty if read == write
  CarriedTriangle* end_of_last;                 ///< end of the triangles that the strip above has written
  std::int32_t left, top, right;                ///< position of the strip for which they are carried

  /// Returns null if the bins have too little spare memory.
  static CarriedTriangles* in(const Bins& bins) {
    const std::span<std::uint16_t> spare = bins.spare();
    if (spare.size_bytes() < sizeof(CarriedTriangles) + 2 * sizeof(CarriedTriangle)) return nullptr;
    return reinterpret_cast<CarriedTriangles*>(spare.data() + spare.size()) - 1;
  }

  /// Call it before the triangles of a strip are drawn. Uses carried triangles if it lies directly below the last one.
  void begin_strip(const Bins& bins, const Rect& area) {
    if (begin == nullptr) {
      const std::span<std::uint16_t> spare = bins.spare();
      read = begin = reinterpret_cast<CarriedTriangle*>(spare.data());
      end = begin + (spare.size_bytes() - sizeof(CarriedTriangles)) / sizeof(CarriedTriangle);
      write = begin;
    } else if (area.top != top || area.left != left || area.right != right) {
      read = write;
    } else {
      read = end_of_last;
    }
    end_of_last = write;
    left = area.left, top = area.bottom, right = area.right;
  }
};

/// Values that the triangles of a batch share. The assembly depends on the order of the members.
struct ThumbListedRun {
  ThumbSmallRun run;
  const Triangle* triangles;
  std::uint32_t batch;                            ///< number in the upper half
  std::uint32_t next_carried;                     ///< index of the triangle that is read next; otherwise not an index
  std::int32_t minus_rows_below = 0, column = 0;  ///< of the current triangle
  CarriedTriangle *read, *write, *begin, *end, *end_of_last;

  ThumbListedRun(const ThumbSmallRun& any, const Triangle* all, std::uint16_t number, const CarriedTriangles* carried)
      : run(any), triangles(all), batch(std::uint32_t{number} << 16), next_carried(~0U) {
    // Without memory the ring has one place, which is full.
    read = write = begin = end_of_last = reinterpret_cast<CarriedTriangle*>(this);
    end = begin + 1;
    if (carried == nullptr) return;
    read = carried->read, write = carried->write, begin = carried->begin, end = carried->end;
    end_of_last = carried->end_of_last;
    if (read != end_of_last) next_carried = read->key - batch;
  }
};

/// Does the same as draw_small_run_thumb for triangles that face the viewer, given by their indices. Also stops at the
/// entry of a batch.
std::uint32_t draw_listed_run_thumb2(ThumbListedRun& run, const std::uint16_t* listed, std::uint32_t count);

}  // namespace zstrip::detail
