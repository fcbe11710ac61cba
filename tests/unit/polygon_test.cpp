// Clipped polygons cut into triangles: any outline, folded ones too, covers exactly where it winds counter-clockwise.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <span>
#include <sstream>
#include <vector>

#include "raster_judge.hpp"
#include "winding_oracle.hpp"

namespace {

using namespace raster_judge;
using Outline = std::vector<oracle::Point>;

std::string words(const Outline& outline) {
  std::ostringstream text;
  for (const oracle::Point& p : outline) text << '{' << p.x << ',' << p.y << "} ";
  return text.str();
}

/// How often each pixel of `area` is drawn.
std::vector<int> drawn(const Outline& outline, bool double_sided, const Rect& area) {
  RasterPolygon polygon;
  for (const oracle::Point& p : outline) {
    polygon.append({static_cast<std::int32_t>(p.x) + kCentreBias, static_cast<std::int32_t>(p.y) + kCentreBias,
                    snap_depth(1000U << 16), 0, 0, 0, 0, 0});
  }
  std::vector<int> times(kWidth * kHeight, 0);
  if (!polygon.face_front(double_sided)) return times;
  RasterVertex corner[3];
  while (polygon.cut_triangle(corner)) {
    TriangleParts parts(polygon, corner, area);
    for (Rect part; parts.next(part);) {
      EXPECT_TRUE(part.left >= area.left && part.top >= area.top && part.right <= area.right &&
                  part.bottom <= area.bottom && !part.empty());
      Canvas canvas;
      draw_span_triangle<Shade::flat, false, true>(part_of<std::uint16_t>(canvas.target(), part), corner[0], corner[1],
                                                   corner[2], Surface{}, false);
      for (std::size_t i = 0; i < times.size(); ++i) times[i] += canvas.depth[i] != 0;
    }
  }
  return times;
}

/// Empty if the outline covers the pixels of `area` around which it winds counter-clockwise, each once.
std::string winding_verdict(const Outline& outline, const Rect& area = {0, 0, kWidth, kHeight}) {
  const std::vector<int> times = drawn(outline, false, area);
  for (std::int32_t y = 0; y < kHeight; ++y) {
    for (std::int32_t x = 0; x < kWidth; ++x) {
      const bool inside = x >= area.left && x < area.right && y >= area.top && y < area.bottom;
      const int expected = inside && oracle::winding_number(outline, x, y) > 0 ? 1 : 0;
      const int got = times[static_cast<std::size_t>(y * kWidth + x)];
      if (got == expected) continue;
      return words(outline) + "drawn " + std::to_string(got) + " times at " + std::to_string(x) + "," +
             std::to_string(y);
    }
  }
  return {};
}

class Outlines {
 public:
  explicit Outlines(unsigned seed) : random_(seed) {}
  std::int64_t between(std::int64_t low, std::int64_t high) {
    return std::uniform_int_distribution<std::int64_t>(low, high)(random_);
  }
  oracle::Point any_point(std::int64_t extent) {
    return {kWidth * 8 + between(-extent, extent), kHeight * 8 + between(-extent, extent)};
  }
  /// Corners of an ellipse of any direction, around it in order, snapped: convex but for the snapping.
  Outline snapped_ellipse(double length, double width) {
    const int count = static_cast<int>(between(3, kMaxPolygon));
    std::vector<double> angles;
    for (int i = 0; i < count; ++i) angles.push_back(fraction() * 2 * M_PI);
    std::sort(angles.begin(), angles.end());
    const oracle::Point centre = any_point(300);
    const double direction = fraction() * 2 * M_PI, x = fraction(), y = fraction();
    Outline outline;
    for (const double a : angles) {  // counter-clockwise on the screen
      const double along = length * std::cos(a), across = -width * std::sin(a);
      outline.push_back({centre.x + std::lround(x + along * std::cos(direction) - across * std::sin(direction)),
                         centre.y + std::lround(y + along * std::sin(direction) + across * std::cos(direction))});
    }
    return outline;
  }
  double fraction() { return std::uniform_real_distribution<double>(0, 1)(random_); }

 private:
  std::mt19937_64 random_;
};

std::int64_t turn(const oracle::Point& a, const oracle::Point& b, const oracle::Point& c) {
  return (c.x - a.x) * (b.y - a.y) - (b.x - a.x) * (c.y - a.y);
}

/// Whether some corners turn to the left and some to the right: concave or folded, or wound around itself.
bool turns_both_ways(const Outline& outline) {
  bool left = false, right = false;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const std::int64_t t = turn(outline[i], outline[(i + 1) % outline.size()], outline[(i + 2) % outline.size()]);
    (t > 0 ? left : right) |= t != 0;
  }
  return left && right;
}

TEST(Polygon, OracleOfWindingAgreesWithTheOneOfTriangles) {
  Outlines outlines(7);
  for (int i = 0; i < 3000; ++i) {
    const std::int64_t extent = outlines.between(1, 700);
    // Half of them on a lattice of half pixels: many centres lie on edges and corners.
    const std::int64_t step = outlines.between(0, 1) == 0 ? 8 : 1;
    Outline corners;
    for (int k = 0; k < 3; ++k) {
      const oracle::Point p = outlines.any_point(extent);
      corners.push_back({p.x / step * step, p.y / step * step});
    }
    const oracle::Triangle triangle({corners[0], corners[1], corners[2]});
    const int sign = turn(corners[0], corners[1], corners[2]) > 0 ? 1 : -1;
    for (std::int64_t y = 0; y < kHeight; ++y) {
      for (std::int64_t x = 0; x < kWidth; ++x) {
        ASSERT_EQ(oracle::winding_number(corners, x, y), triangle.covers(x, y) ? sign : 0) << words(corners);
      }
    }
  }
}

TEST(Polygon, AFoldedQuadrilateralDoesNotCoverBeyondTheEdgeThatItShares) {
  // Seen edge-on and cut by the near plane; sixteenths from the picture's centre.
  Outline folded{{-664, 1269}, {204, -364}, {200, -358}, {-663, 1268}};
  for (oracle::Point& p : folded) p = {p.x + kWidth * 8, p.y + kHeight * 8};
  const oracle::Point &c = folded[2], &d = folded[3];
  const std::vector<int> times = drawn(folded, false, {0, 0, kWidth, kHeight});
  for (std::int64_t y = 0; y < kHeight; ++y) {
    for (std::int64_t x = 0; x < kWidth; ++x) {
      if (turn(c, d, {16 * x + 8, 16 * y + 8}) < 0) {
        ASSERT_EQ(times[static_cast<std::size_t>(y * kWidth + x)], 0) << x << ',' << y;
      }
    }
  }
  EXPECT_EQ(winding_verdict(folded), "");
}

TEST(Polygon, SnappedConvexOutlinesCoverWhereTheyWind) {
  Outlines outlines(1);
  int folded = 0;
  for (int i = 0; i < 6000; ++i) {
    const Outline outline = outlines.snapped_ellipse(2000 * outlines.fraction(), 3 * outlines.fraction());
    folded += turns_both_ways(outline);
    ASSERT_EQ(winding_verdict(outline), "") << i;
  }
  EXPECT_GT(folded, 1000);
}

TEST(Polygon, OrdinaryConvexOutlinesCoverWhereTheyWind) {
  Outlines outlines(2);
  for (int i = 0; i < 2000; ++i) {
    const Outline outline = outlines.snapped_ellipse(100 + 3000 * outlines.fraction(), 10 + 1000 * outlines.fraction());
    ASSERT_EQ(winding_verdict(outline), "") << i;
  }
}

/// Whether the coordinate rises once and falls once on the way around, as on a convex outline. Snapping keeps that,
/// because it keeps order; so no outline that is drawn winds twice around anything.
bool rises_once(const Outline& outline, std::int64_t oracle::Point::*coordinate) {
  bool was_rising = false;
  int changes = 0;
  for (std::size_t i = 0; i < 2 * outline.size(); ++i) {  // the first time around to find the direction
    const std::int64_t step = outline[(i + 1) % outline.size()].*coordinate - outline[i % outline.size()].*coordinate;
    if (step == 0) continue;
    if (i >= outline.size()) changes += (step > 0) != was_rising;
    was_rising = step > 0;
  }
  return changes <= 2;
}

bool rises_once(const Outline& outline) {
  return rises_once(outline, &oracle::Point::x) && rises_once(outline, &oracle::Point::y);
}

TEST(Polygon, AnyOutlineCoversWhereItWinds) {
  Outlines outlines(3);
  int judged = 0;
  for (int i = 0; i < 40000; ++i) {
    Outline outline;
    const std::int64_t extent = outlines.between(1, 800);
    for (std::int64_t k = outlines.between(0, kMaxPolygon); k > 0; --k) outline.push_back(outlines.any_point(extent));
    if (!rises_once(outline)) continue;
    judged += turns_both_ways(outline);
    ASSERT_EQ(winding_verdict(outline), "") << i;
  }
  EXPECT_GT(judged, 1000);
}

TEST(Polygon, TinyOutlinesOnHalfPixelsCoverWhereTheyWind) {
  // Corners that coincide, spikes, and centres on corners and edges.
  Outlines outlines(4);
  int judged = 0;
  for (int i = 0; i < 20000; ++i) {
    Outline outline;
    for (std::int64_t k = outlines.between(3, 6); k > 0; --k)
      outline.push_back({8 * outlines.between(0, 8), 8 * outlines.between(0, 8)});
    if (!rises_once(outline)) continue;
    judged += turns_both_ways(outline);
    ASSERT_EQ(winding_verdict(outline), "") << i;
  }
  EXPECT_GT(judged, 1000);
}

TEST(Polygon, PartsOfTheAreaCoverTheSamePixels) {
  Outlines outlines(5);
  for (int i = 0; i < 1000; ++i) {
    const Outline outline = outlines.snapped_ellipse(2000 * outlines.fraction(), 3 * outlines.fraction());
    const auto edge = [&](std::int64_t limit) { return static_cast<std::int32_t>(outlines.between(0, limit)); };
    const std::int32_t left = edge(kWidth), top = edge(kHeight);
    ASSERT_EQ(winding_verdict(outline, {left, top, std::max(left, edge(kWidth)), std::max(top, edge(kHeight))}), "");
  }
}

TEST(Polygon, OfADoubleSidedOneTheLargerSideIsDrawn) {
  Outlines outlines(6);
  for (int i = 0; i < 2000; ++i) {
    Outline outline = outlines.snapped_ellipse(2000 * outlines.fraction(), 3 * outlines.fraction());
    std::int64_t area = 0;
    for (std::size_t k = 1; k + 1 < outline.size(); ++k) area += turn(outline[0], outline[k], outline[k + 1]);
    const std::vector<int> times = drawn(outline, true, {0, 0, kWidth, kHeight});
    for (std::int64_t y = 0; y < kHeight; ++y) {
      for (std::int64_t x = 0; x < kWidth; ++x) {
        const int winding = oracle::winding_number(outline, x, y) * (area < 0 ? -1 : 1);
        ASSERT_EQ(times[static_cast<std::size_t>(y * kWidth + x)], winding > 0 ? 1 : 0) << words(outline);
      }
    }
  }
}

}  // namespace
