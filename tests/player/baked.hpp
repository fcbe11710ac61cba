// Scenes that `zstrip bake` has written for these tests, and pictures that a renderer draws of them without a player.
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "zstrip/base/crc32.hpp"
#include "zstrip/blob.hpp"
#include "zstrip/renderer.hpp"
#include "zstrip_hal/framebuffer.hpp"
#include "zstrip_player/any_player.hpp"

namespace zstrip::test {

inline constexpr const char* kScenes[] = {"teapot_meshlets", "fog",   "overlay", "csg",
                                          "lines",           "robot", "room",    "levels"};

/// What `teapot_meshlets` calls for.
inline constexpr Effects kTeapot = effect::lighting | effect::gouraud | effect::shade_gouraud;

/// Bytes at an address that is a multiple of 8, so many beyond it.
class Memory {
 public:
  explicit Memory(std::size_t size, std::size_t beyond = 0) : words_(size / 8 + 3), size_(size), beyond_(beyond) {}
  std::span<std::byte> span() { return std::as_writable_bytes(std::span(words_)).subspan(beyond_, size_); }

 private:
  std::vector<std::uint64_t> words_;
  std::size_t size_, beyond_;
};

struct Blob {
  Memory memory;
  explicit Blob(std::size_t size) : memory(size) {}
  const void* data() { return memory.span().data(); }
  std::size_t size() { return memory.span().size(); }
};

inline Blob blob_of(const std::string& scene) {
  std::ifstream file(std::string(PLAYER_SCENES) + "/" + scene + ".zsc", std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  EXPECT_FALSE(bytes.empty()) << scene;
  Blob blob(bytes.size());
  std::ranges::copy(std::as_bytes(std::span(bytes)), blob.memory.span().begin());
  return blob;
}

/// A framebuffer with its memory.
struct Screen {
  std::vector<std::byte> pixels;
  hal::Framebuffer display;
  Screen(std::uint16_t width, std::uint16_t height, hal::DisplayFormat format)
      : pixels(height * hal::bytes_per_row(width, format)), display(pixels, {width, height, format}) {}
};

/// How a picture differs from that of the blob at rest.
struct Wanted {
  std::uint32_t time = 0;
  std::optional<Camera> camera{};  ///< instead of the fitted one
  const Overlay* overlay = nullptr;
};

/// The picture, by AnyRenderer in a single strip.
inline std::vector<std::byte> drawn_directly(Blob& blob, const Screen& screen, const Wanted& wanted = {}) {
  SceneBlob opened;
  Memory tables(1 << 20);
  EXPECT_TRUE(open_scene_blob(blob.memory.span(), tables.span(), opened));
  View view{screen.display.width(), screen.display.height(), static_cast<PixelFormat>(screen.display.format()),
            opened.view.dither, opened.view.samples};
  if (wanted.overlay != nullptr) opened.scene.overlay = wanted.overlay;
  const Camera camera = wanted.camera ? *wanted.camera : scenes::fit_width(opened.camera_for(2), opened.view, view);
  const Effects effects = effects_of(opened.scene, camera) | effects_of(view) | opened.effects;
  const PlanResult planned = plan(count(opened.scene), view, effects, {.strip_rows = view.height});
  EXPECT_TRUE(planned.status);
  std::vector<Instance> instances(opened.scene.instances.size());
  std::vector<LineSet> lines(opened.scene.lines.size());
  scenes::BakedFrame staged{opened.scene, camera};
  const bool animated = !opened.animation.tracks.empty();
  if (animated || wanted.time != 0) {
    staged = scenes::stage({opened.scene, camera, opened.animation, opened.turn}, wanted.time,
                           animated ? opened.animation.duration : Player::kTurnTime,
                           {.instances = instances, .lines = lines});
  }
  scenes::choose_levels(opened.levels, opened.scene, instances, staged);
  AnyRenderer renderer(effects);
  Memory arena(planned.plan.bytes());
  Memory pixels(planned.plan.strip_pixel_bytes(view));
  EXPECT_TRUE(renderer.begin_frame(staged.scene, staged.camera, view, planned.plan, arena.span()));
  EXPECT_TRUE(renderer.draw_strip(0, pixels.span()));
  return {pixels.span().begin(), pixels.span().end()};
}

}  // namespace zstrip::test
