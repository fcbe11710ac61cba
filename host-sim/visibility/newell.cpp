// The tests of Newell, Newell and Sancha, from cheap to expensive; a polygon is split if all tests fail.
#include "visibility/newell.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <list>
#include <utility>

#include "text/number.hpp"

namespace zstrip::sim {
namespace {

constexpr std::size_t kMaxPieces = 20000;
constexpr std::size_t kMaxComparisons = 50'000'000;  // the message contains this number as text
constexpr double kApart = 1e-9;  // in projected coordinates; half of the picture's height is about 1

struct Projected {
  double x, y;
};

struct Item {
  SoupPolygon polygon;
  SoupPlane plane;
  std::vector<Projected> outline;
  double left, right, bottom, top;  // of the outline
  double nearest, farthest;         // distances along the viewing direction
  bool moved = false;
};

class Sorter {
 public:
  explicit Sorter(const Camera& camera)
      : eye_(scaled(camera.eye, 65536)),
        right_(scaled(camera.right, 1 << 30)),
        up_(scaled(camera.up, 1 << 30)),
        back_(scaled(camera.back, 1 << 30)),
        near_(camera.near_plane / 65536.0),
        perspective_(camera.projection == Projection::perspective) {}

  /// Returns false if the polygon cannot be seen.
  bool prepare(const SoupPolygon& polygon, Item& item) const {
    const SoupPlane near{{-back_.x, -back_.y, -back_.z}, near_ - dot(back_, eye_)};
    SoupSplit cut = split(polygon, near);
    if (cut.front.size() < 3) return false;
    item = {std::move(cut.front), SoupPlane::of(polygon), {}, 1e300, -1e300, 1e300, -1e300, 1e300, -1e300, false};
    for (const SoupCorner& corner : item.polygon) {
      const SoupPoint p = difference(corner.position, eye_);
      const double w = -dot(p, back_);
      const Projected q{dot(p, right_) / (perspective_ ? w : 1), dot(p, up_) / (perspective_ ? w : 1)};
      item.outline.push_back(q);
      item.left = std::min(item.left, q.x), item.right = std::max(item.right, q.x);
      item.bottom = std::min(item.bottom, q.y), item.top = std::max(item.top, q.y);
      item.nearest = std::min(item.nearest, w), item.farthest = std::max(item.farthest, w);
    }
    return !item.plane.degenerate();
  }

  /// True if p may be drawn before q, because it hides nothing of q.
  bool may_precede(const Item& p, const Item& q) const {
    return p.right <= q.left + kApart || q.right <= p.left + kApart || p.top <= q.bottom + kApart ||
           q.top <= p.bottom + kApart || lies(p, q.plane, -1) || lies(q, p.plane, 1) || !overlap(p, q);
  }
  /// The two tests that are the same with p and q exchanged.
  bool may_follow(const Item& p, const Item& q) const { return lies(q, p.plane, -1) || lies(p, q.plane, 1); }

 private:
  static SoupPoint scaled(const Vec3& v, double one) { return {v.x / one, v.y / one, v.z / one}; }

  /// True if the whole item is on the eye's side of a plane (side 1) or on the other side (-1).
  bool lies(const Item& item, const SoupPlane& plane, int side) const {
    double eyes = perspective_ ? plane.at(eye_) : dot(plane.normal, back_);
    if (std::abs(eyes) < 1e-12) return true;  // seen edge-on: it has no pixels
    eyes = eyes > 0 ? side : -side;
    return std::ranges::all_of(item.polygon,
                               [&](const SoupCorner& c) { return plane.at(c.position) * eyes >= -kOnPlane; });
  }

  /// True if the outlines overlap in more than a line: no edge of either outline has the whole other outline on its
  /// outside.
  static bool overlap(const Item& p, const Item& q) { return !separates(p, q) && !separates(q, p); }
  static bool separates(const Item& edges, const Item& other) {
    const std::vector<Projected>& o = edges.outline;
    double area = 0;
    for (std::size_t i = 0; i < o.size(); ++i) {
      const Projected &a = o[i], &b = o[(i + 1) % o.size()];
      area += a.x * b.y - b.x * a.y;
    }
    const double turn = area < 0 ? -1 : 1;
    for (std::size_t i = 0; i < o.size(); ++i) {
      const Projected &a = o[i], &b = o[(i + 1) % o.size()];
      const double length = std::hypot(b.x - a.x, b.y - a.y);
      if (std::ranges::all_of(other.outline, [&](const Projected& c) {
            return turn * ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) <= kApart * length;
          })) {
        return true;
      }
    }
    return false;
  }

  SoupPoint eye_, right_, up_, back_;
  double near_;
  bool perspective_;
};

}  // namespace

Result<NewellOrder> newell_order(const PolygonSoup& soup, const Camera& camera) {
  const Sorter sorter(camera);
  std::list<Item> waiting;  // by the farthest corner, far first
  const auto insert = [&waiting](Item item) {
    const auto place = std::ranges::find_if(waiting, [&](const Item& other) { return other.farthest < item.farthest; });
    waiting.insert(place, std::move(item));
  };
  std::vector<Item> items;
  for (const SoupPolygon& polygon : soup.polygons) {
    if (Item item; sorter.prepare(polygon, item)) items.push_back(std::move(item));
  }
  std::ranges::stable_sort(items, [](const Item& a, const Item& b) { return a.farthest > b.farthest; });
  waiting.assign(std::make_move_iterator(items.begin()), std::make_move_iterator(items.end()));

  NewellOrder order{{{}, soup.double_sided, soup.smooth, soup.background}};
  std::size_t comparisons = 0;
  while (!waiting.empty()) {
    Item& first = waiting.front();
    bool drawn = true;
    for (auto q = std::next(waiting.begin()); q != waiting.end(); ++q) {
      // All later items are nearer. An item that was moved to the front is not sorted relative to the others.
      if (q->farthest <= first.nearest && !first.moved) break;
      if (q->farthest <= first.nearest) continue;
      if (++comparisons > kMaxComparisons || order.soup.polygons.size() + waiting.size() > kMaxPieces) {
        return Failure{ExitStatus::usage,
                       fmt::format("to order the triangles takes more than {} pieces or 50 million comparisons",
                                   grouped(kMaxPieces))};
      }
      if (sorter.may_precede(first, *q)) continue;
      drawn = false;
      if (!q->moved && sorter.may_follow(first, *q)) {
        q->moved = true;
        ++order.moved;
        waiting.splice(waiting.begin(), waiting, q);
        break;
      }
      SoupSplit parts = split(first.polygon, q->plane);
      bool cuts_first = !parts.front.empty() && !parts.back.empty();
      auto cut = waiting.begin();
      if (!cuts_first) {  // otherwise the other polygon's plane cuts: the tests have failed
        parts = split(q->polygon, first.plane);
        cut = q;
      }
      if (parts.front.empty() || parts.back.empty()) {  // they differ only by rounding: either order is correct
        drawn = true;
        continue;
      }
      ++order.splits;
      waiting.erase(cut);
      for (SoupPolygon* part : {&parts.front, &parts.back}) {
        if (Item item; sorter.prepare(*part, item)) insert(std::move(item));
      }
      break;
    }
    if (!drawn) continue;
    order.soup.polygons.push_back(std::move(waiting.front().polygon));
    waiting.pop_front();
  }
  return order;
}

}  // namespace zstrip::sim
