// The rasteriser of the truth: converts polygons and quadrics to samples in double precision. Each stage is exact or
// has the renderer's precision.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "accuracy/truth.hpp"
#include "accuracy/truth_light.hpp"
#include "accuracy/truth_quadrics.hpp"
#include "accuracy/truth_stages.hpp"

namespace zstrip::sim::truth {

/// A corner of a polygon: its position, and its weights of the corners of the triangle.
struct Corner {
  double x = 0, y = 0, w = 0;  ///< view space, w along the viewing direction
  Vector share{};
};

/// The attributes of a triangle that do not depend on its shape on the screen.
struct Look {
  std::uint32_t number = 0;
  std::array<Vector, 3> rgb{};                ///< 0..255, at the corners
  std::array<std::array<double, 2>, 3> uv{};  ///< texels
  const Texture* texture = nullptr;
  bool lit_texture = false;
  const Scene* scene = nullptr;        ///< only if samples are lit: `rgb` are vertex colours then
  const Material* material = nullptr;  ///< only if samples are lit
  std::array<Vector, 3> normal{};      ///< only if samples are lit: in world space, of the mesh's lengths
  ColourKind kind = ColourKind::even;
};

class Rasteriser {
 public:
  Rasteriser(const Camera& camera, const View& view, std::uint32_t scale, const Scene& scene, const Stages& stages)
      : orthographic_(camera.projection == Projection::orthographic),
        stages_(stages),
        codes_(scene, camera, stages.depth.value_or(Stages::Depth{})),
        fog_(scene.fog) {
    picture_.width = view.width * scale;
    picture_.height = view.height * scale;
    const Colour& background = scene.background;
    const std::size_t size = std::size_t{picture_.width} * picture_.height;
    picture_.samples.resize(size);
    if (stages.depth) picture_.code.assign(size, 0);
    const Vector rgb{double(background.r), double(background.g), double(background.b)};
    for (std::uint32_t y = 0; y < picture_.height; ++y) {
      for (std::uint32_t x = 0; x < picture_.width; ++x) sample(x, y).rgb = colour(rgb, ColourKind::even, x, y);
    }
    focal_ = camera.focal / kOne16 * picture_.height / 2.0;
  }

  void draw(const std::vector<Corner>& polygon, const Look& look, bool double_sided) {
    std::vector<Triangle3> fan;
    for (std::size_t i = 2; i < polygon.size(); ++i) {
      Triangle3 t{{project(polygon[0]), project(polygon[i - 1]), project(polygon[i])}, 0};
      t.area = edge(t.p[0], t.p[1], t.p[2].x, t.p[2].y);
      // Counter-clockwise with y upwards; y is downwards here, so that the area is negative.
      if (t.area > 0 && !double_sided) continue;
      if (t.area < 0) std::swap(t.p[1], t.p[2]), t.area = -t.area;
      if (t.area > 0) fan.push_back(t);
    }
    // Runs of texels cover the whole clipped polygon.
    if (stages_.interpolation && look.texture != nullptr) find_rows(fan);
    for (const Triangle3& t : fan) {
      for_each_inside(t, [&](std::uint32_t x, std::uint32_t y) { shade(t, look, x, y); });
    }
  }

  void draw(const QuadricTruth& quadric, std::uint32_t number, ColourKind kind) {
    for (std::uint32_t y = 0; y < picture_.height; ++y) {
      for (std::uint32_t x = 0; x < picture_.width; ++x) {
        const std::optional<QuadricSample> seen =
            quadric.at((x + 0.5 - picture_.width / 2.0) / picture_.height, 0.5 - (y + 0.5) / picture_.height);
        if (seen && is_nearer(seen->w, x, y)) show({x, y}, number, seen->w, {seen->u, seen->v}, seen->rgb, kind);
      }
    }
  }
  TruthPicture take() { return std::move(picture_); }

 private:
  struct Point {
    double x, y, q;  ///< picture coordinates; 1/w, or 1 without perspective
    double w;
    Vector share;
  };
  /// On the screen, with a positive area.
  struct Triangle3 {
    std::array<Point, 3> p;
    double area;
  };
  /// The part of a row that a polygon covers.
  struct Row {
    std::uint32_t first = UINT32_MAX, last = 0;
  };
  /// A point of a triangle: its distance, and its weights of the corners of the whole triangle.
  struct Place {
    double w;
    Vector share;
  };

  TruthSample& sample(std::uint32_t x, std::uint32_t y) {
    return picture_.samples[std::size_t{y} * picture_.width + x];
  }

  Point project(const Corner& c) const {
    const double q = orthographic_ ? 1 : 1 / c.w;
    // To nearest, halves up (docs/conventions.md).
    const auto snapped = [&](double at) { return stages_.snapping ? std::floor(at * 16 + 0.5) / 16 : at; };
    return {snapped(picture_.width / 2.0 + c.x * q * focal_), snapped(picture_.height / 2.0 - c.y * q * focal_), q, c.w,
            c.share};
  }

  static double edge(const Point& a, const Point& b, double x, double y) {
    return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
  }
  static Vector edges(const Triangle3& t, double x, double y) {
    return {edge(t.p[1], t.p[2], x, y), edge(t.p[2], t.p[0], x, y), edge(t.p[0], t.p[1], x, y)};
  }
  /// With y downwards and a positive area the interior is to the right of the edge's direction.
  static bool is_top_left(const Point& a, const Point& b) { return b.y < a.y || (b.y == a.y && b.x > a.x); }

  template <class Visit>
  void for_each_inside(const Triangle3& t, const Visit& visit) const {
    const std::array<Point, 3>& p = t.p;
    const auto [left, right] = std::minmax({p[0].x, p[1].x, p[2].x});
    const auto [top, bottom] = std::minmax({p[0].y, p[1].y, p[2].y});
    const auto clamped = [](double at, std::uint32_t size) {
      return static_cast<std::uint32_t>(std::clamp(std::floor(at), 0.0, static_cast<double>(size)));
    };
    const std::uint32_t x_end = clamped(right + 1, picture_.width), y_end = clamped(bottom + 1, picture_.height);
    const std::array<bool, 3> owns{is_top_left(p[1], p[2]), is_top_left(p[2], p[0]), is_top_left(p[0], p[1])};
    for (std::uint32_t y = clamped(top, picture_.height); y < y_end; ++y) {
      for (std::uint32_t x = clamped(left, picture_.width); x < x_end; ++x) {
        const Vector e = edges(t, x + 0.5, y + 0.5);
        bool inside = true;
        for (std::size_t i = 0; i < 3; ++i) inside = inside && (e[i] > 0 || (e[i] == 0 && owns[i]));
        if (inside) visit(x, y);
      }
    }
  }

  void find_rows(const std::vector<Triangle3>& fan) {
    rows_.assign(picture_.height, Row{});
    for (const Triangle3& t : fan) {
      for_each_inside(t, [this](std::uint32_t x, std::uint32_t y) {
        rows_[y] = {std::min(rows_[y].first, x), std::max(rows_[y].last, x)};
      });
    }
  }

  Place place(const Triangle3& t, std::uint32_t x, std::uint32_t y) const {
    const Vector e = edges(t, x + 0.5, y + 0.5);
    double q = 0, w = 0;
    Place place{0, {}};
    for (std::size_t i = 0; i < 3; ++i) {
      const double weight = e[i] / t.area * t.p[i].q;
      q += weight;
      w += e[i] / t.area * t.p[i].w;
      for (std::size_t j = 0; j < 3; ++j) place.share[j] += weight * t.p[i].share[j];
    }
    for (double& share : place.share) share /= q;
    place.w = orthographic_ ? w : 1 / q;
    return place;
  }

  template <std::size_t size>
  static std::array<double, size> mixed(const Vector& share, const std::array<std::array<double, size>, 3>& of) {
    std::array<double, size> sum{};
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t c = 0; c < size; ++c) sum[c] += share[j] * of[j][c];
    }
    return sum;
  }

  /// Interpolates the corners' values linearly on the screen, in steps.
  double stepped(const Triangle3& t, const std::array<double, 3>& value, std::uint32_t x, std::uint32_t y) const {
    return truth::stepped({{{t.p[0].x, t.p[0].y}, {t.p[1].x, t.p[1].y}, {t.p[2].x, t.p[2].y}}}, value, x + 0.5,
                          y + 0.5);
  }
  template <std::size_t size>
  std::array<double, size> stepped(const Triangle3& t, const std::array<std::array<double, size>, 3>& of,
                                   std::uint32_t x, std::uint32_t y) const {
    std::array<double, size> at{};
    for (std::size_t c = 0; c < size; ++c) {
      std::array<double, 3> corner{};
      for (std::size_t i = 0; i < 3; ++i) corner[i] = mixed(t.p[i].share, of)[c];
      at[c] = stepped(t, corner, x, y);
    }
    return at;
  }

  /// Exact at the ends of the run, linear between.
  std::array<double, 2> texels_of_run(const Triangle3& t, const Look& look, std::uint32_t x, std::uint32_t y) const {
    const std::uint32_t run = *stages_.interpolation;
    if (run == 0) return stepped(t, look.uv, x, y);
    const std::uint32_t begin = rows_[y].first + (x - rows_[y].first) / run * run;
    const std::uint32_t end = std::min(begin + run, rows_[y].last);
    const auto from = mixed(place(t, begin, y).share, look.uv);
    if (end <= begin) return from;
    const auto to = mixed(place(t, end, y).share, look.uv);
    const double part = double(x - begin) / (end - begin);
    return {from[0] + part * (to[0] - from[0]), from[1] + part * (to[1] - from[1])};
  }

  void shade(const Triangle3& t, const Look& look, std::uint32_t x, std::uint32_t y) {
    const Place at = place(t, x, y);
    double w = at.w;
    if (stages_.interpolation) {
      w = codes_.distance(
          stepped(t, {codes_.linear(t.p[0].w), codes_.linear(t.p[1].w), codes_.linear(t.p[2].w)}, x, y));
    }
    if (!is_nearer(w, x, y)) return;
    Vector rgb = stages_.interpolation ? stepped(t, look.rgb, x, y) : mixed(at.share, look.rgb);
    std::array<double, 2> uv = mixed(at.share, look.uv);
    if (stages_.interpolation && look.texture != nullptr) uv = texels_of_run(t, look, x, y);
    if (look.material != nullptr) {
      const Vector light = lit_colour(*look.scene, *look.material, mixed(at.share, look.normal));
      for (std::size_t c = 0; c < 3; ++c) rgb[c] *= light[c] / 255;
    }
    if (look.texture != nullptr) {
      const Vector texel = texel_at(*look.texture, uv[0], uv[1]);
      for (std::size_t c = 0; c < 3; ++c) rgb[c] = look.lit_texture ? rgb[c] * texel[c] / 255 : texel[c];
    }
    show({x, y}, look.number, w, uv, rgb, look.kind);
  }

  bool is_nearer(double w, std::uint32_t x, std::uint32_t y) {
    if (stages_.depth) return codes_.code(w) > picture_.code[std::size_t{y} * picture_.width + x];
    return sample(x, y).triangle == kNoTriangle || w < sample(x, y).w;
  }

  void show(const std::array<std::uint32_t, 2>& at, std::uint32_t number, double w, const std::array<double, 2>& uv,
            Vector rgb, ColourKind kind) {
    if (fog_ != nullptr) {
      const double share = visible_share(*fog_, w);
      const Vector other{double(fog_->colour.r), double(fog_->colour.g), double(fog_->colour.b)};
      for (std::size_t c = 0; c < 3; ++c) rgb[c] = share * rgb[c] + (1 - share) * other[c];
      kind = ColourKind::gradient;
    }
    const auto [x, y] = at;
    sample(x, y) = {number, w, static_cast<float>(uv[0]), static_cast<float>(uv[1]), colour(rgb, kind, x, y)};
    if (stages_.depth) picture_.code[std::size_t{y} * picture_.width + x] = codes_.code(w);
  }

  std::array<float, 3> colour(const Vector& rgb, ColourKind kind, std::uint32_t x, std::uint32_t y) const {
    if (stages_.colour) return truth::shown(*stages_.colour, rgb, kind, x, y);
    std::array<float, 3> clamped{};
    for (std::size_t c = 0; c < 3; ++c) clamped[c] = static_cast<float>(std::clamp(rgb[c], 0.0, 255.0));
    return clamped;
  }

  bool orthographic_;
  Stages stages_;
  DepthCodes codes_;
  const Fog* fog_;
  double focal_ = 0;
  TruthPicture picture_;
  std::vector<Row> rows_;  ///< of the polygon that is being drawn
};

}  // namespace zstrip::sim::truth
