// Draws runs of small triangles in vectors: culls four at a time, and sets up and draws four of the remaining ones at a
// time into cells. The cells are then written in the run's order, between the larger triangles.
#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "zstrip/kernels/vector/blocks.hpp"
#include "zstrip/kernels/vector/four_small.hpp"
#include "zstrip/kernels/vector/medium_blocks.hpp"
#include "zstrip/kernels/vector/small_triangle.hpp"
#include "zstrip/pixels/colour.hpp"
#include "zstrip/pixels/small_scan.hpp"

#if ZSTRIP_HAS_VECTORS

namespace zstrip::detail {
namespace {

using namespace vectors;

/// The size of a queue in triangles; how many triangles are sorted at once; and how far ahead of drawing, which is
/// limited because a run may stop.
constexpr std::uint16_t kChunk = 512;
constexpr std::uint32_t kStep = 32, kAhead = 64;

/// The positions of the set bits of a number, then kChunk, which is not an index; the last element is their number.
using Lanes = std::array<std::uint16_t, 8>;
constexpr std::array<Lanes, 16> kLanes = [] {
  std::array<Lanes, 16> all{};
  for (std::uint32_t bits = 0; bits < 16; ++bits) {
    std::uint16_t& count = all[bits][7];
    for (std::uint16_t lane = 0; lane < 4; ++lane) {
      if ((bits >> lane & 1) != 0) all[bits][count++] = lane;
    }
    for (std::uint32_t i = count; i < 5; ++i) all[bits][i] = kChunk;
  }
  return all;
}();

/// Indices of triangles in a chunk, in ascending order, followed by kChunk, which is not an index.
class Queue {
 public:
  Queue() { indices_[0] = kChunk; }
  std::uint32_t count() const { return count_; }
  std::uint32_t operator[](std::uint32_t i) const { return indices_[i]; }
  /// Returns four indices from `i` on; repeats the last one if there are fewer.
  const std::uint16_t* four_from(std::uint32_t i) {
    for (std::uint32_t end = i + 4, last = count_; last < end; ++last) indices_[last] = indices_[last - 1];
    return indices_ + i;
  }
  /// Adds the triangles among `first` to `first` + 3 whose bits are set.
  void add(std::uint32_t bits, Halves first) {
    const std::uint16_t* const lanes = kLanes[bits].data();
    store_8(indices_ + count_, load_8(lanes) + first);
    count_ += lanes[7];
  }

 private:
  std::uint16_t indices_[kChunk + 8];
  std::uint32_t count_ = 0;
};

/// Values of a run that are read for each triangle.
struct Reader {
  std::uintptr_t vertices, colours;  ///< address of mesh vertex 0

  explicit Reader(const VectorSmallRun& run)
      : vertices(reinterpret_cast<std::uintptr_t>(run.vertices) - run.first_vertex * sizeof(SnappedVertex)),
        colours(reinterpret_cast<std::uintptr_t>(run.colours) - run.first_vertex * sizeof(Colour)) {}

  const std::uint16_t* vertex(std::uint32_t index) const {
    return reinterpret_cast<const std::uint16_t*>(  // NOLINT(performance-no-int-to-ptr)
        vertices + index * sizeof(SnappedVertex));
  }
  std::uint32_t colour(std::uint32_t index) const {
    std::uint32_t word;
    __builtin_memcpy(
        &word,
        reinterpret_cast<const void*>(colours + index * sizeof(Colour)),  // NOLINT(performance-no-int-to-ptr)
        sizeof word);
    return word;
  }
  /// Loads places and depths of a corner of four triangles.
  void load(const std::uint32_t (&corner)[4], Words& place, Words& depth) const {
    const Halves first = load_4_and_4(vertex(corner[0]), vertex(corner[1]));
    const Halves last = load_4_and_4(vertex(corner[2]), vertex(corner[3]));
    place = even_words(first, last);
    depth = odd_words(first, last);
  }
};

/// Returns Assembler::narrow_area of four triangles.
Words areas(const Words (&place)[3]) {
  const Halves a = as_halves(place[0]), b = as_halves(place[1]), c = as_halves(place[2]);
  return sums_of_products(c - a, swapped_in_pairs(b - a) * in_all_pairs(1, -1));
}

/// The part of a strip within the range of narrow coordinates.
struct Strip {
  Halves first, end;              ///< as in Boxes
  std::uint16_t *depth, *colour;  ///< address of the first pixel
  std::ptrdiff_t depth_stride, colour_stride;
  bool has_room;  ///< cells fit into the strip

  explicit Strip(const StripTarget& target) : Strip(target, narrow(target.area)) {}

 private:
  Strip(const StripTarget& target, const Rect& area)
      : first(in_all_pairs(area.left, area.top)),
        end(in_all_pairs(area.right, area.bottom)),
        depth(target.depth_row(area.top) + (area.left - target.area.left)),
        colour(target.colour_row(area.top) + (area.left - target.area.left)),
        depth_stride(target.depth_stride),
        colour_stride(target.colour_stride),
        has_room(area.width() >= 2 * kCellSide && area.height() >= 2 * kCellSide &&
                 (target.depth_stride | target.colour_stride) >> 15 == 0) {}
  static Rect narrow(const Rect& area) {
    const auto limited = [](std::int32_t pixel) { return std::clamp(pixel, -kNarrowLimit / 16, kNarrowLimit / 16); };
    return {limited(area.left), limited(area.top), limited(area.right), limited(area.bottom)};
  }
};

/// The triangles of a chunk, sorted by the way in which they are drawn.
struct Sorted {
  Queue all;
  Queue in_one, in_two;     ///< triangles of `all` that fit one cell, or two
  std::uint32_t count = 0;  ///< number of sorted triangles, visible or not

  /// Sorts more triangles, up to `end`. Not inlined, so that it has all registers.
  template <bool gouraud>
  [[gnu::noinline]] void sort(const VectorSmallRun& run, const Strip& strip, const Triangle* triangles,
                              std::uint32_t end) {
    const Reader reader(run);
    const std::uint32_t room = strip.has_room ? 0xF : 0;
    end = std::min(end, count + kStep);
    std::uint32_t i = count;
    for (bool ends = false; i < end && !ends; i += 4) {
      const Triangle* four = triangles + i;
      std::uint32_t lanes = 0xF;
      Triangle rest[4];
      if (end - i < 4) {
        for (std::uint32_t lane = 0; lane < 4; ++lane) rest[lane] = four[std::min(lane, end - i - 1)];
        four = rest;
        lanes >>= 4 - (end - i);
      }
      Words place[3], depth;
      reader.load({four[0].a, four[1].a, four[2].a, four[3].a}, place[0], depth);
      reader.load({four[0].b, four[1].b, four[2].b, four[3].b}, place[1], depth);
      reader.load({four[0].c, four[1].c, four[2].c, four[3].c}, place[2], depth);
      const Words area = areas(place);
      const Words faces = !gouraud && run.surface.double_sided ? ~as_words(area == Words{}) : greater(area, Words{});
      const Boxes boxes(place[0], place[1], place[2]);
      const Halves covers = greater(signed_min(boxes.end(), strip.end), signed_max(boxes.first(), strip.first));
      const std::uint32_t drawn = upper_bits(faces & as_words(covers) & (as_words(covers) << 16)) & lanes;
      if (drawn == 0) continue;
      const Halves first = in_all_halves(static_cast<std::int32_t>(i));
      all.add(drawn, first);
      const Halves extent = boxes.end() - boxes.first();
      const Words larger = as_words(greater(extent, in_all_halves(kCellSide)));
      const Words sum = sums_of_products(boxes.greatest - boxes.least, in_all_halves(1));
      // The run most likely stops at this triangle.
      ends = upper_bits(faces & greater(sum, in_all_words(kMediumExtent - 1))) != 0;
      const Words too_large = as_words(greater(extent, in_all_halves(2 * kCellSide))) |
                              as_words(larger == in_all_words(0xFFFFFFFF)) |
                              greater(sum, in_all_words(kSmallExtent - 1));
      const Words fits_one = as_words(larger == Words{}), fits = as_words(too_large == Words{});
      in_one.add(drawn & room & upper_bits(fits_one), first);
      in_two.add(drawn & room & upper_bits(fits & ~fits_one), first);
    }
    count = std::min(i, end);
  }
};

/// Four triangles with the same number of cells, and the addresses at which they are drawn.
template <bool gouraud, std::size_t cells>
class FourDrawn {
 public:
  /// Not inlined, so that it has all registers.
  [[gnu::noinline]] void set_up(const VectorSmallRun& run, const Strip& strip, const Triangle* triangles,
                                const std::uint16_t* indices) {
    const Reader reader(run);
    const Triangle *const t0 = triangles + indices[0], *const t1 = triangles + indices[1],
                          *const t2 = triangles + indices[2], *const t3 = triangles + indices[3];
    FourCorners corners;
    const auto load = [&](int i, const std::uint32_t(&corner)[4]) {
      reader.load(corner, corners.place[i], corners.depth[i]);
      if constexpr (gouraud) {
        corners.colour[i] = Words{reader.colour(corner[0]), reader.colour(corner[1]), reader.colour(corner[2]),
                                  reader.colour(corner[3])};
      }
    };
    load(0, {t0->a, t1->a, t2->a, t3->a});
    load(1, {t0->b, t1->b, t2->b, t3->b});
    load(2, {t0->c, t1->c, t2->c, t3->c});
    if constexpr (!gouraud) {
      Words flat = in_all_words(run.surface.flat_colour);
      if (run.colours != nullptr) {
        flat = rgb565_of_words(
            Words{reader.colour(t0->a), reader.colour(t1->a), reader.colour(t2->a), reader.colour(t3->a)});
      }
      store_words(flat_, flat);
    }
    corners.template turn<gouraud>(!gouraud && run.surface.double_sided);
    const Boxes boxes(corners.place[0], corners.place[1], corners.place[2]);
    FourTriangles<gouraud> four(corners, boxes.least | in_all_halves(kPixelCentre));
    far_ = upper_bits(four.far());

    const Halves extent = boxes.end() - boxes.first();
    // A second cell lies to the right of the first one, or below it.
    const Words second = as_words(greater(extent, in_all_halves(kCellSide))) & in_all_words(kCellSide * 0x10001);
    const Halves origin =
        signed_min(signed_max(boxes.first(), strip.first),
                   strip.end - in_all_halves(kCellSide) - (cells == 2 ? as_halves(second) : Halves{}));
    const Halves moved = origin - boxes.first();
    if (any_set(moved)) four.move(moved);
    const Halves from_strip = origin - strip.first;
    const Halves depth_steps = in_all_pairs(1, static_cast<std::int32_t>(strip.depth_stride));
    const Halves colour_steps = in_all_pairs(1, static_cast<std::int32_t>(strip.colour_stride));
    store_words(depth_at_, sums_of_products(from_strip, depth_steps));
    store_words(colour_at_, sums_of_products(from_strip, colour_steps));
    const Words rows = arithmetically_right(as_words(boxes.end() - origin), 16);
    lower_[0] = upper_bits(greater(rows, in_all_words(2)));
    four.draw(cells_[0]);
    if constexpr (cells == 2) {
      store_words(second_depth_at_, sums_of_products(as_halves(second), depth_steps));
      store_words(second_colour_at_, sums_of_products(as_halves(second), colour_steps));
      lower_[1] = upper_bits(greater(rows - (second >> 16), in_all_words(2)));
      four.move(as_halves(second));
      four.draw(cells_[1]);
    }
  }

  /// Returns false if the triangle's depths differ too much.
  [[gnu::always_inline]] bool draw(const Strip& in, std::uint32_t lane) const {
    if ((far_ >> lane & 1) != 0) return false;
    std::uint16_t* const depth = in.depth + depth_at_[lane];
    std::uint16_t* const pixel = in.colour + colour_at_[lane];
    draw_cell(in, depth, pixel, 0, lane);
    if constexpr (cells == 2) {
      draw_cell(in, depth + second_depth_at_[lane], pixel + second_colour_at_[lane], 1, lane);
    }
    return true;
  }

 private:
  static Words rgb565_of_words(Words colours) {
    const Words r = (colours & in_all_words(0xF8)) << 8, g = (colours >> 5) & in_all_words(0x07E0);
    return r | g | ((colours >> 19) & in_all_words(0x1F));
  }

  [[gnu::always_inline]] void draw_cell(const Strip& in, std::uint16_t* depth, std::uint16_t* pixel, std::size_t cell,
                                        std::uint32_t lane) const {
    const auto draw = [&](std::uint32_t i) {
      const FourCells::Block& block = cells_[cell].blocks[i];
      draw_fragments(InTwoRows{in.depth_stride}, InTwoRows{in.colour_stride}, depth, pixel, block.codes, [&] {
        if constexpr (gouraud) return block.colours;
        return in_all_halves(static_cast<std::int32_t>(flat_[lane]));
      });
    };
    draw(lane);
    if ((lower_[cell] >> lane & 1) == 0) return;
    depth += 2 * in.depth_stride, pixel += 2 * in.colour_stride;
    draw(4 + lane);
  }

  FourCells cells_[cells];
  std::uint32_t depth_at_[4], colour_at_[4];                ///< offset from the strip's first pixel
  std::uint32_t second_depth_at_[4], second_colour_at_[4];  ///< offset from the first cell
  std::uint32_t far_, lower_[cells];                        ///< bits: depths differ too much; the lower rows have
                                                            ///< pixels
  std::uint32_t flat_[4];
};

/// Draws a triangle that needs more than two cells, or is medium.
template <bool gouraud>
[[gnu::noinline]] bool draw_one(const VectorSmallRun& run, const Triangle& triangle) {
  const StripTarget& target = run.target;
  const Rect& strip = target.area;
  const SnappedVertex* const vertices = run.vertices;
  std::uint32_t a = triangle.a - run.first_vertex, b = triangle.b - run.first_vertex, c = triangle.c - run.first_vertex;
  const std::uint32_t provoking = a;
  const Words place[3] = {place_of(vertices[a]), place_of(vertices[b]), place_of(vertices[c])};
  std::int32_t area = static_cast<std::int32_t>(areas(place)[0]);
  const Boxes boxes(place[0], place[1], place[2]);
  const auto extents = static_cast<std::int32_t>(sums_of_products(boxes.greatest - boxes.least, in_all_halves(1))[0]);
  if (extents >= kMediumExtent) return false;
  // Rotates as rotate_to_first does: by y, then x.
  const auto order = [&place](int i) { return static_cast<std::int32_t>(place[i][0] ^ 0x8000); };
  const std::uint32_t first = a;
  if (order(1) < order(0) && order(1) < order(2)) {
    a = b, b = c, c = first;
  } else if (order(2) < order(0)) {
    a = c, c = b, b = first;
  }
  if (!gouraud && area < 0) std::swap(b, c), area = -area;
  const SnappedVertex &v0 = vertices[a], &v1 = vertices[b], &v2 = vertices[c];
  const Colour* of_vertices[3] = {};
  std::uint16_t colour = run.surface.flat_colour;
  if constexpr (gouraud) {
    of_vertices[0] = run.colours + a, of_vertices[1] = run.colours + b, of_vertices[2] = run.colours + c;
  } else if (run.colours != nullptr) {
    colour = rgb565(run.colours[provoking]);
  }
  if (!is_small(extents, 0, v0, v1, v2)) {
    return draw_medium_in_blocks<gouraud>({target, v0, v1, v2, area}, boxes, of_vertices, colour);
  }
  const Rect whole = boxes.first_box();
  const Rect box = whole.cut_to(strip);
  const SmallTriangle small{target, v0, v1, v2, area, whole.left, whole.top, box};
  if constexpr (gouraud) return draw_small_gouraud_vector(small, of_vertices);
  return draw_small_flat_vector(small, colour);
}

/// The next triangle of a queue and its lane; `lanes` triangles are set up.
struct Place {
  std::uint32_t place = 0, lane = 0, lanes = 0;
};

/// Implements draw_small_run_vector for a chunk.
template <bool gouraud>
std::uint32_t draw_chunk(const VectorSmallRun& run, const Strip& strip, const Triangle* triangles,
                         std::uint32_t count) {
  Sorted sorted;
  FourDrawn<gouraud, 1> in_one;
  FourDrawn<gouraud, 2> in_two;
  // This is a copy, because compilers must assume that storing a lane changes any memory.
  const Strip pixels = strip;
  // Draws triangle i, the next one of the queue, and returns true; or returns false and leaves it to draw_one.
  const auto draws = [&](std::uint32_t i, Queue& queue, Place& next, auto& four) {
    if (next.lane == next.lanes) {
      while (queue.count() - next.place < 4 && sorted.count < std::min(count, i + kAhead)) {
        sorted.sort<gouraud>(run, strip, triangles, count);
      }
      const std::uint32_t lanes = std::min(queue.count() - next.place, std::uint32_t{4});
      if (lanes == 1) {  // a set-up for one triangle costs more than draw_one
        ++next.place;
        return false;
      }
      next.lane = 0, next.lanes = lanes;
      four.set_up(run, strip, triangles, queue.four_from(next.place));
    }
    ++next.place;
    return four.draw(pixels, next.lane++);
  };
  Place one, two;
  for (std::uint32_t next = 0;; ++next) {
    while (next == sorted.all.count()) {
      if (sorted.count == count) return count;
      sorted.sort<gouraud>(run, strip, triangles, count);
    }
    const std::uint32_t i = sorted.all[next];
    if (i == sorted.in_one[one.place] ? draws(i, sorted.in_one, one, in_one)
                                      : i == sorted.in_two[two.place] && draws(i, sorted.in_two, two, in_two)) {
      continue;
    }
    if (!draw_one<gouraud>(run, triangles[i])) return i;
  }
}

/// Returns true if this triangle is too large, so that a run that begins with it would be empty.
bool ends_at(const VectorSmallRun& run, const Triangle& triangle) {
  const SnappedVertex* const vertices = run.vertices;
  const Words place[3] = {place_of(vertices[triangle.a - run.first_vertex]),
                          place_of(vertices[triangle.b - run.first_vertex]),
                          place_of(vertices[triangle.c - run.first_vertex])};
  const Boxes box(place[0], place[1], place[2]);
  if (sum_of_products(box.greatest - box.least, in_all_halves(1)) < kMediumExtent) return false;
  const auto area = static_cast<std::int32_t>(areas(place)[0]);
  return area > 0 || (area < 0 && run.surface.double_sided);
}

template <bool gouraud>
std::uint32_t draw_run(const VectorSmallRun& run, const Triangle* triangles, std::uint32_t count) {
  if (count != 0 && ends_at(run, *triangles)) return 0;
  const Strip strip(run.target);
  for (std::uint32_t done = 0; done < count; done += kChunk) {
    const std::uint32_t chunk = std::min<std::uint32_t>(kChunk, count - done);
    const std::uint32_t drawn = draw_chunk<gouraud>(run, strip, triangles + done, chunk);
    if (drawn < chunk) return done + drawn;
  }
  return count;
}

}  // namespace

std::uint32_t draw_small_run_vector(const VectorSmallRun& run, const Triangle* triangles, std::uint32_t count) {
  return run.surface.flat ? draw_run<false>(run, triangles, count) : draw_run<true>(run, triangles, count);
}

}  // namespace zstrip::detail

#endif
