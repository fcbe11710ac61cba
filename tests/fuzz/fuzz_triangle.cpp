// One or two triangles through the whole renderer. Where vertices land exactly, coverage is the oracle's; where the
// near plane, the far plane or the guard band cuts them, strips agree with the whole picture. Always: two triangles
// that share an edge never cover the same pixel, and leave no hole between them.
#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "input.hpp"
#include "picture.hpp"
#include "require.hpp"
#include "triangle_oracle.hpp"
#include "zstrip/base/math.hpp"
#include "zstrip/scene/validate.hpp"

namespace {

using namespace zstrip;

/// The quadrilateral a, b, c, d cut along the diagonal b-c into a, b, c and c, b, d: both counter-clockwise where the
/// quadrilateral is.
constexpr std::array<Triangle, 2> kHalves{{{0, 1, 2}, {2, 1, 3}}};

/// White on black, unlit: what is covered is white.
class Quadrilateral {
 public:
  Quadrilateral(const std::array<Position, 4>& positions, const Mesh& box, const Transform& transform,
                const Material& material)
      : positions_(positions), mesh_(box), material_(material), instance_{0, 0, transform} {
    mesh_.positions = positions_;
    scene_.meshes = {&mesh_, 1};
    scene_.materials = {&material_, 1};
    scene_.instances = {&instance_, 1};
  }
  Quadrilateral(const Quadrilateral&) = delete;
  Quadrilateral& operator=(const Quadrilateral&) = delete;

  const Scene& with(std::span<const Triangle> triangles) {
    mesh_.triangles = triangles;
    return scene_;
  }

 private:
  std::array<Position, 4> positions_;
  Mesh mesh_;
  Material material_;
  Instance instance_;
  Scene scene_;
};

struct Shot {
  Camera camera;
  View view;
  fuzz::Request request;

  /// 1 for each covered pixel. Drawn whole and in the strips of `request`, with the same pixels both times; empty if
  /// the renderer refuses the scene.
  std::optional<std::vector<std::uint8_t>> coverage(const Scene& scene) const {
    const Effects effects = effects_of(scene, camera);
    const fuzz::Picture whole = fuzz::draw(scene, camera, view, {.effects = effects, .budget = {}});
    fuzz::Request other = request;
    other.effects = effects;
    const fuzz::Picture strips = fuzz::draw(scene, camera, view, other);
    fuzz::require(whole.status == strips.status, "strips change no status");
    fuzz::require(whole.pixels == strips.pixels, "strips change no pixel");
    if (!whole.status) return std::nullopt;
    std::vector<std::uint8_t> covered(whole.pixels.size() / 2);
    for (std::size_t i = 0; i < covered.size(); ++i) covered[i] = whole.pixels[2 * i] != std::byte{0} ? 1 : 0;
    return covered;
  }
};

/// Each half alone and both together.
struct Coverage {
  std::vector<std::uint8_t> first, second, both;
};

std::optional<Coverage> coverage_of_halves(const Shot& shot, Quadrilateral& quadrilateral) {
  const std::span<const Triangle> halves(kHalves);
  auto first = shot.coverage(quadrilateral.with(halves.first(1)));
  auto second = shot.coverage(quadrilateral.with(halves.last(1)));
  auto both = shot.coverage(quadrilateral.with(halves));
  fuzz::require(first.has_value() == both.has_value() && second.has_value() == both.has_value(),
                "what is refused does not depend on the triangles");
  if (!both) return std::nullopt;
  return Coverage{std::move(*first), std::move(*second), std::move(*both)};
}

void require_union(const Coverage& coverage, const View& view) {
  for (std::size_t i = 0; i < coverage.both.size(); ++i) {
    fuzz::require(coverage.both[i] == (coverage.first[i] | coverage.second[i]),
                  "two triangles cover what each of them covers: pixel %zu,%zu", i % view.width, i / view.width);
  }
}

void require_no_overlap(const Coverage& coverage, const View& view) {
  for (std::size_t i = 0; i < coverage.both.size(); ++i) {
    fuzz::require((coverage.first[i] & coverage.second[i]) == 0, "a shared edge is drawn once: pixel %zu,%zu twice",
                  i % view.width, i / view.width);
  }
}

/// A convex shape, or one that snapping made concave by less than a sub-pixel, has no uncovered pixel between four
/// covered neighbours.
void require_no_hole(const std::vector<std::uint8_t>& covered, const View& view) {
  const std::size_t width = view.width;
  for (std::size_t y = 1; y + 1 < view.height; ++y) {
    for (std::size_t x = 1; x + 1 < width; ++x) {
      const std::size_t i = y * width + x;
      fuzz::require(covered[i] || !covered[i - 1] || !covered[i + 1] || !covered[i - width] || !covered[i + width],
                    "no hole along a shared edge: pixel %zu,%zu", x, y);
    }
  }
}

/// Twice the signed area in the plane of the mesh, y up.
std::int64_t turn(const Position& a, const Position& b, const Position& c) {
  return std::int64_t{b.x - a.x} * (c.y - a.y) - std::int64_t{b.y - a.y} * (c.x - a.x);
}

bool is_convex(const std::array<Position, 4>& p) {
  // Around the outside: a, b, d, c.
  return turn(p[0], p[1], p[3]) > 0 && turn(p[1], p[3], p[2]) > 0 && turn(p[3], p[2], p[0]) > 0 &&
         turn(p[2], p[0], p[1]) > 0;
}

std::array<Position, 4> read_positions(fuzz::Input& input, bool flat) {
  std::array<Position, 4> positions{};
  const auto coordinate = [&] {
    const auto value = input.any<std::int16_t>();
    return value == INT16_MIN ? std::int16_t{-INT16_MAX} : value;
  };
  for (Position& p : positions) p = {coordinate(), coordinate(), flat ? std::int16_t{0} : coordinate()};
  return positions;
}

Shot read_shot(fuzz::Input& input) {
  Shot shot{};
  shot.view = {static_cast<std::uint16_t>(32 - input.below(32)), static_cast<std::uint16_t>(32 - input.below(32)),
               PixelFormat::rgb565};
  shot.request.budget.strip_rows = static_cast<std::uint16_t>(1 + input.below(shot.view.height));
  shot.request.garbage = input.any<std::uint8_t>();
  return shot;
}

/// Orthographic, looking straight at the mesh. `magnification` and the box are powers of two, so that a vertex lies at
/// exactly p * height * 2^magnification / 4096 sixteenths of a pixel from the picture's centre and snaps to the
/// nearest.
void judge_by_oracle(fuzz::Input& input) {
  Shot shot = read_shot(input);
  const int magnification = input.between(-6, 9);
  const auto box = static_cast<int>(input.below(12));  // half extent 2^box
  shot.camera.projection = Projection::orthographic;
  const int focal = std::max(magnification - box, -kFixedBits);  // 2^focal; rounded up where 16.16 ends
  shot.camera.focal = focal >= 0 ? kFixedOne << focal : kFixedOne >> -focal;
  const int exponent = focal + box;
  shot.camera.near_plane = kFixedOne;
  shot.camera.far_plane = 8192 * kFixedOne;
  shot.camera.eye = {0, 0, 4096 * kFixedOne};

  const std::array<Position, 4> positions = read_positions(input, false);
  Mesh mesh;
  mesh.half_extent = {kFixedOne << box, kFixedOne << box, kFixedOne << input.below(12)};
  Material material;
  material.lit = false;
  material.double_sided = input.flag();
  Quadrilateral quadrilateral(positions, mesh, Transform::identity(), material);
  const auto coverage = coverage_of_halves(shot, quadrilateral);
  if (!coverage) return;
  require_union(*coverage, shot.view);

  // p * height * 2^exponent / 4096, rounded to nearest, halves up, from the upper left corner of the picture.
  const auto snapped = [&](std::int64_t p, std::int64_t size) {
    const std::int64_t scaled = p * shot.view.height * (std::int64_t{1} << (exponent + 16));
    return 8 * size + ((scaled + (std::int64_t{1} << 27)) >> 28);
  };
  std::array<oracle::Point, 4> points{};
  for (std::size_t i = 0; i < 4; ++i) {
    points[i] = {snapped(positions[i].x, shot.view.width), snapped(-positions[i].y, shot.view.height)};
  }
  bool fronts = true;
  for (const Triangle& t : kHalves) {
    const std::array<oracle::Point, 3> corners{points[t.a], points[t.b], points[t.c]};
    const std::int64_t area = (corners[2].x - corners[0].x) * (corners[1].y - corners[0].y) -
                              (corners[1].x - corners[0].x) * (corners[2].y - corners[0].y);
    const bool drawn = area > 0 || (area < 0 && material.double_sided);
    fronts = fronts && area > 0;
    const oracle::Triangle exact(corners);
    const std::vector<std::uint8_t>& covered = t.a == 0 ? coverage->first : coverage->second;
    for (std::size_t i = 0; i < covered.size(); ++i) {
      const auto x = static_cast<std::int64_t>(i % shot.view.width);
      const auto y = static_cast<std::int64_t>(i / shot.view.width);
      fuzz::require((covered[i] != 0) == (drawn && exact.covers(x, y)),
                    "coverage is the oracle's: pixel %lld,%lld of {%lld,%lld} {%lld,%lld} {%lld,%lld}",
                    static_cast<long long>(x), static_cast<long long>(y), static_cast<long long>(corners[0].x),
                    static_cast<long long>(corners[0].y), static_cast<long long>(corners[1].x),
                    static_cast<long long>(corners[1].y), static_cast<long long>(corners[2].x),
                    static_cast<long long>(corners[2].y));
    }
  }
  if (fronts) require_no_overlap(*coverage, shot.view);
}

/// Any camera close to or inside a quadrilateral of any size, so that every plane cuts.
void judge_clipping(fuzz::Input& input) {
  Shot shot = read_shot(input);
  shot.camera.projection = input.flag() ? Projection::orthographic : Projection::perspective;
  const Vec3 eye{input.any<std::int16_t>() * 4, input.any<std::int16_t>() * 4, input.any<std::int16_t>() * 4};
  const Vec3 target{input.any<std::int16_t>() * 4, input.any<std::int16_t>() * 4, 0};
  if (!look_at(shot.camera, eye, target, {0, kFixedOne, 0})) return;
  shot.camera.focal = std::max(1, input.number(shot.camera.focal));
  shot.camera.near_plane = std::clamp(input.number(shot.camera.near_plane), 1, 0x7FFFFFFE);
  shot.camera.far_plane = std::max(input.number(shot.camera.far_plane), shot.camera.near_plane + 1);

  const std::array<Position, 4> positions = read_positions(input, true);
  Mesh mesh;
  const Fixed half = std::clamp(input.number(2 * kFixedOne), 1, detail::kMaxMeshLength);
  mesh.half_extent = {half, half, 0};
  Material material;
  material.lit = false;
  Quadrilateral quadrilateral(positions, mesh, Transform::identity(), material);
  const auto coverage = coverage_of_halves(shot, quadrilateral);
  if (!coverage) return;
  require_union(*coverage, shot.view);
  if (!is_convex(positions)) return;
  require_no_overlap(*coverage, shot.view);
  require_no_hole(coverage->both, shot.view);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Input input(data, size);
  if (input.flag()) {
    judge_clipping(input);
  } else {
    judge_by_oracle(input);
  }
  return 0;
}
