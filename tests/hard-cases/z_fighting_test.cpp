// Hard case D44: the smallest separation of two surfaces that the z-buffer sorts at every pixel.
//
// The probe: two parallel squares fill a picture of 64 x 64 pixels, 3.6 degrees wide, the farther one drawn first;
// every pixel must show the nearer one, so that a tie counts as wrong. It is repeated at 8 distances within 1 % of the
// nominal one, because constant depth may by luck round apart. The separation is measured along the viewing direction.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

#include "depth_picture.hpp"
#include "lattice.hpp"

namespace hard_cases {
namespace {

constexpr View kProbe{64, 64};
/// The same view on the pixels of a panel: corners are snapped to a quarter of the angle.
constexpr View kPanel{256, 256};

/// What else is in the scene, beside the picture: it sets the depth range.
struct DepthRange {
  const char* name;
  double near, far;
  Effects format{};
};
constexpr DepthRange kWhole{"z16 over 0.1..100", 0.1, 100};
constexpr DepthRange kFitted{"z16 fitted to 1..40", 1, 40};
constexpr DepthRange kFloat{"float over 0.1..100", 0.1, 100, effect::depth_float};
constexpr DepthRange kFittedFloat{"float fitted to 1..40", 1, 40, effect::depth_float};
constexpr DepthRange kWhole24{"z24 over 0.1..100", 0.1, 100, effect::depth_24};
constexpr DepthRange kFitted24{"z24 fitted to 1..40", 1, 40, effect::depth_24};

/// Of a code, in view units.
double code_size(const DepthRange& range, double distance) {
  const double one_over_w = distance * distance * (1 / range.near - 1 / range.far);
  switch (depth_format(range.format)) {
    case DepthFormat::z16: return one_over_w / 65533;
    case DepthFormat::z24: return one_over_w / 16777213;
    case DepthFormat::float16: {
      const double octave = std::max(0.0, 6 - std::floor(-std::log2(range.near / distance)));
      return distance * distance / range.near * std::exp2(octave - 20);
    }
  }
  return 0;
}

constexpr Fixed fixed(double value) { return static_cast<Fixed>(value * 65536 + 0.5); }

/// Share of the pixels that do not show the nearer square.
double wrong_pixels(const DepthRange& range, double distance, double tilt, double separation,
                    const View& view = kProbe) {
  // Steps of z fine enough for 1/1000 of the separation's size: both squares stay within the mesh.
  const Fixed depth = std::max<Fixed>(16, fixed(separation * 2));
  const auto half_step =
      static_cast<std::int16_t>(std::lround(separation / 2 / (depth / 65536.0 / 32768) * std::cos(tilt)));
  const auto behind = static_cast<std::int16_t>(-half_step);
  Model model;
  for (const std::int16_t z : {behind, half_step}) {
    for (const auto& [x, y] : {std::pair{-1, -1}, std::pair{1, -1}, std::pair{1, 1}, std::pair{-1, 1}}) {
      model.positions.push_back({static_cast<std::int16_t>(32767 * x), static_cast<std::int16_t>(32767 * y), z});
      model.colours.push_back(z == half_step ? Colour{255, 255, 255, 255} : Colour{255, 0, 0, 255});
    }
  }
  model.triangles = {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}};
  const Fixed size = fixed(distance / 20);
  model.mesh.half_extent = {size, size, depth};
  model.material = {.lit = false, .smooth = false};

  std::array<Instance, 3> instances;
  Transform& t = instances[0].transform;
  t.m[1][1] = t.m[2][2] = fixed(std::cos(tilt));
  t.m[2][1] = fixed(std::sin(tilt));
  t.m[1][2] = -t.m[2][1];
  t.m[2][3] = -fixed(distance);
  // As small as can be, far to the right.
  const double ends[2] = {range.near, range.far};
  for (std::size_t i = 0; i < 2; ++i) {
    Transform& end = instances[i + 1].transform;
    end = {};
    end.m[0][3] = fixed(ends[i] / 2);
    end.m[2][3] = -fixed(ends[i]);
  }
  Scene scene = model.scene();
  scene.instances = instances;
  Camera camera;
  camera.eye = {0, 0, 0};
  camera.focal = 32 * kFixedOne;
  camera.near_plane = fixed(0.05);
  camera.far_plane = 200 * kFixedOne;
  const picture::DepthPicture picture = picture::render_depth(scene, camera, view, range.format);
  EXPECT_TRUE(picture.status);
  int wrong = 0;
  const std::size_t pixels = std::size_t{view.width} * view.height;
  for (std::size_t i = 0; i < pixels; ++i) {
    wrong += picture.pixels[2 * i] != std::byte{0xFF} || picture.pixels[2 * i + 1] != std::byte{0xFF};
  }
  return wrong / static_cast<double>(pixels);
}

bool sorts(const DepthRange& range, double distance, double tilt, double separation, const View& view) {
  for (int i = 0; i < 8; ++i) {
    if (wrong_pixels(range, distance * (1 + i * 0.00125), tilt, separation, view) > 0) return false;
  }
  return true;
}

/// In steps of 5 %: the smallest above which all sort, up to ten times as much.
double smallest_separation(const DepthRange& range, double distance, double tilt, const View& view = kProbe) {
  double smallest = 0;
  // The size of a code at this distance is where to look; a slope is moved by the snapping of its corners to 1/16
  // pixel, 1/1024 of the distance each.
  const double code = code_size(range, distance), snapping = distance / 1024 / 16 * std::tan(tilt);
  constexpr double kFinest = 3e-8;  // four steps of the probe's own grid
  const double limit = std::max(code / 3, kFinest);
  const double start = code > snapping ? 10 * code : 10 * code + 4 * snapping + distance * 0x1p-24;
  for (double separation = start; separation > limit; separation /= 1.05) {
    if (!sorts(range, distance, tilt, separation, view)) break;
    smallest = separation;
  }
  return smallest;
}

double smallest_of_all_tilts(const DepthRange& range, double distance, const View& view = kProbe) {
  double worst = 0;
  for (const int degrees : {10, 20, 30, 45}) {
    worst = std::max(worst, smallest_separation(range, distance, degrees * M_PI / 180, view));
  }
  return worst;
}

TEST(HardCases, D44_SmallestSeparationThatSorts) {
  // docs/numerics.md shows this table.
  struct Row {
    double distance, whole, whole_tilted, fitted, fitted_tilted;
  };
  for (const Row& expected :
       {Row{1, 0.000154, 0.000239, 0.0000136, 0.0000270}, Row{3, 0.00139, 0.00177, 0.000117, 0.000181},
        Row{10, 0.0147, 0.0178, 0.00150, 0.00245}, Row{30, 0.139, 0.153, 0.0129, 0.0156}}) {
    const double d = expected.distance;
    const Row got{d, smallest_separation(kWhole, d, 0), smallest_of_all_tilts(kWhole, d),
                  smallest_separation(kFitted, d, 0), smallest_of_all_tilts(kFitted, d)};
    EXPECT_NEAR(got.whole, expected.whole, 0.03 * expected.whole);
    EXPECT_NEAR(got.whole_tilted, expected.whole_tilted, 0.03 * expected.whole_tilted);
    EXPECT_NEAR(got.fitted, expected.fitted, 0.03 * expected.fitted);
    EXPECT_NEAR(got.fitted_tilted, expected.fitted_tilted, 0.03 * expected.fitted_tilted);
    if (d >= 10) {
      EXPECT_GE(got.whole / got.fitted, 8);
      // Vertices are snapped to 1/16 pixel: on a slope this moves the depth, by more codes the finer they are.
      EXPECT_GE(got.whole_tilted / got.fitted_tilted, 7);
    }
  }
}

TEST(HardCases, D44_TheFitGainsEightTimesOnThePixelsOfAPanel) {
  for (const double distance : {10.0, 30.0}) {
    EXPECT_GE(smallest_separation(kWhole, distance, 0, kPanel) / smallest_separation(kFitted, distance, 0, kPanel), 8)
        << "facing, at " << distance;
    EXPECT_GE(smallest_of_all_tilts(kWhole, distance, kPanel) / smallest_of_all_tilts(kFitted, distance, kPanel), 8)
        << "tilted, at " << distance;
  }
}

TEST(HardCases, D44_SmallestSeparationOfEveryFormat) {
  // docs/numerics.md shows this table: facing and tilted, at 1, 3, 10 and 30.
  struct Row {
    const DepthRange& range;
    double expected[4][2];
  };
  const Row rows[] = {
      {kFloat, {{7.7e-05, 0.000103}, {0.000299, 0.000421}, {0.000963, 0.00111}, {0.00786, 0.01}}},
      {kFittedFloat, {{6.16e-05, 7.49e-05}, {0.000228, 0.000337}, {0.000665, 0.00103}, {0.0033, 0.00421}}},
      {kWhole24, {{6.01e-07, 1.29e-06}, {4.45e-06, 1.13e-05}, {6.01e-05, 8.01e-05}, {0.000424, 0.000758}}},
      {kFitted24, {{3.78e-08, 1.4e-07}, {3.09e-07, 1.18e-06}, {5.87e-06, 1.29e-05}, {5.28e-05, 0.000107}}}};
  constexpr double kDistances[] = {1, 3, 10, 30};
  // The probe cannot place its squares finer than 3e-8.
  const auto tolerance = [](double expected) { return std::max(0.05 * expected, 3.1e-8); };
  for (const Row& row : rows) {
    for (std::size_t i = 0; i < 4; ++i) {
      const double facing = smallest_separation(row.range, kDistances[i], 0);
      const double tilted = smallest_of_all_tilts(row.range, kDistances[i]);
      EXPECT_NEAR(facing, row.expected[i][0], tolerance(row.expected[i][0]))
          << row.range.name << " at " << kDistances[i];
      EXPECT_NEAR(tilted, row.expected[i][1], tolerance(row.expected[i][1]))
          << row.range.name << " at " << kDistances[i];
    }
  }
}

// The share of wrong pixels: distance 1 to 30 to the right, separation 0.00001 to 1 upwards, both logarithmic; a panel
// for each format, above over 0.1..100, below fitted to 1..40. Black is none, white all. ZSTRIP_PICTURES=FOLDER keeps
// it.
TEST(HardCases, D44_PictureIsThatOfThePage) {
  constexpr int kSide = 100, kGap = 8;
  const DepthRange* const panels[2][3] = {{&kWhole, &kFloat, &kWhole24}, {&kFitted, &kFittedFloat, &kFitted24}};
  const int width = 3 * (kSide + kGap) - kGap, height = 2 * kSide + kGap;
  std::string greys;
  for (int row = 0; row < height; ++row) {
    const int y = kSide - 1 - row % (kSide + kGap);
    const double separation = std::pow(10.0, -5 + 5.0 * y / (kSide - 1));
    for (int column = 0; column < width; ++column) {
      const int x = column % (kSide + kGap);
      const double distance = std::pow(30.0, static_cast<double>(x) / (kSide - 1));
      // Grey: between the panels, and where the nearer square would be another one's size.
      if (x >= kSide || y < 0 || separation > distance / 15) {
        greys.push_back(static_cast<char>(128));
        continue;
      }
      const DepthRange& range = *panels[row / (kSide + kGap)][column / (kSide + kGap)];
      greys.push_back(
          static_cast<char>(static_cast<std::uint8_t>(255 * wrong_pixels(range, distance, 0.5, separation))));
    }
  }
  // FNV-1a of the pixels of docs/images/z_fighting.png.
  std::uint32_t checksum = 2166136261;
  for (const char grey : greys) checksum = (checksum ^ static_cast<std::uint8_t>(grey)) * 16777619;
  EXPECT_EQ(checksum, 2315938951U);
  if (const char* const folder = std::getenv("ZSTRIP_PICTURES")) {
    std::ofstream file(std::string(folder) + "/z_fighting.pgm", std::ios::binary);
    file << "P5\n" << width << ' ' << height << "\n255\n" << greys;
    EXPECT_TRUE(file.flush());
  }
}

}  // namespace
}  // namespace hard_cases
