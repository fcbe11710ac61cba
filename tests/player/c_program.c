/* A scene on a display, in C. */
#include "c_program.h"

#include <string.h>

static int take(void* context, const zstrip_strip* strip) {
  picture* to = context;
  const size_t row = 2U * strip->width;
  uint16_t y;
  for (y = 0; y < strip->height; ++y) {
    memcpy(to->pixels + 2U * ((size_t)(strip->top + y) * to->width + strip->left),
           (const unsigned char*)strip->pixels + y * row, row);
  }
  ++to->strips;
  return strip->bytes == strip->height * row;
}

const char* show(picture* to, const void* scene, size_t scene_bytes, void* memory, size_t memory_bytes,
                 const zstrip_pipeline* pipeline, uint32_t milliseconds) {
  zstrip_player* player = zstrip_player_in(memory, memory_bytes, pipeline);
  if (player == NULL) return "no room for the player";
  zstrip_player_show_text(player, "C ", 1);
  if (!zstrip_player_open(player, scene, scene_bytes)) return zstrip_player_error(player);
  if (!zstrip_player_fit(player, to->width, to->height, ZSTRIP_RGB565, 1)) return zstrip_player_error(player);
  zstrip_player_play(player, 100);
  zstrip_player_play(player, 100 + milliseconds);
  zstrip_player_hold(player, 1);
  zstrip_player_play(player, 200 + milliseconds);
  zstrip_player_orbit(player, 0, 0);
  zstrip_player_zoom(player, 100);
  zstrip_player_draw(player, take, to);
  return zstrip_player_error(player);
}

const char* pick_middle(zstrip_picked* picked, const void* scene, size_t scene_bytes, void* memory, size_t memory_bytes,
                        const zstrip_pipeline* pipeline, const zstrip_picker* picker) {
  zstrip_player* player = zstrip_player_in(memory, memory_bytes, pipeline);
  if (player == NULL) return "no room for the player";
  if (!zstrip_player_open(player, scene, scene_bytes)) return zstrip_player_error(player);
  if (!zstrip_player_fit(player, 120, 90, ZSTRIP_RGB565, 1)) return zstrip_player_error(player);
  zstrip_player_pick(player, picker, 60, 45, picked);
  return zstrip_player_error(player);
}

int fit_format(zstrip_player* player, long format) {
  return zstrip_player_fit(player, 120, 90, (zstrip_format)format, 1);
}
