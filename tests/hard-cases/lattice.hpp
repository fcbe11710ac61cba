// Pictures of triangles whose corners lie exactly on the sub-pixel lattice, through the public interface: with an
// orthographic camera one step of the position grid is a whole number of sub-pixels.
#pragma once

#include <array>
#include <cstdint>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "picture.hpp"
#include "triangle_oracle.hpp"

namespace hard_cases {

using namespace zstrip;
using picture::Model;
using picture::Picture;

/// 1/16 pixels from the picture's upper left corner, y downwards.
using Corners2 = std::array<oracle::Point, 3>;

/// 64 rows: the camera's focal length is then exactly 1.
inline constexpr View kView{96, 64};
inline constexpr int kPixels = 96 * 64;

inline constexpr Colour kWhite{255, 255, 255, 255};

class Lattice {
 public:
  /// `step`: sub-pixels in one step of the position grid, a power of two up to 32. Coordinates given to add() must be
  /// multiples of it and within 32767 steps of the picture's centre.
  explicit Lattice(int step = 1) : step_(step) {
    model_.mesh.half_extent = {64 * step * kFixedOne, 64 * step * kFixedOne, 64 * step * kFixedOne};
    model_.material.lit = false;
    model_.material.smooth = false;
    camera_.projection = Projection::orthographic;
    camera_.focal = kFixedOne;
    camera_.near_plane = kFixedOne;
    camera_.far_plane = 8192 * kFixedOne;
    camera_.eye = {0, 0, 4096 * kFixedOne};
  }

  Model& model() { return model_; }
  Camera& camera() { return camera_; }

  /// In the given winding; `z` in steps of the grid, greater is nearer.
  Lattice& add(const Corners2& corners, Colour colour = kWhite, std::array<int, 3> z = {0, 0, 0}) {
    const auto first = static_cast<std::uint16_t>(model_.positions.size());
    for (std::size_t i = 0; i < 3; ++i) {
      const std::int64_t x = (corners[i].x - kView.width * 8) / step_;
      const std::int64_t y = (kView.height * 8 - corners[i].y) / step_;
      model_.positions.push_back(
          {static_cast<std::int16_t>(x), static_cast<std::int16_t>(y), static_cast<std::int16_t>(z[i])});
      model_.colours.push_back(colour);
    }
    model_.triangles.push_back({first, static_cast<std::uint16_t>(first + 1), static_cast<std::uint16_t>(first + 2)});
    return *this;
  }

  Picture draw(std::uint16_t strip_rows = kView.height) {
    Scene scene = model_.scene();
    scene.background = {0, 0, 0, 255};
    return picture::render(scene, camera_, kView, strip_rows);
  }

 private:
  int step_;
  Model model_;
  Camera camera_;
};

inline std::uint16_t pixel_at(const Picture& picture, int x, int y, int width = kView.width) {
  const auto i = static_cast<std::size_t>(2 * (y * width + x));
  return static_cast<std::uint16_t>(std::to_integer<unsigned>(picture.pixels[i]) |
                                    std::to_integer<unsigned>(picture.pixels[i + 1]) << 8);
}

/// Which pixels are not black.
inline std::vector<bool> mask_of(const Picture& picture) {
  std::vector<bool> mask(picture.pixels.size() / 2);
  for (std::size_t i = 0; i < mask.size(); ++i) {
    mask[i] = (picture.pixels[2 * i] | picture.pixels[2 * i + 1]) != std::byte{0};
  }
  return mask;
}

/// How often the oracle covers each pixel of kView; clockwise triangles count too unless `front_only`.
inline std::vector<int> exact_cover(const std::vector<Corners2>& triangles, bool front_only = false) {
  std::vector<int> cover(kPixels, 0);
  for (const Corners2& c : triangles) {
    const std::int64_t turn =
        (c[1].x - c[0].x) * (c[2].y - c[0].y) - (c[1].y - c[0].y) * (c[2].x - c[0].x);  // > 0: clockwise on the screen
    if (front_only && turn > 0) continue;
    const oracle::Triangle exact(c);
    for (int y = 0; y < kView.height; ++y) {
      for (int x = 0; x < kView.width; ++x) cover[static_cast<std::size_t>(y * kView.width + x)] += exact.covers(x, y);
    }
  }
  return cover;
}

inline std::string words(const std::vector<Corners2>& triangles) {
  std::ostringstream text;
  for (const Corners2& c : triangles) {
    for (const oracle::Point& p : c) text << '{' << p.x << ',' << p.y << "} ";
    text << "; ";
  }
  return text.str();
}

/// Draws them double-sided and compares with the oracle: which pixels, and how many fragments in all, so that a pixel
/// drawn twice shows. Empty if right, else the first difference in words.
inline std::string coverage_verdict(const std::vector<Corners2>& triangles, int step = 1, bool front_only = false) {
  Lattice lattice(step);
  lattice.model().material.double_sided = !front_only;
  for (const Corners2& corners : triangles) lattice.add(corners);
  const Picture picture = lattice.draw();
  if (!picture.status) return message(picture.status.error);
  const std::vector<bool> mask = mask_of(picture);
  const std::vector<int> exact = exact_cover(triangles, front_only);
  std::uint32_t fragments = 0;
  for (int i = 0; i < kPixels; ++i) {
    const auto pixel = static_cast<std::size_t>(i);
    fragments += static_cast<std::uint32_t>(exact[pixel]);
    if (mask[pixel] != (exact[pixel] > 0)) {
      return words(triangles) + "differ at " + std::to_string(i % kView.width) + "," + std::to_string(i / kView.width);
    }
  }
  if (fragments != picture.statistics.fragments) {
    return words(triangles) + "have " + std::to_string(picture.statistics.fragments) + " fragments, not " +
           std::to_string(fragments);
  }
  return {};
}

}  // namespace hard_cases
