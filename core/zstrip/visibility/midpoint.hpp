// Midpoint subdivision: splits a triangle at its centroid into three pieces, repeatedly, and draws or rejects each
// piece by comparing the depths of its vertices and its centroid with the z-buffer ("improving z-buffering", see
// docs/visibility.md). Pieces use the whole triangle's planes: subdivision only decides which piece covers which
// pixels.
#pragma once

#include <algorithm>
#include <cstdint>

#include "zstrip/pixels/depth_rule.hpp"
#include "zstrip/pixels/plane.hpp"
#include "zstrip/raster/method_hooks.hpp"

namespace zstrip::detail {

/// A corner of a piece, and the result of its comparison with the z-buffer.
struct PieceCorner {
  enum class Place : std::uint8_t { unknown, in_front, behind };
  std::int32_t x, y;    ///< 28.4 raster coordinates
  std::uint32_t depth;  ///< 16.16 codes
  Place place;
};

struct Piece {
  PieceCorner corners[3];
  std::uint32_t level;

  Rect box() const {
    const PieceCorner &a = corners[0], &b = corners[1], &c = corners[2];
    return {std::min({a.x, b.x, c.x}) >> 4, std::min({a.y, b.y, c.y}) >> 4, std::max({a.x, b.x, c.x}) >> 4,
            std::max({a.y, b.y, c.y}) >> 4};
  }
  /// Returns twice the area, with the sign of the whole triangle's.
  std::int64_t area() const {
    const PieceCorner &a = corners[0], &b = corners[1], &c = corners[2];
    return std::int64_t{c.x - a.x} * (b.y - a.y) - std::int64_t{b.x - a.x} * (c.y - a.y);
  }
};

/// `mode` is the fragments' mode with the method.
template <DepthMode mode>
class MidpointSplitter {
 public:
  static constexpr bool kSafe = mode.method().any(method::midpoint_safe);

  explicit MidpointSplitter(const TargetFor<mode>& target) : target_(target), counts_(target.method->counts) {}

  /// Calls draw(piece, use) for all pieces to draw. Pieces share no pixel.
  template <class Draw>
  void for_each_piece(const RasterVertex& v0, const RasterVertex& v1, const RasterVertex& v2, const Draw& draw) {
    nearest_ = std::max({v0.depth, v1.depth, v2.depth}) >> 16;
    farthest_ = std::min({v0.depth, v1.depth, v2.depth}) >> 16;
    // Each level takes one piece and adds three.
    Piece waiting[2 * kMaxIterations + 1];
    std::uint32_t count = 1;
    waiting[0] = {{corner(v0), corner(v1), corner(v2)}, 0};
    while (count != 0) {
      const Piece piece = waiting[--count];
      const Rect box = cut(piece.box());
      if (box.empty()) continue;
      const PieceCorner centroid = centroid_of(piece);
      switch (decide(piece, centroid, box)) {
        case Decision::rejected: break;
        case Decision::shown: shown(piece, box, DepthUse::written, draw); break;
        case Decision::tested: shown(piece, box, DepthUse::tested, draw); break;
        case Decision::split:
          if constexpr (mode.counted) ++counts_->splits;
          for (int i = 0; i < 3; ++i) {
            waiting[count++] = {{piece.corners[i], piece.corners[(i + 1) % 3], centroid}, piece.level + 1};
          }
          break;
      }
    }
  }

 private:
  enum class Decision : std::uint8_t { rejected, shown, tested, split };

  Rect cut(const Rect& box) const { return box.cut_to(target_.area); }

  /// Compares a depth with the cell of its pixel; unknown outside the strip.
  PieceCorner sampled(std::int32_t x, std::int32_t y, std::uint32_t depth) {
    using enum PieceCorner::Place;
    const std::int32_t column = (x - kCentreBias) >> 4;
    const std::int32_t row = (y - kCentreBias) >> 4;
    const Rect& area = target_.area;
    if (column < area.left || column >= area.right || row < area.top || row >= area.bottom) {
      return {x, y, depth, unknown};
    }
    if constexpr (mode.counted) ++counts_->comparisons;
    const bool nearer = depth >> 16 > target_.depth_row(row)[column - area.left];
    return {x, y, depth, nearer ? in_front : behind};
  }
  PieceCorner corner(const RasterVertex& v) { return sampled(v.x, v.y, v.depth); }
  PieceCorner centroid_of(const Piece& piece) {
    const PieceCorner &a = piece.corners[0], &b = piece.corners[1], &c = piece.corners[2];
    const std::uint64_t depth = (std::uint64_t{a.depth} + b.depth + c.depth) / 3;
    return sampled((a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3, static_cast<std::uint32_t>(depth));
  }

  Decision decide(const Piece& piece, const PieceCorner& centroid, const Rect& box) {
    using enum PieceCorner::Place;
    const auto all = [&](PieceCorner::Place place) {
      return centroid.place == place &&
             std::ranges::all_of(piece.corners, [place](const PieceCorner& c) { return c.place == place; });
    };
    if (all(behind) && (!kSafe || target_.method->bounds.hides(box, nearest_, counts_))) return Decision::rejected;
    if (all(in_front) && (!kSafe || target_.method->bounds.lies_behind(box, farthest_, counts_))) {
      return Decision::shown;
    }
    if (piece.level < target_.method->iterations && can_split(piece, centroid)) return Decision::split;
    if constexpr (kSafe) return Decision::tested;
    switch (centroid.place) {
      case in_front: return Decision::shown;
      case behind: return Decision::rejected;
      case unknown: break;
    }
    return Decision::tested;
  }

  /// False if the pieces would be smaller than pixels, or the rounded centroid lies outside the piece.
  static bool can_split(const Piece& piece, const PieceCorner& centroid) {
    if (piece.area() < 3 * 2 * 256) return false;
    for (int i = 0; i < 3; ++i) {
      if (Piece{{piece.corners[i], piece.corners[(i + 1) % 3], centroid}, 0}.area() < 0) return false;
    }
    return true;
  }

  template <class Draw>
  void shown(const Piece& piece, const Rect& box, DepthUse use, const Draw& draw) {
    if constexpr (kSafe) target_.method->bounds.cover(box, nearest_);
    draw(piece, use);
  }

  const TargetFor<mode>& target_;
  VisibilityStatistics* counts_;
  std::uint32_t nearest_ = 0, farthest_ = 0;  ///< codes of the whole triangle
};

template <DepthMode mode, class Draw>
void methods::for_each_piece(const TargetFor<mode>& target, const RasterVertex& v0, const RasterVertex& v1,
                             const RasterVertex& v2, const Draw& draw) {
  MidpointSplitter<mode>(target).for_each_piece(v0, v1, v2, [&](const Piece& piece, DepthUse use) {
    RasterVertex corners[3] = {};
    for (int i = 0; i < 3; ++i) corners[i].x = piece.corners[i].x, corners[i].y = piece.corners[i].y;
    draw(corners, use);
  });
}

}  // namespace zstrip::detail
