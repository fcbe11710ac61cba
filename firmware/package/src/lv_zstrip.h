/** A widget of LVGL 9 that shows a baked scene: docs/lvgl.md. LVGL asks it for the rows that it needs, and gets each
 * strip straight from the renderer, so that there is no canvas. It needs LVGL's software renderer. @file */
#ifndef LV_ZSTRIP_H
#define LV_ZSTRIP_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "lvgl.h"
#include "zstrip_player.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A scene, and the memory to show it with. The widget keeps the addresses: all of it must live until another scene is
 * set, or the widget is deleted. */
typedef struct {
  const void* scene;                ///< a .zsc file, at a multiple of 4
  size_t scene_bytes;               ///< its size
  void* memory;                     ///< for the player and its strips: more of it means taller strips
  size_t memory_bytes;              ///< 5 KB for a small scene; lv_zstrip_get_error says how many are missing
  const zstrip_pipeline* pipeline;  ///< the drawing code: zstrip_player/c_pipeline.hpp, with clipping
  const zstrip_picker* picker;      ///< for the event of a click: zstrip_player/c_picker.hpp; null: there is none
} lv_zstrip_scene_t;

/** The widget's class. */
extern const lv_obj_class_t lv_zstrip_class;

/** Makes a widget without a scene. A drag moves the camera around the model, a wheel enlarges the widget that was
 * pressed last, and a click sends LV_EVENT_VALUE_CHANGED, whose parameter is a const zstrip_picked* that is valid until
 * the next click. The picture has the size of the widget without its border and padding. Styles of images apply:
 * image_opa, image_recolor, radius. */
lv_obj_t* lv_zstrip_create(lv_obj_t* parent);

/** Shows a scene and plays it from its beginning, seen as it was baked; null shows none. False after a fault: the
 * widget shows lv_zstrip_get_error as text. */
bool lv_zstrip_set_scene(lv_obj_t* obj, const lv_zstrip_scene_t* scene);

/** Leaves out the background of the scene, so that the widget's own or its parents' are seen; false draws it again.
 * Smoothed edges are mixed with the colour of the nearest of these backgrounds. Takes a byte more for each pixel of a
 * strip. */
void lv_zstrip_set_transparent(lv_obj_t* obj, bool transparent);

/** Plays, from where the motion was paused. */
void lv_zstrip_play(lv_obj_t* obj);
/** Pauses. */
void lv_zstrip_pause(lv_obj_t* obj);
/** Plays a clip of the scene from its beginning, over and over, or once. During `fade` milliseconds the clips that play
 * go on and become this one. False if there is no such clip. */
bool lv_zstrip_play_clip(lv_obj_t* obj, uint32_t clip, uint16_t fade, bool loops);
/** Returns the number of clips: 0 if the scene has one motion without a name. */
uint32_t lv_zstrip_get_clips(lv_obj_t* obj);
/** Returns the name of a clip; null if there is no such clip. */
const char* lv_zstrip_get_clip_name(lv_obj_t* obj, uint32_t clip);
/** Repeats the part of the motion from `from` to `to`, in milliseconds from the motion's beginning; the whole motion if
 * `to` is not greater. Begins at `from`. For scenes without clips. */
void lv_zstrip_set_part(lv_obj_t* obj, uint32_t from, uint32_t to);
/** Sets the time, in milliseconds from the beginning of the motion or clip. From a time before lv_zstrip_set_part's
 * part it plays to the part's end; then the part repeats. */
void lv_zstrip_set_time(lv_obj_t* obj, uint32_t time);
/** Returns the time, in milliseconds from the beginning of the motion or clip. */
uint32_t lv_zstrip_get_time(lv_obj_t* obj);

/** Moves the camera around the point that it looks at, from its baked position: to the right, and up. Tenths of a
 * degree; `up` is limited to 80 degrees either way. */
void lv_zstrip_set_orbit(lv_obj_t* obj, int32_t right, int32_t up);
/** Returns the angle to the right, in tenths of a degree, -1800 to 1799. */
int32_t lv_zstrip_get_orbit_right(lv_obj_t* obj);
/** Returns the angle up, in tenths of a degree. */
int32_t lv_zstrip_get_orbit_up(lv_obj_t* obj);
/** Enlarges the picture: 100 is the baked size; 10 to 1000. */
void lv_zstrip_set_zoom(lv_obj_t* obj, uint16_t percent);
/** Returns the enlargement in percent. */
uint16_t lv_zstrip_get_zoom(lv_obj_t* obj);
/** False: drags and wheels do not move the camera, and scroll the parent instead. */
void lv_zstrip_set_interactive(lv_obj_t* obj, bool interactive);

/** Finds what a pixel shows, in the frame that is shown. `x` and `y` are pixels of the picture. False without a scene
 * or a picker, or outside of the picture. */
bool lv_zstrip_pick(lv_obj_t* obj, int32_t x, int32_t y, zstrip_picked* picked);

/** Says what is wrong; "" if nothing is. Valid until the next call of a function of this widget. */
const char* lv_zstrip_get_error(lv_obj_t* obj);

#ifdef __cplusplus
}
#endif
#endif
