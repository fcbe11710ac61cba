// Renders expectations with AnyRenderer.
#include "host_render.hpp"

#include <zlib.h>

#include <algorithm>
#include <stdexcept>
#include <utility>
#include <vector>

#include "../oracle/draw.hpp"
#include "zstrip_scenes/scenes.hpp"
#include "zstrip_scenes/showroom.hpp"

namespace zstrip::boards {
namespace {

void check(const Status& status) {
  if (!status) throw std::runtime_error(std::string("host rendering: ") + message(status.error));
}

const scenes::BuiltIn& built_in(const std::string& name) {
  const scenes::BuiltIn* found = scenes::find(name);
  if (found == nullptr) throw std::runtime_error("there is no built-in scene " + name);
  return *found;
}

/// The bytes of all strips in order, without those that a lower last strip leaves over.
std::vector<std::byte> render(const Scene& scene, const Camera& camera, const View& view, std::uint16_t rows,
                              Effects extra = {}) {
  picture::Picture drawn = picture::draw(effects_of(scene, camera) | extra, scene, camera, view, {.strip_rows = rows});
  check(drawn.status);
  return std::move(drawn.pixels);
}

std::uint32_t crc32_of(const std::vector<std::byte>& picture) {
  return static_cast<std::uint32_t>(
      crc32_z(crc32_z(0, nullptr, 0), reinterpret_cast<const Bytef*>(picture.data()), picture.size()));
}

}  // namespace

GreyPicture render_turntable_gray4(const std::string& scene, std::uint32_t frame, std::uint32_t frames,
                                   std::uint16_t width, std::uint16_t height) {
  const View view{width, height, PixelFormat::gray4};
  scenes::Staged staged;
  stage(built_in(scene), staged, frame, frames, view);
  return unpack_gray4(render(staged.scene, staged.camera, view, height), width, height);
}

std::vector<std::uint16_t> render_turntable_rgb565(const std::string& scene, std::uint32_t frame, std::uint32_t frames,
                                                   std::uint16_t width, std::uint16_t height, const Quality& preset) {
  const View view{width, height, PixelFormat::rgb565_swapped};
  scenes::Staged staged;
  stage(built_in(scene), staged, frame, frames, view);
  const std::vector<std::byte> bytes = render(staged.scene, staged.camera, view, height, preset.effects);
  std::vector<std::uint16_t> pixels;
  for (std::size_t at = 0; at < bytes.size(); at += 2) {
    pixels.push_back(static_cast<std::uint16_t>(std::to_integer<unsigned>(bytes[at]) << 8 |
                                                std::to_integer<unsigned>(bytes[at + 1])));
  }
  return pixels;
}

GreyPicture render_showroom_gray4(std::uint32_t frame, std::uint32_t frames, std::uint16_t width,
                                  std::uint16_t height) {
  std::vector<Instance> instances(std::begin(scenes::kRoomInstances), std::end(scenes::kRoomInstances));
  instances.push_back(scenes::showroom_teapot(frame, frames));
  const View view{width, height, PixelFormat::gray4};
  return unpack_gray4(render(scenes::showroom_scene(instances), scenes::kShowroomCamera, view, height), width, height);
}

std::uint32_t workload_crc32(const std::string& scene, std::uint32_t frame, std::uint16_t width, std::uint16_t height,
                             std::uint16_t rows) {
  scenes::Staged staged;
  stage_workload(built_in(scene), staged, frame);
  return crc32_of(render(staged.scene, staged.camera, {width, height, PixelFormat::rgb565}, rows));
}

std::uint32_t turntable_crc32(const std::string& scene, std::uint32_t frame, std::uint32_t frames, std::uint16_t width,
                              std::uint16_t height) {
  const View view{width, height, PixelFormat::rgb565_swapped};
  scenes::Staged staged;
  stage(built_in(scene), staged, frame, frames, view);
  return crc32_of(render(staged.scene, staged.camera, view, height));
}

}  // namespace zstrip::boards
