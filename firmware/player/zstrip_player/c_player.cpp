// The functions of zstrip_player.h.
#include <algorithm>
#include <bit>
#include <new>
#include <type_traits>

#include "zstrip_player/c_picker.hpp"
#include "zstrip_player/c_pipeline.hpp"

struct zstrip_player : zstrip::Player {
  using Player::Player;
  int refuse_null_take() { return fail(Fault::null_take) ? 1 : 0; }
  int refuse_area() { return fail(Fault::area) ? 1 : 0; }
};

static_assert(static_cast<int>(zstrip::kLastPixelFormat) == ZSTRIP_XRGB8888);
static_assert(static_cast<int>(zstrip::Shown::label) == ZSTRIP_LABEL);

namespace {

zstrip_strip strip_of(const zstrip::Rect& area, std::span<const std::byte> pixels, const std::uint8_t* mask) {
  const auto side = [](std::int32_t length) { return static_cast<std::uint16_t>(length); };
  return {side(area.left), side(area.top), side(area.width()), side(area.height()), pixels.data(), pixels.size(), mask};
}

/// A program in C may pass any number, which must not become a valid format when it is cut to a byte. Its bytes are
/// read, because in C++ a value of an enum is one of as many bits as its enumerators have.
zstrip::PixelFormat format_of(const zstrip_format& format) {
  const auto number = std::bit_cast<std::underlying_type_t<zstrip_format>>(format);
  return static_cast<zstrip::PixelFormat>(std::min<unsigned>(number, 0xFF));
}

int fit(zstrip_player* player, std::uint16_t width, std::uint16_t height, zstrip::PixelFormat format,
        const zstrip_fit_options& wanted) {
  if (player == nullptr) return 0;
  const zstrip::FitOptions options{
      .strip_rows = wanted.strip_rows, .masked = wanted.masked != 0, .tracks_changes = wanted.tracks_changes != 0};
  return player->fit(width, height, format, options, wanted.row_step) ? 1 : 0;
}

}  // namespace

zstrip_player* zstrip_player_in(void* memory, std::size_t bytes, const zstrip_pipeline* pipeline) {
  if (memory == nullptr || pipeline == nullptr || pipeline->choose == nullptr) return nullptr;
  const std::size_t first =
      (alignof(zstrip_player) - reinterpret_cast<std::uintptr_t>(memory) % alignof(zstrip_player)) %
      alignof(zstrip_player);
  if (bytes < first + sizeof(zstrip_player)) return nullptr;
  std::byte* const place = static_cast<std::byte*>(memory) + first;
  std::byte* const behind = place + sizeof(zstrip_player);
  return ::new (place) zstrip_player({behind, bytes - first - sizeof(zstrip_player)}, pipeline->choose);
}

int zstrip_player_open(zstrip_player* player, const void* scene, std::size_t bytes) {
  return player != nullptr && player->open(scene, bytes) ? 1 : 0;
}
int zstrip_player_fit(zstrip_player* player, std::uint16_t width, std::uint16_t height, zstrip_format format,
                      std::uint16_t row_step) {
  return fit(player, width, height, format_of(format), {0, row_step, 0, 0});
}
int zstrip_player_fit_with(zstrip_player* player, std::uint16_t width, std::uint16_t height, zstrip_format format,
                           const zstrip_fit_options* options) {
  return fit(player, width, height, format_of(format), options != nullptr ? *options : zstrip_fit_options{});
}
int zstrip_player_begin(zstrip_player* player) { return player != nullptr && player->begin() ? 1 : 0; }
int zstrip_player_strip(zstrip_player* player, std::uint16_t y, zstrip_strip* strip) {
  if (player == nullptr) return 0;
  if (strip == nullptr) return player->refuse_area();
  *strip = {};
  const zstrip::Plan& plan = player->plan();
  std::uint16_t number = 0;
  // The last strip may be lower than the others: rows below the picture lie in a strip that the plan lacks.
  if (plan.strip_rows != 0) {
    number = y < player->view().height ? static_cast<std::uint16_t>(y / plan.strip_rows) : plan.strips;
  }
  zstrip::DrawnStrip drawn;
  if (!player->draw_strip(number, drawn)) return 0;
  *strip = strip_of(drawn.area, drawn.pixels, drawn.mask.data());
  return 1;
}
int zstrip_player_draw_area(zstrip_player* player, const zstrip_area* area, void* pixels, std::size_t bytes,
                            std::size_t stride, std::uint8_t* mask, std::size_t mask_stride) {
  if (player == nullptr) return 0;
  if (area == nullptr || pixels == nullptr) return player->refuse_area();
  const zstrip::Rect rectangle{area->left, area->top, area->left + area->width, area->top + area->height};
  // The caller says that its mask has as many rows as the rectangle.
  const std::size_t mask_bytes =
      mask != nullptr && area->height != 0 && area->width != 0 ? mask_stride * (area->height - 1U) + area->width : 0;
  const bool right =
      player->draw_area(rectangle, {static_cast<std::byte*>(pixels), bytes}, stride, {mask, mask_bytes}, mask_stride);
  return right ? 1 : 0;
}
void zstrip_player_changed(zstrip_player* player, zstrip_area* area) {
  if (area == nullptr) return;
  const zstrip::Rect changed = player != nullptr ? player->changed() : zstrip::Rect{};
  const auto side = [](std::int32_t length) { return static_cast<std::uint16_t>(length); };
  *area = {side(changed.left), side(changed.top), side(changed.width()), side(changed.height())};
}
void zstrip_player_background(zstrip_player* player, std::uint32_t colour) {
  if (player == nullptr) return;
  if (colour > 0xFFFFFF) return player->baked_background();
  const auto channel = [colour](int shift) { return static_cast<std::uint8_t>(colour >> shift); };
  player->background({channel(16), channel(8), channel(0), 255});
}
int zstrip_player_draw(zstrip_player* player, zstrip_take take, void* context) {
  if (player == nullptr) return 0;
  if (take == nullptr) return player->refuse_null_take();
  const auto drawn = player->draw_strips([&](const zstrip::Rect& area, std::span<const std::byte> pixels) {
    const zstrip_strip strip = strip_of(area, pixels, nullptr);
    return take(context, &strip) != 0;
  });
  return drawn ? 1 : 0;
}
int zstrip_player_pick(zstrip_player* player, const zstrip_picker* picker, std::uint16_t x, std::uint16_t y,
                       zstrip_picked* picked) {
  if (player == nullptr) return 0;
  zstrip::Picked found;
  const bool right = player->pick(picker != nullptr ? picker->choose : nullptr, x, y, found);
  if (picked != nullptr) {
    *picked = {
        static_cast<zstrip_shown>(found.shown), found.textured ? 1 : 0, found.index, found.triangle, found.u, found.v};
  }
  return right ? 1 : 0;
}

int zstrip_player_play_clip(zstrip_player* player, std::size_t clip, std::uint16_t fade, int loops) {
  return player != nullptr && player->play_clip(clip, fade, loops != 0) ? 1 : 0;
}
std::size_t zstrip_player_clips(const zstrip_player* player) { return player != nullptr ? player->clips().size() : 0; }
const char* zstrip_player_clip_name(const zstrip_player* player, std::size_t clip) {
  return clip < zstrip_player_clips(player) ? player->clips()[clip].name : nullptr;
}
int zstrip_player_poll_event(zstrip_player* player, std::uint16_t* number) {
  return player != nullptr && number != nullptr && player->poll_event(*number) ? 1 : 0;
}
std::uint32_t zstrip_player_clip_time(const zstrip_player* player, std::size_t clip) {
  return clip < zstrip_player_clips(player) ? player->clips()[clip].duration() : 0;
}

void zstrip_player_play(zstrip_player* player, std::uint32_t milliseconds) {
  if (player != nullptr) player->play(milliseconds);
}
std::uint32_t zstrip_player_time(const zstrip_player* player) { return player != nullptr ? player->time() : 0; }
std::uint32_t zstrip_player_period(zstrip_player* player) { return player != nullptr ? player->period() : 1; }
void zstrip_player_hold(zstrip_player* player, int held) {
  if (player != nullptr) player->hold(held != 0);
}
void zstrip_player_seek(zstrip_player* player, std::uint32_t milliseconds) {
  if (player != nullptr) player->seek(milliseconds);
}
void zstrip_player_orbit(zstrip_player* player, std::uint16_t right, std::uint16_t up) {
  if (player != nullptr) player->orbit(right, up);
}
void zstrip_player_zoom(zstrip_player* player, std::uint16_t percent) {
  if (player != nullptr) player->zoom(percent);
}
void zstrip_player_show_text(zstrip_player* player, const char* text, int with_rate) {
  if (player != nullptr) player->show_text(text, with_rate != 0);
}
const char* zstrip_player_error(zstrip_player* player) {
  if (player == nullptr) return "there is no player: zstrip_player_in had no memory, too little of it, or no pipeline";
  return player->error();
}
