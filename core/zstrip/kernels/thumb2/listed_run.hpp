// Runs of small triangles from the list of a strip, in assembly for Thumb-2. A triangle that goes on in the next strip
// is set up once: what the scan would step to its next row waits in memory that the bins have left, in the order of
// the lists, and is dropped unless the next strip that is drawn lies below.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "zstrip/geometry/bins.hpp"
#include "zstrip/kernels/thumb/small_run.hpp"

namespace zstrip::detail {

/// A small triangle at the row that begins a strip.
struct CarriedTriangle {
  std::uint32_t planes[12];  ///< starts and steps of SmallScan
  std::int32_t width, rows;  ///< of its box
  std::int32_t column;       ///< of the box in the strip
  std::uint32_t key;         ///< batch and index
};

/// A ring of them: written behind those that are read. What bins leave begins with it, as zeros.
struct CarriedTriangles {
  CarriedTriangle *read, *write, *begin, *end;  ///< empty if read == write
  CarriedTriangle* end_of_last;                 ///< what the strip before has written ends here
  std::int32_t left, top, right;                ///< of the strip that they are for

  /// Null if the bins have left too little.
  static CarriedTriangles* in(const Bins& bins) {
    const std::span<std::uint16_t> spare = bins.spare();
    if (spare.size_bytes() < sizeof(CarriedTriangles) + 2 * sizeof(CarriedTriangle)) return nullptr;
    return reinterpret_cast<CarriedTriangles*>(spare.data() + spare.size()) - 1;
  }

  /// Before the triangles of a strip are drawn. They are for this one if it lies below the last.
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

/// Values that the triangles of a batch share, where the assembly expects them.
struct ThumbListedRun {
  ThumbSmallRun run;
  const Triangle* triangles;
  std::uint32_t batch;                            ///< in the upper half
  std::uint32_t next_carried;                     ///< index of the one that is read next; else no index
  std::int32_t minus_rows_below = 0, column = 0;  ///< of the triangle at hand
  CarriedTriangle *read, *write, *begin, *end, *end_of_last;

  ThumbListedRun(const ThumbSmallRun& any, const Triangle* all, std::uint16_t number, const CarriedTriangles* carried)
      : run(any), triangles(all), batch(std::uint32_t{number} << 16), next_carried(~0U) {
    // Without memory a ring of one, which is full.
    read = write = begin = end_of_last = reinterpret_cast<CarriedTriangle*>(this);
    end = begin + 1;
    if (carried == nullptr) return;
    read = carried->read, write = carried->write, begin = carried->begin, end = carried->end;
    end_of_last = carried->end_of_last;
    if (read != end_of_last) next_carried = read->key - batch;
  }
};

/// As draw_small_run_thumb, of triangles that face the viewer, by their indices. Stops at an entry of a batch, too.
std::uint32_t draw_listed_run_thumb2(ThumbListedRun& run, const std::uint16_t* listed, std::uint32_t count);

}  // namespace zstrip::detail
