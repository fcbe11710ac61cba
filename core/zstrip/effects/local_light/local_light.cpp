// Computes local light's constants of a frame and an instance, once each, in 64 bits; see local_light.hpp.
#include "zstrip/effects/local_light/local_light.hpp"

namespace zstrip::detail {
namespace {

/// The largest distance, 17.15: 16384 units, so that differences between a light and a vertex fit. Farther surfaces are
/// lit as if they were at this distance.
constexpr std::int64_t kFarthest = std::int64_t{1} << 29;

constexpr std::int32_t clamped(std::int64_t value, std::int64_t limit) {
  return static_cast<std::int32_t>(std::clamp(value, -limit, limit));
}

/// Converts 16.16 relative to the eye to 17.15.
constexpr std::int32_t relative(Fixed coordinate, Fixed eye) {
  return clamped((std::int64_t{coordinate} - eye) >> 1, kFarthest);
}

}  // namespace

FrameLights frame_lights(const Scene& scene, const Camera& camera) {
  FrameLights frame{};
  frame.back = {camera.back.x >> 16, camera.back.y >> 16, camera.back.z >> 16};
  for (const PunctualLight& light : scene.punctual_lights) {
    if (frame.count == kMaxPunctualLights) break;
    WorldLight& world = frame.lights[frame.count++];
    world.position = {relative(light.position.x, camera.eye.x), relative(light.position.y, camera.eye.y),
                      relative(light.position.z, camera.eye.z)};
    const auto opposite = [](std::int16_t c) { return (1 - c) >> 1; };  // 1.14, to nearest
    world.towards = {opposite(light.x), opposite(light.y), opposite(light.z)};
    world.range = light.range >> 1;
    if (light.range > 0 && world.range == 0) world.range = 1;
    world.intensity = light.intensity > 0 ? static_cast<std::uint32_t>(light.intensity) : 0;
    world.colour = light.colour;
    if (light.type == PunctualLightType::spot) {
      world.outer = (INT16_MAX - light.cosine_outer) * (1 << 13);
      const std::int32_t between = light.cosine_inner - light.cosine_outer;  // 1.15
      world.cone = (1U << 29) / static_cast<std::uint32_t>(std::max<std::int32_t>(between, 1));
    }
  }
  return frame;
}

InstanceShading instance_shading(const Mesh& mesh, const Transform& transform, const Camera& camera) {
  const Fixed half[3] = {mesh.half_extent.x, mesh.half_extent.y, mesh.half_extent.z};
  const Fixed centre[3] = {mesh.centre.x, mesh.centre.y, mesh.centre.z};
  const Fixed eye[3] = {camera.eye.x, camera.eye.y, camera.eye.z};
  InstanceShading shading{};
  LinearForm* const forms[3] = {&shading.x, &shading.y, &shading.z};
  std::int64_t largest = 1;
  for (const auto& row : transform.m) {
    for (int k = 0; k < 3; ++k) largest = std::max<std::int64_t>(largest, row[k] < 0 ? -std::int64_t{row[k]} : row[k]);
  }
  for (int row = 0; row < 3; ++row) {
    const auto& m = transform.m[row];
    std::int32_t coefficient[3];
    std::int64_t offset = (std::int64_t{m[3]} - eye[row]) * (1 << 15);  // 17.31
    for (int k = 0; k < 3; ++k) {
      // 9.16 x 13.16 of the half extent, over 32768 grid steps, as LinearForm needs it: value 2^15 = p m h 2^-32.
      coefficient[k] = clamped((std::int64_t{m[k]} * half[k]) >> 16, kFarthest);
      offset += (std::int64_t{m[k]} * centre[k]) >> 1;
      // Normalised, so that the scale does not change the brightness: only directions matter.
      shading.normal[row][k] = static_cast<std::int16_t>(std::int64_t{m[k]} * (1 << 14) / largest);
    }
    *forms[row] = {coefficient[0], coefficient[1], coefficient[2], clamped(offset >> 16, kFarthest)};
  }
  return shading;
}

}  // namespace zstrip::detail
