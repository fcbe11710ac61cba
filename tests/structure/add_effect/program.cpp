// Draws a triangle and its negative in strips, by a renderer of each scene's own effects and by one of both.
// Exit status: 0, or what is wrong.
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "zstrip/zstrip.hpp"

using namespace zstrip;

namespace {

constexpr Position kPositions[]{{-12000, -12000, 0}, {12000, -12000, 0}, {0, 12000, 0}};
constexpr Triangle kTriangles[]{{0, 1, 2}};
constexpr Mesh kMeshes[]{{.positions = kPositions, .triangles = kTriangles}};
constexpr Material kMaterials[]{{.colour = {250, 120, 10, 255}, .lit = false}};
constexpr Instance kInstances[]{{}};
constexpr View kView{32, 24};
constexpr Camera kCamera{};

constexpr Colour kWhite{255, 255, 255, 255};

constexpr Scene scene(bool negative) {
  return {.meshes = kMeshes,
          .materials = kMaterials,
          .textures = {},
          .instances = kInstances,
          .lights = {},
          .negative = negative ? &kWhite : nullptr};
}
constexpr Effects effects(bool negative) { return effects_of(scene(negative), kCamera); }
constexpr PlanResult planned(bool negative) {
  return plan(count(scene(negative)), kView, effects(negative), {.strip_rows = 8});
}

static_assert(effects(true) == (effects(false) | effect::negative));
static_assert(planned(true).plan.bytes() > planned(false).plan.bytes());
static_assert(planned(false).plan.effect_bytes == 0);
static_assert(effects_agree(effects(true)) && !methods_agree(effects(true) | method::painter));
static_assert([] {
  for (const EffectName& each : kEffectNames) {
    if (each.effect == effect::negative) return std::string_view(each.name) == "negative";
  }
  return false;
}());

using Picture = std::array<std::uint16_t, std::size_t{kView.width} * kView.height>;

template <Effects with>
bool draw(bool negative, Picture& picture) {
  static Renderer<with> renderer;
  alignas(kArenaAlignment) static std::array<std::byte, planned(true).plan.bytes()> arena;
  const Scene drawn = scene(negative);
  const Plan plan = planned(negative).plan;
  if (!renderer.begin_frame(drawn, kCamera, kView, plan, arena)) return false;
  for (std::uint16_t strip = 0; strip < plan.strips; ++strip) {
    const std::size_t first = static_cast<std::size_t>(plan.strip_area(strip, kView).top) * kView.width;
    if (!renderer.draw_strip(strip, std::as_writable_bytes(std::span(picture).subspan(first)))) return false;
  }
  return true;
}

}  // namespace

int main() {
  Picture plain{}, same{}, negative{};
  if (!draw<effects(false)>(false, plain) || !draw<effects(true)>(false, same) ||
      !draw<effects(true)>(true, negative)) {
    return 1;
  }
  if (plain != same) return 2;
  if (plain[0] == plain[kView.width * kView.height / 2 + kView.width / 2]) return 3;
  for (std::size_t i = 0; i < plain.size(); ++i) {
    if (plain[i] != (negative[i] ^ 0xFFFF)) return 4;
  }
}
