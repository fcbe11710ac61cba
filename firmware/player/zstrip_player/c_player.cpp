// The functions of zstrip_player.h.
#include <algorithm>
#include <new>

#include "zstrip_player/c_picker.hpp"
#include "zstrip_player/c_pipeline.hpp"

struct zstrip_player : zstrip::Player {
  using Player::Player;
  int refuse_null_take() { return fail(Fault::null_take) ? 1 : 0; }
};

static_assert(static_cast<int>(zstrip::kLastPixelFormat) == ZSTRIP_XRGB8888);
static_assert(static_cast<int>(zstrip::Shown::label) == ZSTRIP_LABEL);

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
  // An unknown number must not become a valid format when it is cut to a byte.
  const auto pixels = static_cast<zstrip::PixelFormat>(std::min<unsigned>(format, 0xFF));
  return player != nullptr && player->fit(width, height, pixels, {}, row_step) ? 1 : 0;
}
int zstrip_player_draw(zstrip_player* player, zstrip_take take, void* context) {
  if (player == nullptr) return 0;
  if (take == nullptr) return player->refuse_null_take();
  const auto drawn = player->draw_strips([&](const zstrip::Rect& area, std::span<const std::byte> pixels) {
    const auto side = [](std::int32_t length) { return static_cast<std::uint16_t>(length); };
    const zstrip_strip strip{side(area.left),     side(area.top), side(area.width()),
                             side(area.height()), pixels.data(),  pixels.size()};
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

void zstrip_player_play(zstrip_player* player, std::uint32_t milliseconds) {
  if (player != nullptr) player->play(milliseconds);
}
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
