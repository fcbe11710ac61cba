// Plays a scene on a display: frame after frame.
#include "play.hpp"

#include <cstdio>
#include <new>
#include <vector>

#include "zstrip/plan.hpp"
#include "zstrip/renderer.hpp"
#include "zstrip_hal/present.hpp"

namespace zstrip::panel {
namespace {

constexpr int kPatience = 10;

PixelFormat view_format(hal::DisplayFormat format) {
  switch (format) {
    case hal::DisplayFormat::rgb565: return PixelFormat::rgb565;
    case hal::DisplayFormat::rgb565_swapped: return PixelFormat::rgb565_swapped;
    case hal::DisplayFormat::gray4: return PixelFormat::gray4;
    case hal::DisplayFormat::mono: return PixelFormat::mono;
    case hal::DisplayFormat::rgb666: return PixelFormat::rgb666;
    case hal::DisplayFormat::rgb444: return PixelFormat::rgb444;
    case hal::DisplayFormat::xrgb8888: return PixelFormat::xrgb8888;
  }
  return PixelFormat::rgb565;
}

Failure refused(const char* what, const Status& status) {
  const bool scene = status.error == Error::camera || status.error == Error::instance;
  return {scene ? ExitStatus::input : ExitStatus::internal, std::string(what) + ": " + message(status.error)};
}

/// Memory in 8-byte words: kArenaAlignment.
std::span<std::byte> resized(std::vector<std::uint64_t>& words, std::uint32_t bytes) {
  words.resize((std::size_t{bytes} + sizeof(std::uint64_t) - 1) / sizeof(std::uint64_t));
  return std::as_writable_bytes(std::span(words)).first(bytes);
}

}  // namespace

std::optional<Failure> play(SceneFile& scene, AnyDisplay& display, const PlayOptions& options, StopSignals& stop,
                            Played& played) {
  View view{display.width(), display.height(), view_format(display.format()), scene.dithers(), scene.samples()};
  if (view.width * sample_columns(view) > kMaxViewSize || view.height * sample_rows(view) > kMaxViewSize) {
    view.samples = 1;  // the display has enough pixels without supersampling
  }
  const Camera camera = scene.camera(view, options.frames_per_turn);
  if (options.frames_per_turn > 1 && !scene.can_turn(camera)) {
    return Failure{ExitStatus::input, "what turns in the baked scene is too far away for it; play it with --turn 1"};
  }
  const Effects effects = effects_of(scene.scene(), camera) | effects_of(view) | scene.effects() | effect::bins;
  // Controllers with several pixels a byte need areas of whole bytes, some of them in y: they get the picture as one
  // strip.
  const bool whole = view.format == PixelFormat::gray4 || view.format == PixelFormat::mono;
  const Budget budget{.strip_rows = whole ? view.height : std::uint16_t{0}};
  const auto [planned, plan] = zstrip::plan(count(scene.scene()), view, effects, budget);
  if (!planned) return refused("the picture cannot be planned", planned);

  std::vector<std::uint64_t> arena_words;
  std::vector<std::uint64_t> pixel_words[2];
  std::span<std::byte> arena;
  hal::StripBuffers buffers;
  try {
    arena = resized(arena_words, plan.bytes());
    const std::uint32_t strip_bytes = plan.strip_pixel_bytes(view);
    buffers = {resized(pixel_words[0], strip_bytes), resized(pixel_words[1], strip_bytes)};
  } catch (const std::bad_alloc&) {
    return Failure{ExitStatus::budget, std::to_string(plan.bytes()) + " bytes for the renderer are not to be had"};
  }

  AnyRenderer renderer(effects);
  const StopSignals::Clock::time_point start = StopSignals::Clock::now();
  const auto seconds = [start] { return std::chrono::duration<double>(StopSignals::Clock::now() - start).count(); };
  int refusals = 0;
  while ((options.frames == 0 || played.frames < options.frames) && !stop.arrived()) {
    const scenes::BakedFrame frame = scene.staged(camera, played.frames, options.frames_per_turn);
    if (const Status begun = renderer.begin_frame(frame.scene, frame.camera, view, plan, arena); !begun)
      return refused("the frame cannot begin", begun);
    const auto shown = hal::present(renderer, display, {plan.strips, plan.strip_rows, plan.strip_columns}, buffers);
    if (!shown.draw) return refused("a strip cannot be drawn", shown.draw);
    if (shown.display != hal::Error::none) {
      const std::string what = std::string("the display failed: ") + hal::message(shown.display);
      if (++refusals == kPatience) return Failure{ExitStatus::output, what};
      std::fprintf(stderr, "zstrip-panel: %s; trying again\n", what.c_str());
      continue;
    }
    refusals = 0;
    ++played.frames;
    played.seconds = seconds();
    if (options.frames_per_second > 0) {
      using Duration = std::chrono::duration<double>;
      const Duration due(played.frames / options.frames_per_second);
      stop.arrived_before(start + std::chrono::duration_cast<StopSignals::Clock::duration>(due));
    }
  }
  return std::nullopt;
}

}  // namespace zstrip::panel
