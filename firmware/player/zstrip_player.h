/** A baked scene on a display, for programs in C: what zstrip_player/player.hpp has, in a dozen functions. @file */
#ifndef ZSTRIP_PLAYER_H
#define ZSTRIP_PLAYER_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** A player; it lies in the memory that it is given. */
typedef struct zstrip_player zstrip_player;

/** The code that draws. A file in C++ makes it: zstrip_player/c_pipeline.hpp. */
typedef struct zstrip_pipeline zstrip_pipeline;

/** How pixels lie in memory: docs/conventions.md, "Picture formats". */
typedef enum {
  ZSTRIP_RGB565,
  ZSTRIP_RGB565_SWAPPED,
  ZSTRIP_GRAY4,
  ZSTRIP_MONO,
  ZSTRIP_RGB666,
  ZSTRIP_RGB444,
  ZSTRIP_XRGB8888
} zstrip_format;

/** A rectangle of the picture; its rows follow each other, each begins at a byte. */
typedef struct {
  uint16_t left, top, width, height;  ///< pixels of the picture
  const void* pixels;                 ///< until zstrip_take returns
  size_t bytes;                       ///< of all rows
} zstrip_strip;

/** Sends a strip to the display; 0 ends the frame. */
typedef int (*zstrip_take)(void* context, const zstrip_strip* strip);

/** In `memory`, which it keeps, with all that it needs; null if there is not even room for itself, or a pointer is
    null. All functions take a null player: they do nothing, and zstrip_player_error says so. */
zstrip_player* zstrip_player_in(void* memory, size_t bytes, const zstrip_pipeline* pipeline);

/* The first three return 0 if something is wrong: zstrip_player_error says what. */

/** The bytes of a .zsc, which stay where they are, at a multiple of 4. Any bytes are safe; null is an error. */
int zstrip_player_open(zstrip_player* player, const void* scene, size_t bytes);
/** Plans for a picture. Strips have a multiple of `row_step` rows: 1, or 8 for displays with bytes of eight rows. */
int zstrip_player_fit(zstrip_player* player, uint16_t width, uint16_t height, zstrip_format format, uint16_t row_step);
/** Draws a frame: each strip is given to `take`, with `context`. Without `take` that is an error. */
int zstrip_player_draw(zstrip_player* player, zstrip_take take, void* context);

/** What time it is, by any clock of milliseconds: the animation runs from the first call on, or a turn. */
void zstrip_player_play(zstrip_player* player, uint32_t milliseconds);
/** Lets the motion stand, or go on with 0. */
void zstrip_player_hold(zstrip_player* player, int held);
/** Sets the motion to a time from its beginning. */
void zstrip_player_seek(zstrip_player* player, uint32_t milliseconds);
/** Takes the camera around what it looks at; 65536 is a full turn, 0, 0 where it was baked. */
void zstrip_player_orbit(zstrip_player* player, uint16_t right, uint16_t up);
/** Enlarges the picture; 100 is as baked. */
void zstrip_player_zoom(zstrip_player* player, uint16_t percent);
/** The first 24 bytes of `text`, none if it is null, and frames a second where `with_rate` is not 0; needs
 * effect::overlay. */
void zstrip_player_show_text(zstrip_player* player, const char* text, int with_rate);
/** What was wrong with the last of the first three, in words, until it is called again; "" if nothing was. */
const char* zstrip_player_error(zstrip_player* player);

#ifdef __cplusplus
}
#endif
#endif
