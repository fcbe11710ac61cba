/* A baked scene on a display, for programs in C: what zstrip_player/player.hpp has, in a dozen functions. */
#ifndef ZSTRIP_PLAYER_H
#define ZSTRIP_PLAYER_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct zstrip_player zstrip_player;

/* The code that draws. A file in C++ makes it: zstrip_player/c_pipeline.hpp. */
typedef struct zstrip_pipeline zstrip_pipeline;

/* How pixels lie in memory: docs/conventions.md, "Picture formats". */
typedef enum {
  ZSTRIP_RGB565,
  ZSTRIP_RGB565_SWAPPED,
  ZSTRIP_GRAY4,
  ZSTRIP_MONO,
  ZSTRIP_RGB666,
  ZSTRIP_RGB444,
  ZSTRIP_XRGB8888
} zstrip_format;

/* A rectangle of the picture; its rows follow each other, each begins at a byte. */
typedef struct {
  uint16_t left, top, width, height;
  const void* pixels;
  size_t bytes;
} zstrip_strip;

/* Sends a strip to the display; 0 ends the frame. */
typedef int (*zstrip_take)(void* context, const zstrip_strip* strip);

/* In `memory`, which it keeps, with all that it needs; null if there is not even room for itself. */
zstrip_player* zstrip_player_in(void* memory, size_t bytes, const zstrip_pipeline* pipeline);

/* These return 0 if something is wrong: zstrip_player_error says what. Each is explained in player.hpp. */
int zstrip_player_open(zstrip_player* player, const void* scene, size_t bytes);
/* Strips have a multiple of `row_step` rows: 1, or 8 for displays with bytes of eight rows. */
int zstrip_player_fit(zstrip_player* player, uint16_t width, uint16_t height, zstrip_format format, uint16_t row_step);
int zstrip_player_draw(zstrip_player* player, zstrip_take take, void* context);

void zstrip_player_play(zstrip_player* player, uint32_t milliseconds);
void zstrip_player_hold(zstrip_player* player, int held);
void zstrip_player_seek(zstrip_player* player, uint32_t milliseconds);
void zstrip_player_orbit(zstrip_player* player, uint16_t right, uint16_t up);
void zstrip_player_zoom(zstrip_player* player, uint16_t percent);
void zstrip_player_show_text(zstrip_player* player, const char* text, int with_rate);
const char* zstrip_player_error(zstrip_player* player);

#ifdef __cplusplus
}
#endif
#endif
