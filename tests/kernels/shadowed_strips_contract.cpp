// A picture with a shadow, binned, strip by strip in order and backwards. In order a run may hand triangles on to the
// next strip; what it draws a second time, where the light does not reach, must hand on nothing.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "contracts.hpp"
#include "zstrip/renderer.hpp"

namespace zstrip::kernels_test {
namespace {

constexpr Effects kEffects = effect::lighting | effect::gouraud | effect::shadows | effect::bins;
constexpr std::uint16_t kShadowedSide = 96;

alignas(kArenaAlignment) std::array<std::byte, 160'000> arena;
std::array<std::byte, kShadowedSide * kShadowedSide * 2> in_order, backwards;

/// A rough square of +-1 that faces the viewer, of small triangles.
struct RoughSquare {
  static constexpr std::int32_t kCells = 32;
  std::array<Position, (kCells + 1) * (kCells + 1)> positions{};
  std::array<Normal, (kCells + 1) * (kCells + 1)> normals{};
  std::array<Triangle, 2 * kCells * kCells> triangles{};

  constexpr RoughSquare() {
    const auto place = [](std::int32_t column) { return static_cast<std::int16_t>((column * 2 - kCells) * 1023); };
    for (std::int32_t row = 0; row <= kCells; ++row) {
      for (std::int32_t column = 0; column <= kCells; ++column) {
        const auto index = static_cast<std::size_t>(row * (kCells + 1) + column);
        const std::int32_t height = (row * 7 + column * 13) % 5;
        positions[index] = {place(column), place(row), static_cast<std::int16_t>(height * 1000)};
        normals[index] = {static_cast<std::int8_t>(height * 20), 0, 120, 0};
      }
    }
    for (std::int32_t row = 0; row < kCells; ++row) {
      for (std::int32_t column = 0; column < kCells; ++column) {
        const auto corner = static_cast<std::uint16_t>(row * (kCells + 1) + column);
        const auto above = static_cast<std::uint16_t>(corner + kCells + 1);
        const auto right = static_cast<std::uint16_t>(corner + 1), across = static_cast<std::uint16_t>(above + 1);
        const auto index = static_cast<std::size_t>(2 * (row * kCells + column));
        triangles[index] = {corner, right, across};
        triangles[index + 1] = {corner, across, above};
      }
    }
  }
};
constexpr RoughSquare kSquare;

constexpr Transform moved(std::int32_t x, std::int32_t z) {
  Transform transform = Transform::identity();
  transform.m[0][3] = x, transform.m[2][3] = z;
  return transform;
}

}  // namespace

/// `cases` are heights of strips.
Outcome compare_shadowed_strips(std::uint32_t cases) {
  Mesh square{};
  square.positions = kSquare.positions, square.normals = kSquare.normals, square.triangles = kSquare.triangles;
  Mesh caster = square;
  caster.half_extent = {fixed(0.4), fixed(4), fixed(0.1)};
  caster.shadow = ShadowRole::only_casts;
  const Mesh meshes[] = {square, caster};
  const Material materials[] = {{.colour = {220, 220, 220, 255}}};
  // Shadows at both sides: the rectangle around them is as wide as the picture.
  const Instance instances[] = {
      {0, 0, moved(0, 0)}, {1, 0, moved(fixed(-0.9), fixed(0.9))}, {1, 0, moved(fixed(0.9), fixed(0.9))}};
  const DirectionalLight lights[] = {{0, 0, 32767, {200, 200, 200, 255}}};
  const Shadow shadow{.light = 0, .log2_size = 7};
  Scene scene{};
  scene.meshes = meshes, scene.materials = materials, scene.instances = instances, scene.lights = lights;
  scene.shadow = &shadow, scene.ambient = {40, 40, 40, 255};
  Camera camera{};
  camera.eye = {0, 0, fixed(1.2)};  // the square fills the picture
  const View view{kShadowedSide, kShadowedSide, PixelFormat::rgb565};

  Outcome outcome;
  for (std::uint32_t number = 0; number < cases; ++number) {
    const Budget budget{
        .bytes = arena.size(), .strip_rows = static_cast<std::uint16_t>(1 + number), .modes = Modes::binned};
    const PlanResult planned = zstrip::plan(count(scene), view, kEffects, budget);
    const Plan& plan = planned.plan;
    Renderer<kEffects> renderer;
    if (!planned.status || !renderer.begin_frame(scene, camera, view, plan, arena)) {
      outcome.differs("a plan", number);
      return outcome;
    }
    const auto draw = [&](std::uint16_t strip, std::span<std::byte> pixels) {
      const std::size_t begin = std::size_t{strip} * plan.strip_rows * kShadowedSide * 2;
      const std::size_t bytes = std::min<std::size_t>(plan.strip_pixel_bytes(view), pixels.size() - begin);
      return static_cast<bool>(renderer.draw_strip(strip, pixels.subspan(begin, bytes)));
    };
    for (std::uint16_t strip = 0; strip < plan.strips; ++strip) draw(strip, in_order);
    for (std::uint16_t strip = plan.strips; strip-- != 0;) draw(strip, backwards);
    if (in_order != backwards) {
      outcome.differs("a picture with a shadow", number);
      return outcome;
    }
    outcome.compared += 2 * plan.strips;
  }
  return outcome;
}

}  // namespace zstrip::kernels_test
