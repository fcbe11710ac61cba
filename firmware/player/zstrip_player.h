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
  /** Directly after the pixels a byte each: 255 if something was drawn, 0 if not. Null without
   * zstrip_fit_options.masked, and of strips of zstrip_player_draw. */
  const uint8_t* mask;
} zstrip_strip;

/** A rectangle of the picture. */
typedef struct {
  uint16_t left, top, width, height;  ///< pixels
} zstrip_area;

/** How a picture is planned. */
typedef struct {
  uint16_t strip_rows;  ///< rows of a strip, if a plan with so many fits; 0: the planner decides
  uint16_t row_step;    ///< strips have a multiple of so many rows: 1, or 8 for displays with bytes of eight rows
  int masked;           ///< not 0: zstrip_player_strip makes a mask, for a byte more for each pixel of a strip
  int tracks_changes;   ///< not 0: zstrip_player_changed knows single instances, for 12 bytes each
} zstrip_fit_options;

/** Sends a strip to the display. Returns 0 to end the frame. */
typedef int (*zstrip_take)(void* context, const zstrip_strip* strip);

/** Makes a player in `memory`, which it keeps and uses for all its data. Returns null if the memory is too small for
 * the player itself, or a pointer is null. All functions accept a null player: they do nothing, and
 * zstrip_player_error says so. */
zstrip_player* zstrip_player_in(void* memory, size_t bytes, const zstrip_pipeline* pipeline);

/* The next functions, to zstrip_player_play_clip, return 0 after a fault: zstrip_player_error explains it. */

/** Opens a .zsc file in place; its address must be a multiple of 4. Any bytes are safe; null is an error. */
int zstrip_player_open(zstrip_player* player, const void* scene, size_t bytes);
/** Plans a picture. Strips have a multiple of `row_step` rows: 1, or 8 for displays with bytes of eight rows. */
int zstrip_player_fit(zstrip_player* player, uint16_t width, uint16_t height, zstrip_format format, uint16_t row_step);
/** Plans a picture with these options. */
int zstrip_player_fit_with(zstrip_player* player, uint16_t width, uint16_t height, zstrip_format format,
                           const zstrip_fit_options* options);
/** Draws a frame: passes each strip to `take`, with `context`. A null `take` is an error. */
int zstrip_player_draw(zstrip_player* player, zstrip_take take, void* context);
/** Begins a frame at the time and from the place that were set last, for zstrip_player_strip, _draw_area and _pick. */
int zstrip_player_begin(zstrip_player* player);
/** Draws the strip that has row `y` of the frame that was begun last; a row below the picture is an error. Its pixels
 * are valid until the next call that draws or begins. The strip that was drawn last is not drawn again. */
int zstrip_player_strip(zstrip_player* player, uint16_t y, zstrip_strip* strip);
/** Draws a rectangle of the frame that was begun last: the pixels of the whole picture. A rectangle without pixels, as
 * of zstrip_player_changed if nothing changed, is an error. `pixels`: its upper left pixel, with `bytes` from there on;
 * its rows are `stride` bytes apart. `mask`: null, or the mask of the first pixel; its rows are `mask_stride` bytes
 * apart, and it has as many rows as the rectangle. */
int zstrip_player_draw_area(zstrip_player* player, const zstrip_area* area, void* pixels, size_t bytes, size_t stride,
                            uint8_t* mask, size_t mask_stride);
/** Finds what a pixel of the picture shows, in the frame that was begun last, by zstrip_player_fit, _draw or _begin. A
 * null `picker` is an error; a null `picked` gets nothing. */
int zstrip_player_pick(zstrip_player* player, const zstrip_picker* picker, uint16_t x, uint16_t y,
                       zstrip_picked* picked);
/** Plays a clip of the open scene from its beginning, over and over, or once if `loops` is 0. During `fade`
 * milliseconds the clips that play go on and become this one. */
int zstrip_player_play_clip(zstrip_player* player, size_t clip, uint16_t fade, int loops);

/** Returns the number of clips, named animations, of the open scene. */
size_t zstrip_player_clips(const zstrip_player* player);
/** Returns the name of a clip, UTF-8, valid as long as the scene is open; null if there is no such clip. */
const char* zstrip_player_clip_name(const zstrip_player* player, size_t clip);
/** Returns the duration of a clip in milliseconds; 0 if there is no such clip. */
uint32_t zstrip_player_clip_time(const zstrip_player* player, size_t clip);

/** Sets `number` to that of the next event that the clip that was chosen last has reached since the call before.
 * Returns 0 if there is none. Call it after zstrip_player_play until it returns 0. */
int zstrip_player_poll_event(zstrip_player* player, uint16_t* number);

/** Sets `area` to a rectangle outside of which the frame that was begun last equals the frame that was begun when this
 * function was called before. It has no pixels (width 0) if nothing changed, and is the whole picture after a fit. */
void zstrip_player_changed(zstrip_player* player, zstrip_area* area);
/** The background of the scene itself. */
#define ZSTRIP_BAKED_BACKGROUND 0xFFFFFFFFU
/** Replaces the background of the scene by 0xRRGGBB, or shows ZSTRIP_BAKED_BACKGROUND again, from the next frame on. */
void zstrip_player_background(zstrip_player* player, uint32_t colour);
/** Sets the time, in milliseconds of any clock. After the first call the animation runs; a scene without an animation
 * rotates. */
void zstrip_player_play(zstrip_player* player, uint32_t milliseconds);
/** Returns the time, in milliseconds from the beginning of the motion or of the clip that was chosen last. */
uint32_t zstrip_player_time(const zstrip_player* player);
/** Returns how long the motion takes, in milliseconds, at least 1. */
uint32_t zstrip_player_period(zstrip_player* player);
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
/** Returns a message about the fault of the last function that returns 0 after one, valid until this function is
 * called again; "" if there was none. */
const char* zstrip_player_error(zstrip_player* player);

#ifdef __cplusplus
}
#endif
#endif
