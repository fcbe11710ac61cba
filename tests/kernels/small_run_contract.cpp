// Runs of small triangles, from indices to pixels: an implementation may draw others, too, and stop where it likes, but
// what it says to have drawn, it has.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "contracts.hpp"
#include "meshlet.hpp"
#include "pictures.hpp"
#include "random.hpp"
#include "raster_vertex.hpp"
#include "zstrip/kernels/small_run.hpp"
#include "zstrip/raster/clip_triangle.hpp"
#include "zstrip/raster/span_triangle.hpp"

namespace zstrip::kernels_test {
namespace {

using namespace detail;

/// The triangles of a run: those of a meshlet, or more of them, because implementations look ahead.
class RunTriangles {
 public:
  RunTriangles(Random& random, const Meshlet& meshlet, bool is_long) {
    if (!is_long) {
      all_ = meshlet.triangles;
      return;
    }
    const auto any = [&] { return meshlet.triangles[static_cast<std::size_t>(random.below(Meshlet::kTriangles))].a; };
    for (Triangle& triangle : long_) triangle = {any(), any(), any()};
    all_ = long_;
  }
  std::span<const Triangle> all() const { return all_; }

 private:
  static inline std::array<Triangle, 5 * Meshlet::kTriangles> long_;
  std::span<const Triangle> all_;
};

/// A front face that is not small, by its spans.
void draw_spans(const Meshlet& meshlet, const Triangle& triangle, const StripTarget& target) {
  const auto index = [](std::uint32_t of_mesh) { return of_mesh - Meshlet::kFirstVertex; };
  std::uint32_t indices[3] = {index(triangle.a), index(triangle.b), index(triangle.c)};
  const auto order = [&meshlet](std::uint32_t i) { return meshlet.vertices[i].y * 65536 + meshlet.vertices[i].x; };
  rotate_to_first(order, indices[0], indices[1], indices[2]);
  RasterVertex v[3];
  for (int i = 0; i < 3; ++i) v[i] = raster_vertex(meshlet.vertices[indices[i]], meshlet.colours[indices[i]]);
  Statistics statistics{};
  StripTarget counted = target;
  counted.statistics = &statistics;
  draw_span_triangle<Shade::gouraud, false, true>(counted, v[0], v[1], v[2], Surface{}, true);
}

}  // namespace

Outcome compare_small_runs(std::uint32_t cases) {
  Random random(3);
  Outcome outcome;
  for (std::uint32_t number = 0; number < cases; ++number) {
    const Meshlet meshlet(random, number);
    const Pictures pictures(random, meshlet.width, meshlet.height, meshlet.code());
    const StripTarget portable_target = pictures.portable.target(meshlet.left, meshlet.top, nullptr);
    const StripTarget own_target = pictures.own.target(meshlet.left, meshlet.top, nullptr);
    PortableSmallRun portable(portable_target, meshlet.vertices.data(), meshlet.colours.data(), Meshlet::kFirstVertex);
    // Colours of every alignment: some assembly takes whole words.
    static_assert(alignof(Colour) == 1);
    alignas(std::uint32_t) std::uint8_t bytes[sizeof(meshlet.colours) + 3];
    auto* const colours = reinterpret_cast<Colour*>(bytes + number % 4);
    std::copy(meshlet.colours.begin(), meshlet.colours.end(), colours);
    SmallRun own{own_target, meshlet.vertices.data(), colours, Meshlet::kFirstVertex};
    const RunTriangles run(random, meshlet, number % 8 < 2);
    const auto count = static_cast<std::uint32_t>(run.all().size());
    for (std::uint32_t next = 0; next < count; ++next) {
      const Triangle* const triangles = run.all().data() + next;
      const std::uint32_t drawn = draw_small_run(own, triangles, count - next);
      if (next + drawn > count) {
        outcome.differs("the end of a run", number);
        return outcome;
      }
      for (std::uint32_t done = 0; done < drawn; ++done) {
        done += draw_small_run_portable(portable, triangles + done, drawn - done);
        if (done < drawn) draw_spans(meshlet, triangles[done], portable_target);
      }
      next += drawn;
      outcome.compared += drawn;
    }
    if (!pictures.equal()) {
      outcome.differs("a run", number);
      return outcome;
    }
  }
  return outcome;
}

}  // namespace zstrip::kernels_test
