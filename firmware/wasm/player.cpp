// Draws a baked scene (.zsc) in WebAssembly, for a page or Node.js: one scene for each instance of the module.
// zstrip.mjs is the interface: it calls the functions in order, and knows only addresses of memory.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <new>
#include <span>

#include "zstrip/blob.hpp"
#include "zstrip/frame/pipeline_rows.hpp"
#include "zstrip/plan.hpp"
#include "zstrip/renderer.hpp"
#include "zstrip_scenes/baked_stage.hpp"

extern "C" std::byte __heap_base;  // set by the linker: free memory begins here

namespace zstrip {

/// Leaves out the faster pipelines for scenes with few effects: the pipelines with all effects draw the same pixels,
/// and a page has less to load.
std::span<const detail::PipelineRow> detail::rows_of_triangles() { return {}; }

namespace {

constexpr std::size_t kPage = 65536;
constexpr std::size_t kAlignment = 8;

std::byte* next_free = &__heap_base;

/// Reserves memory for the life of the instance, in whole words of 8 bytes; nullptr if there is none.
std::byte* reserve(std::size_t bytes) {
  const std::size_t first = (reinterpret_cast<std::size_t>(next_free) + kAlignment - 1) / kAlignment * kAlignment;
  const std::size_t have = __builtin_wasm_memory_size(0) * kPage;
  if (bytes > SIZE_MAX - kPage - first) return nullptr;
  if (first + bytes > have) {
    const std::size_t pages = (first + bytes - have + kPage - 1) / kPage;
    if (__builtin_wasm_memory_grow(0, pages) == SIZE_MAX) return nullptr;
  }
  next_free = reinterpret_cast<std::byte*>(first + bytes);
  return reinterpret_cast<std::byte*>(first);
}

/// Returns room for `count` objects; empty if there is none.
template <class T>
std::span<T> room_for(std::size_t count) {
  if (count > SIZE_MAX / sizeof(T)) return {};
  auto* first = reinterpret_cast<T*>(reserve(count * sizeof(T)));
  return first == nullptr ? std::span<T>() : std::span(first, count);
}

SceneBlob blob;
PlayedClips played;            // of blob.clips
std::uint32_t event_from = 0;  // for next_event
View view;
Plan planned;
Camera camera;
std::uint32_t frames = 1;
scenes::BakedFrame staged;  // read until its last strip is drawn
std::span<Instance> instances;
std::span<LineSet> lines;
std::span<std::byte> arena, strip_pixels;
std::span<std::uint8_t> picture;  // red, green, blue, alpha
AnyRenderer* renderer = nullptr;
alignas(AnyRenderer) std::byte renderer_memory[sizeof(AnyRenderer)];

/// Converts a pixel of RGB565 to the colour that panels show.
void put_pixel(std::uint8_t* to, unsigned pixel) {
  const unsigned red = pixel >> 11, green = pixel >> 5 & 63U, blue = pixel & 31U;
  to[0] = static_cast<std::uint8_t>(red << 3 | red >> 2);
  to[1] = static_cast<std::uint8_t>(green << 2 | green >> 4);
  to[2] = static_cast<std::uint8_t>(blue << 3 | blue >> 2);
  to[3] = 255;
}

/// Begins a frame of the clips that play.
Status begin_clips(std::span<const PlayedClip> clips) {
  pose_clips(blob.clips, clips, blob.scene.instances, instances);
  if (const Status posed = pose_clips(blob, clips); !posed) return posed;
  staged = {blob.scene, camera};
  staged.scene.instances = instances;
  scenes::choose_levels(blob.levels, blob.scene, instances, staged);
  return renderer->begin_frame(staged.scene, staged.camera, view, planned, arena);
}

Status begin(std::uint32_t frame) {
  if (!blob.clips.empty()) {
    PlayedClip at = played.last();
    at.time = time_of_frame(blob.clips[at.clip].instances, frame, frames);
    return begin_clips({&at, 1});
  }
  if (const Status posed = pose_clips(blob, {}); !posed) return posed;
  const scenes::AtRest baked{blob.scene, camera, blob.animation, blob.turn};
  staged = {blob.scene, camera};
  if (frame % frames != 0 || !blob.animation.tracks.empty()) {
    staged = scenes::move(baked, frame, frames, {.instances = instances, .lines = lines});
  }
  scenes::choose_levels(blob.levels, blob.scene, instances, staged);
  return renderer->begin_frame(staged.scene, staged.camera, view, planned, arena);
}

/// Draws the frame that has begun into `picture`.
Status draw_begun() {
  Status status;
  for (std::uint16_t strip = 0; status && strip < planned.strips; ++strip) {
    status = renderer->draw_strip(strip, strip_pixels);
    if (!status) break;
    const Rect area = planned.strip_area(strip, view);
    const auto* pixel = reinterpret_cast<const std::uint16_t*>(strip_pixels.data());
    for (std::int32_t y = area.top; y < area.bottom; ++y) {
      std::uint8_t* to = picture.data() + 4 * (y * view.width + area.left);
      for (std::int32_t x = area.left; x < area.right; ++x, to += 4) put_pixel(to, *pixel++);
    }
  }
  return status;
}

}  // namespace
}  // namespace zstrip

using namespace zstrip;

// Status numbers are those of zstrip::Error; words() returns a message for each. -1: no memory.
extern "C" {

[[clang::export_name("reserve")]] std::byte* zstrip_reserve(std::size_t bytes) { return reserve(bytes); }

[[clang::export_name("words")]] const char* zstrip_words(int status) {
  return status < 0 ? "no memory" : message(static_cast<Error>(status));
}

/// Opens the bytes of a .zsc, which must not move.
[[clang::export_name("open")]] int zstrip_open(const std::byte* bytes, std::size_t size) {
  const std::span file(bytes, size);
  Status status = open_scene_blob(file, {}, blob);
  if (status.error == Error::blob_memory) {
    const std::span<std::byte> tables = room_for<std::byte>(status.needed);
    if (tables.empty()) return -1;
    status = open_scene_blob(file, tables, blob);
  }
  return static_cast<int>(status.error);
}
[[clang::export_name("own_width")]] int zstrip_own_width() { return blob.view.width; }
[[clang::export_name("own_height")]] int zstrip_own_height() { return blob.view.height; }

/// Sets the picture's size, and the number of frames that show the animation or a rotation, at least 1.
[[clang::export_name("prepare")]] int zstrip_prepare(std::uint16_t width, std::uint16_t height,
                                                     std::uint32_t count_of) {
  view = {width, height, PixelFormat::rgb565, blob.view.dither, blob.view.samples};
  frames = count_of;
  camera = scenes::fit_width(blob.camera_for(frames), blob.view, view);
  if (!scenes::can_turn({blob.scene, camera, blob.animation, blob.turn})) return static_cast<int>(Error::instance);
  const Effects effects = effects_of(blob.scene, camera) | effects_of(view) | blob.effects | effect::bins;
  const PlanResult result = plan(count(blob.scene), view, effects);
  if (!result.status) return static_cast<int>(result.status.error);
  planned = result.plan;
  instances = room_for<Instance>(blob.scene.instances.size());
  lines = room_for<LineSet>(blob.scene.lines.size());
  arena = room_for<std::byte>(planned.bytes());
  strip_pixels = room_for<std::byte>(planned.strip_pixel_bytes(view));
  picture = room_for<std::uint8_t>(std::size_t{4} * width * height);
  if (picture.empty() || strip_pixels.empty() || arena.size() < planned.bytes()) return -1;
  renderer = new (renderer_memory) AnyRenderer(effects);
  return static_cast<int>(begin(0).error);  // reports a missing effect now
}

/// Draws frame `frame` into picture(): of the clip that was chosen last, if there are clips.
[[clang::export_name("draw")]] int zstrip_draw(std::uint32_t frame) {
  if (renderer == nullptr) return static_cast<int>(Error::not_begun);
  Status status = begin(frame);
  if (status) status = draw_begun();
  return static_cast<int>(status.error);
}
[[clang::export_name("picture")]] const std::uint8_t* zstrip_picture() { return picture.data(); }

[[clang::export_name("clips")]] std::size_t zstrip_clips() { return blob.clips.size(); }
// The next three take the number of a clip that exists.
[[clang::export_name("clip_name")]] const char* zstrip_clip_name(std::size_t clip) { return blob.clips[clip].name; }
[[clang::export_name("clip_time")]] std::uint32_t zstrip_clip_time(std::size_t clip) {
  return blob.clips[clip].duration();
}
[[clang::export_name("play")]] void zstrip_play(std::size_t clip, std::uint16_t fade, int loops) {
  played.play(static_cast<std::uint16_t>(clip), fade, loops != 0);
  event_from = 0;
}
/// Returns the number of the next event that the clip that was chosen last has reached; -1: none.
[[clang::export_name("next_event")]] int zstrip_next_event() {
  if (blob.clips.empty()) return -1;
  const PlayedClip& last = played.last();
  const ClipEvent* const event =
      next_event(blob.events, last.clip, last.time, blob.clips[last.clip].duration(), event_from);
  return event != nullptr ? event->number : -1;
}
/// Moves the clips that play on, and draws them into picture().
[[clang::export_name("advance")]] int zstrip_advance(std::uint32_t milliseconds) {
  if (renderer == nullptr || blob.clips.empty()) return static_cast<int>(Error::not_begun);
  played.advance(milliseconds, blob.clips);
  Status status = begin_clips(played.all());
  if (status) status = draw_begun();
  return static_cast<int>(status.error);
}
}
