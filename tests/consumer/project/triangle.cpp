// Draws a white triangle strip by strip with both renderers and counts its pixels.
#include <zstrip/renderer.hpp>

#include <array>
#include <cstdio>
#include <cstring>
#include <vector>

namespace {

// The half of the view below the diagonal, 64 x 64 pixels: an orthographic picture of a right triangle.
constexpr std::array<zstrip::Position, 3> kPositions{{{-32767, 32767, 0}, {-32767, -32767, 0}, {32767, -32767, 0}}};
constexpr std::array<zstrip::Triangle, 1> kTriangles{{{0, 1, 2}}};

constexpr zstrip::View kView{64, 64};

zstrip::Camera camera() {
  zstrip::Camera orthographic;
  orthographic.focal = zstrip::kFixedOne;
  orthographic.projection = zstrip::Projection::orthographic;
  return orthographic;
}

// The white pixels of the picture, or -1 after an error.
template <typename Renderer>
int white_pixels(Renderer& renderer, const zstrip::Scene& scene, const zstrip::Plan& plan) {
  std::vector<std::uint64_t> arena((plan.bytes() + 7) / 8);
  std::vector<std::uint16_t> pixels(plan.strip_pixel_bytes(kView) / 2);
  if (!renderer.begin_frame(scene, camera(), kView, plan, std::as_writable_bytes(std::span(arena)))) return -1;
  int white = 0;
  for (std::uint16_t strip = 0; strip < plan.strips; ++strip) {
    if (!renderer.draw_strip(strip, std::as_writable_bytes(std::span(pixels)))) return -1;
    for (const std::uint16_t pixel : pixels) white += pixel == 0xFFFF;
  }
  return white;
}

}  // namespace

int main() {
  zstrip::Mesh mesh;
  mesh.positions = kPositions;
  mesh.triangles = kTriangles;
  zstrip::Material material;
  material.lit = false;
  const zstrip::Instance instance;
  zstrip::Scene scene;
  scene.meshes = {&mesh, 1};
  scene.materials = {&material, 1};
  scene.instances = {&instance, 1};

  const zstrip::Effects effects = zstrip::effects_of(scene, camera());
  const auto [status, plan] = zstrip::plan(zstrip::count(scene), kView, effects, {.bytes = 0, .strip_rows = 8});
  if (!status) {
    std::fprintf(stderr, "plan: %s\n", zstrip::message(status.error));
    return 1;
  }
  zstrip::Renderer<zstrip::effect::orthographic> fixed;
  zstrip::AnyRenderer any(effects);
  const int by_fixed = white_pixels(fixed, scene, plan);
  const int by_any = white_pixels(any, scene, plan);
  std::printf("%d and %d white pixels in %d strips\n", by_fixed, by_any, plan.strips);

  // Of 64 x 64 pixel centres, 64 lie on the diagonal. It is a right edge: they belong to the other side.
  const bool right = by_fixed == 64 * 63 / 2 && by_any == by_fixed && plan.strips == 8;
  return right ? 0 : 1;
}
