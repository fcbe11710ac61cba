/** A baked scene on a display, for programs in C: zstrip_player/player.hpp as a dozen functions. @file */
#ifndef ZSTRIP_PLAYER_H
#define ZSTRIP_PLAYER_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** A player. It lies in the memory that the program gives it. */
typedef struct zstrip_player zstrip_player;

/** The drawing code. A C++ file makes it with zstrip_player/c_pipeline.hpp. */
typedef struct zstrip_pipeline zstrip_pipeline;

/** The layout of pixels in memory: docs/conventions.md, "Picture formats". */
typedef enum {
  ZSTRIP_RGB565,
  ZSTRIP_RGB565_SWAPPED,
  ZSTRIP_GRAY4,
  ZSTRIP_MONO,
  ZSTRIP_RGB666,
  ZSTRIP_RGB444,
  ZSTRIP_XRGB8888
} zstrip_format;

/** The function that finds what a pixel shows. A C++ file makes it with zstrip_player/c_picker.hpp. */
typedef struct zstrip_picker zstrip_picker;

/** The kind of thing that a pixel shows, as zstrip::Shown. */
typedef enum {
  ZSTRIP_BACKGROUND,
  ZSTRIP_INSTANCE,
  ZSTRIP_OUTLINE,
  ZSTRIP_QUADRIC,
  ZSTRIP_LINE,
  ZSTRIP_SPRITE,
  ZSTRIP_LABEL
} zstrip_shown;

/** The thing that a pixel shows. */
typedef struct {
  zstrip_shown shown;  ///< says which of the scene's tables `index` refers to
  int textured;        ///< 1 for a triangle with a texture of its own, else 0
  uint16_t index;      ///< of the instance, quadric, set of lines, sprite or label; of an outline that of its instance
  uint32_t triangle;   ///< of the instance's mesh, or of the outline's hull; of a line its index in the set; else 0
  uint16_t u, v;       ///< place in the texture if `textured`, in 1/65536 of its width and height
} zstrip_picked;

/** A rectangle of the picture. Its rows follow each other; each begins at a byte. */
typedef struct {
  uint16_t left, top, width, height;  ///< pixels of the picture
  const void* pixels;                 ///< valid until zstrip_take returns
  size_t bytes;                       ///< bytes of all rows
} zstrip_strip;

/** Sends a strip to the display. Returns 0 to end the frame. */
typedef int (*zstrip_take)(void* context, const zstrip_strip* strip);

/** Makes a player in `memory`, which it keeps and uses for all its data. Returns null if the memory is too small for
 * the player itself, or a pointer is null. All functions accept a null player: they do nothing, and
 * zstrip_player_error says so. */
zstrip_player* zstrip_player_in(void* memory, size_t bytes, const zstrip_pipeline* pipeline);

/* The next four functions return 0 after a fault: zstrip_player_error explains it. */

/** Opens a .zsc file in place; its address must be a multiple of 4. Any bytes are safe; null is an error. */
int zstrip_player_open(zstrip_player* player, const void* scene, size_t bytes);
/** Plans a picture. Strips have a multiple of `row_step` rows: 1, or 8 for displays with bytes of eight rows. */
int zstrip_player_fit(zstrip_player* player, uint16_t width, uint16_t height, zstrip_format format, uint16_t row_step);
/** Draws a frame: passes each strip to `take`, with `context`. A null `take` is an error. */
int zstrip_player_draw(zstrip_player* player, zstrip_take take, void* context);
/** Finds what a pixel of the picture shows, in the frame that was begun last, by zstrip_player_fit or _draw. A null
 * `picker` is an error; a null `picked` gets nothing. */
int zstrip_player_pick(zstrip_player* player, const zstrip_picker* picker, uint16_t x, uint16_t y,
                       zstrip_picked* picked);

/** Sets the time, in milliseconds of any clock. After the first call the animation runs; a scene without an animation
 * rotates. */
void zstrip_player_play(zstrip_player* player, uint32_t milliseconds);
/** Pauses the motion; 0 continues it. */
void zstrip_player_hold(zstrip_player* player, int held);
/** Sets the motion to a time, in milliseconds from its beginning. */
void zstrip_player_seek(zstrip_player* player, uint32_t milliseconds);
/** Moves the camera around the point that it looks at; 65536 is 360 degrees; 0, 0 is the baked position. */
void zstrip_player_orbit(zstrip_player* player, uint16_t right, uint16_t up);
/** Enlarges the picture; 100 is the baked size. */
void zstrip_player_zoom(zstrip_player* player, uint16_t percent);
/** Shows the first 24 bytes of `text`, none if it is null, and frames a second if `with_rate` is not 0; needs
 * effect::overlay. */
void zstrip_player_show_text(zstrip_player* player, const char* text, int with_rate);
/** Returns a message about the fault of the last zstrip_player_open, fit, draw or pick, valid until this function is
 * called again; "" if there was none. */
const char* zstrip_player_error(zstrip_player* player);

#ifdef __cplusplus
}
#endif
#endif
