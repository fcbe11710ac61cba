/* The module zstrip of MicroPython: zstrip_player.h as a class (docs/micropython.md). It is compiled as a part of a
   firmware, and as a native module (.mpy) with MICROPY_ENABLE_DYNRUNTIME. There qstrs are no constants, nothing of the
   C library is linked, and only functions of MicroPython in mp_fun_table can be called. */
#if defined(MICROPY_ENABLE_DYNRUNTIME)
#include "py/dynruntime.h"
#else
#include "py/binary.h"
#include "py/objstr.h"
#include "py/runtime.h"
#endif
#include "py/objarray.h"
#include "zstrip_player.h"

/* pipeline.cpp has them. */
extern const zstrip_pipeline zstrip_micropython_pipeline;
extern const zstrip_picker zstrip_micropython_picker;

typedef struct {
  mp_obj_base_t base;
  zstrip_player* player;
  byte* memory;   /* of the player; the collector keeps it with this object */
  mp_obj_t scene; /* the open scene's bytes */
  uint16_t width, height, pixel_bits;
} player_obj;

static player_obj* self_of(mp_obj_t self) { return MP_OBJ_TO_PTR(self); }

static mp_obj_t str_of(const char* text) {
  size_t length = 0;
  while (text[length] != '\0') ++length;
  return mp_obj_new_str(text, length);
}

/* Raises ValueError with the player's message. */
static void fail(zstrip_player* player) { mp_raise_type_arg(&mp_type_ValueError, str_of(zstrip_player_error(player))); }

static void check(player_obj* self, int right) {
  if (!right) fail(self->player);
}

static uint16_t half(mp_int_t value) {
  if (value < 0 || value > 0xFFFF) mp_raise_ValueError(MP_ERROR_TEXT("a number is not between 0 and 65535"));
  return (uint16_t)value;
}

static uint16_t half_of(mp_obj_t number) { return half(mp_obj_get_int(number)); }

static uint32_t word_of(mp_obj_t number) { return (uint32_t)mp_obj_get_int_truncated(number); }

/* Player(bytes) */
static mp_obj_t make_player(const mp_obj_type_t* type, size_t count, size_t named, const mp_obj_t* arguments) {
  mp_arg_check_num(count, named, 1, 1, false);
  const mp_int_t bytes = mp_obj_get_int(arguments[0]);
  player_obj* self = mp_obj_malloc(player_obj, type);
  self->scene = mp_const_none;
  self->width = self->height = self->pixel_bits = 0;
  self->memory = bytes > 0 ? m_new(byte, (size_t)bytes) : NULL;
  self->player = zstrip_player_in(self->memory, bytes > 0 ? (size_t)bytes : 0, &zstrip_micropython_pipeline);
  if (self->player == NULL) fail(NULL);
  return MP_OBJ_FROM_PTR(self);
}

/* open(scene): bytes, or a buffer that is not resized while the scene is open. */
static mp_obj_t player_open(mp_obj_t object, mp_obj_t scene) {
  player_obj* self = self_of(object);
  mp_buffer_info_t bytes;
  mp_get_buffer_raise(scene, &bytes, MP_BUFFER_READ);
  self->scene = scene;
  check(self, zstrip_player_open(self->player, bytes.buf, bytes.len));
  return mp_const_none;
}
static MP_DEFINE_CONST_FUN_OBJ_2(open_obj, player_open);

/* fit(width, height, format=RGB565, *, rows=0, row_step=1, masked=False, tracks_changes=False) */
static mp_obj_t player_fit(size_t count, const mp_obj_t* arguments, mp_map_t* named) {
  const mp_arg_t allowed[] = {
      {MP_QSTR_width, MP_ARG_REQUIRED | MP_ARG_OBJ, {.u_obj = MP_OBJ_NULL}},
      {MP_QSTR_height, MP_ARG_REQUIRED | MP_ARG_OBJ, {.u_obj = MP_OBJ_NULL}},
      {MP_QSTR_format, MP_ARG_INT, {.u_int = ZSTRIP_RGB565}},
      {MP_QSTR_rows, MP_ARG_KW_ONLY | MP_ARG_INT, {.u_int = 0}},
      {MP_QSTR_row_step, MP_ARG_KW_ONLY | MP_ARG_INT, {.u_int = 1}},
      {MP_QSTR_masked, MP_ARG_KW_ONLY | MP_ARG_BOOL, {.u_bool = false}},
      {MP_QSTR_tracks_changes, MP_ARG_KW_ONLY | MP_ARG_BOOL, {.u_bool = false}},
  };
  static const uint8_t kPixelBits[] = {16, 16, 4, 1, 24, 12, 32};
  player_obj* self = self_of(arguments[0]);
  mp_arg_val_t values[MP_ARRAY_SIZE(allowed)];
  mp_arg_parse_all(count - 1, arguments + 1, named, MP_ARRAY_SIZE(allowed), allowed, values);
  const uint16_t width = half_of(values[0].u_obj), height = half_of(values[1].u_obj);
  const mp_int_t format = values[2].u_int;
  if (format < 0 || format > ZSTRIP_XRGB8888) mp_raise_ValueError(MP_ERROR_TEXT("there is no such format"));
  const zstrip_fit_options options = {half(values[3].u_int), half(values[4].u_int), values[5].u_bool, values[6].u_bool};
  self->width = self->height = 0;
  check(self, zstrip_player_fit_with(self->player, width, height, (zstrip_format)format, &options));
  self->width = width;
  self->height = height;
  self->pixel_bits = kPixelBits[format];
  return mp_const_none;
}
static MP_DEFINE_CONST_FUN_OBJ_KW(fit_obj, 3, player_fit);

static mp_obj_t player_begin(mp_obj_t object) {
  check(self_of(object), zstrip_player_begin(self_of(object)->player));
  return mp_const_none;
}
static MP_DEFINE_CONST_FUN_OBJ_1(begin_obj, player_begin);

static zstrip_strip strip_at(player_obj* self, uint16_t y) {
  zstrip_strip strip;
  check(self, zstrip_player_strip(self->player, y, &strip));
  return strip;
}

/* A memoryview of bytes in the player's memory. It begins at the memory's first byte and has an offset, because the
   collector keeps a block only for a pointer to its beginning: the view may live longer than the player. */
static mp_obj_t view_of(player_obj* self, const void* bytes, size_t size) {
#if defined(MICROPY_ENABLE_DYNRUNTIME)
  mp_obj_t array = mp_obj_new_bytearray_by_ref(size, self->memory);
  mp_obj_t view = mp_call_function_n_kw(mp_load_global(MP_QSTR_memoryview), 1, 0, &array);
#else
  mp_obj_t view = mp_obj_new_memoryview('B', size, self->memory);
#endif
  ((mp_obj_array_t*)MP_OBJ_TO_PTR(view))->free = (size_t)((const byte*)bytes - self->memory);  // the view's offset
  return view;
}

/* strip(y): (left, top, width, height, pixels, mask), of the frame that was begun last. */
static mp_obj_t player_strip(mp_obj_t object, mp_obj_t y) {
  player_obj* self = self_of(object);
  const zstrip_strip strip = strip_at(self, half_of(y));
  mp_obj_t items[] = {
      MP_OBJ_NEW_SMALL_INT(strip.left),
      MP_OBJ_NEW_SMALL_INT(strip.top),
      MP_OBJ_NEW_SMALL_INT(strip.width),
      MP_OBJ_NEW_SMALL_INT(strip.height),
      view_of(self, strip.pixels, strip.bytes),
      strip.mask != NULL ? view_of(self, strip.mask, (size_t)strip.width * strip.height) : mp_const_none,
  };
  return mp_obj_new_tuple(MP_ARRAY_SIZE(items), items);
}
static MP_DEFINE_CONST_FUN_OBJ_2(strip_obj, player_strip);

/* draw(take): a frame; take(left, top, width, height, pixels) gets each strip, from the top on. */
static mp_obj_t player_draw(mp_obj_t object, mp_obj_t take) {
  player_obj* self = self_of(object);
  player_begin(object);
  for (mp_uint_t y = 0; y < self->height;) {
    const zstrip_strip strip = strip_at(self, (uint16_t)y);
    mp_obj_t items[] = {
        MP_OBJ_NEW_SMALL_INT(strip.left),   MP_OBJ_NEW_SMALL_INT(strip.top),          MP_OBJ_NEW_SMALL_INT(strip.width),
        MP_OBJ_NEW_SMALL_INT(strip.height), view_of(self, strip.pixels, strip.bytes),
    };
    y = (mp_uint_t)strip.top + strip.height;
    mp_call_function_n_kw(take, MP_ARRAY_SIZE(items), 0, items);
  }
  return mp_const_none;
}
static MP_DEFINE_CONST_FUN_OBJ_2(draw_obj, player_draw);

/* draw_into(buffer): a frame in a buffer of the whole picture, such as that of a framebuf. */
static mp_obj_t player_draw_into(mp_obj_t object, mp_obj_t buffer) {
  player_obj* self = self_of(object);
  mp_buffer_info_t to;
  mp_get_buffer_raise(buffer, &to, MP_BUFFER_WRITE);
  player_begin(object);
  const zstrip_area whole = {0, 0, self->width, self->height};
  const size_t stride = ((size_t)self->width * self->pixel_bits + 7) / 8;
  check(self, zstrip_player_draw_area(self->player, &whole, to.buf, to.len, stride, NULL, 0));
  return mp_const_none;
}
static MP_DEFINE_CONST_FUN_OBJ_2(draw_into_obj, player_draw_into);

/* changed(): (left, top, width, height) of what differs from the frame when it was called before; None: nothing. */
static mp_obj_t player_changed(mp_obj_t object) {
  zstrip_area area;
  zstrip_player_changed(self_of(object)->player, &area);
  if (area.width == 0 || area.height == 0) return mp_const_none;
  mp_obj_t items[] = {MP_OBJ_NEW_SMALL_INT(area.left), MP_OBJ_NEW_SMALL_INT(area.top), MP_OBJ_NEW_SMALL_INT(area.width),
                      MP_OBJ_NEW_SMALL_INT(area.height)};
  return mp_obj_new_tuple(MP_ARRAY_SIZE(items), items);
}
static MP_DEFINE_CONST_FUN_OBJ_1(changed_obj, player_changed);

/* pick(x, y): (kind, index, triangle) of what a pixel shows; kind is BACKGROUND, INSTANCE, ... */
static mp_obj_t player_pick(mp_obj_t object, mp_obj_t x, mp_obj_t y) {
  player_obj* self = self_of(object);
  zstrip_picked picked;
  check(self, zstrip_player_pick(self->player, &zstrip_micropython_picker, half_of(x), half_of(y), &picked));
  mp_obj_t items[] = {MP_OBJ_NEW_SMALL_INT(picked.shown), MP_OBJ_NEW_SMALL_INT(picked.index),
                      mp_obj_new_int_from_uint(picked.triangle)};
  return mp_obj_new_tuple(MP_ARRAY_SIZE(items), items);
}
static MP_DEFINE_CONST_FUN_OBJ_3(pick_obj, player_pick);

/* clips(): [(name, milliseconds), ...] */
static mp_obj_t player_clips(mp_obj_t object) {
  zstrip_player* player = self_of(object)->player;
  mp_obj_t list = mp_obj_new_list(0, NULL);
  for (size_t clip = 0; clip < zstrip_player_clips(player); ++clip) {
    mp_obj_t items[] = {str_of(zstrip_player_clip_name(player, clip)),
                        mp_obj_new_int_from_uint(zstrip_player_clip_time(player, clip))};
    mp_obj_list_append(list, mp_obj_new_tuple(MP_ARRAY_SIZE(items), items));
  }
  return list;
}
static MP_DEFINE_CONST_FUN_OBJ_1(clips_obj, player_clips);

static bool same(const char* a, const char* b) {
  for (; *a != '\0' && *a == *b; ++a) ++b;
  return *a == *b;
}

/* play_clip(clip, fade=0, loops=True): a number or a name. */
static mp_obj_t player_play_clip(size_t count, const mp_obj_t* arguments) {
  player_obj* self = self_of(arguments[0]);
  size_t clip = 0;
  if (mp_obj_is_str(arguments[1])) {
    const char* name = mp_obj_str_get_str(arguments[1]);
    const size_t clips = zstrip_player_clips(self->player);
    while (clip < clips && !same(zstrip_player_clip_name(self->player, clip), name)) ++clip;
  } else {
    clip = half_of(arguments[1]);
  }
  const uint16_t fade = count > 2 ? half_of(arguments[2]) : 0;
  check(self, zstrip_player_play_clip(self->player, clip, fade, count > 3 ? mp_obj_is_true(arguments[3]) : 1));
  return mp_const_none;
}
static MP_DEFINE_CONST_FUN_OBJ_VAR_BETWEEN(play_clip_obj, 2, 4, player_play_clip);

/* poll_event(): the number of the next event that the clip has reached, or None. */
static mp_obj_t player_poll_event(mp_obj_t object) {
  uint16_t number = 0;
  if (!zstrip_player_poll_event(self_of(object)->player, &number)) return mp_const_none;
  return MP_OBJ_NEW_SMALL_INT(number);
}
static MP_DEFINE_CONST_FUN_OBJ_1(poll_event_obj, player_poll_event);

static mp_obj_t player_play(mp_obj_t object, mp_obj_t milliseconds) {
  zstrip_player_play(self_of(object)->player, word_of(milliseconds));
  return mp_const_none;
}
static MP_DEFINE_CONST_FUN_OBJ_2(play_obj, player_play);

static mp_obj_t player_hold(mp_obj_t object, mp_obj_t held) {
  zstrip_player_hold(self_of(object)->player, mp_obj_is_true(held));
  return mp_const_none;
}
static MP_DEFINE_CONST_FUN_OBJ_2(hold_obj, player_hold);

static mp_obj_t player_seek(mp_obj_t object, mp_obj_t milliseconds) {
  zstrip_player_seek(self_of(object)->player, word_of(milliseconds));
  return mp_const_none;
}
static MP_DEFINE_CONST_FUN_OBJ_2(seek_obj, player_seek);

static mp_obj_t player_time(mp_obj_t object) {
  return mp_obj_new_int_from_uint(zstrip_player_time(self_of(object)->player));
}
static MP_DEFINE_CONST_FUN_OBJ_1(time_obj, player_time);

static mp_obj_t player_period(mp_obj_t object) {
  return mp_obj_new_int_from_uint(zstrip_player_period(self_of(object)->player));
}
static MP_DEFINE_CONST_FUN_OBJ_1(period_obj, player_period);

/* orbit(right, up): 65536 is 360 degrees; negative angles, too. */
static mp_obj_t player_orbit(mp_obj_t object, mp_obj_t right, mp_obj_t up) {
  zstrip_player_orbit(self_of(object)->player, (uint16_t)word_of(right), (uint16_t)word_of(up));
  return mp_const_none;
}
static MP_DEFINE_CONST_FUN_OBJ_3(orbit_obj, player_orbit);

static mp_obj_t player_zoom(mp_obj_t object, mp_obj_t percent) {
  zstrip_player_zoom(self_of(object)->player, half_of(percent));
  return mp_const_none;
}
static MP_DEFINE_CONST_FUN_OBJ_2(zoom_obj, player_zoom);

/* background(0xRRGGBB), or None for the scene's own. */
static mp_obj_t player_background(mp_obj_t object, mp_obj_t colour) {
  zstrip_player_background(self_of(object)->player,
                           colour == mp_const_none ? ZSTRIP_BAKED_BACKGROUND : word_of(colour) & 0xFFFFFF);
  return mp_const_none;
}
static MP_DEFINE_CONST_FUN_OBJ_2(background_obj, player_background);

static mp_obj_t player_text(mp_obj_t object, mp_obj_t text) {
  zstrip_player_show_text(self_of(object)->player, mp_obj_str_get_str(text), 0);
  return mp_const_none;
}
static MP_DEFINE_CONST_FUN_OBJ_2(text_obj, player_text);

/* Tables are filled from these rows: constant ones in a firmware, those of a native module when it is imported. */
#define PLAYER_METHODS(METHOD)               \
  METHOD(MP_QSTR_open, open_obj)             \
  METHOD(MP_QSTR_fit, fit_obj)               \
  METHOD(MP_QSTR_begin, begin_obj)           \
  METHOD(MP_QSTR_strip, strip_obj)           \
  METHOD(MP_QSTR_draw, draw_obj)             \
  METHOD(MP_QSTR_draw_into, draw_into_obj)   \
  METHOD(MP_QSTR_changed, changed_obj)       \
  METHOD(MP_QSTR_pick, pick_obj)             \
  METHOD(MP_QSTR_clips, clips_obj)           \
  METHOD(MP_QSTR_play_clip, play_clip_obj)   \
  METHOD(MP_QSTR_poll_event, poll_event_obj) \
  METHOD(MP_QSTR_play, play_obj)             \
  METHOD(MP_QSTR_hold, hold_obj)             \
  METHOD(MP_QSTR_seek, seek_obj)             \
  METHOD(MP_QSTR_time, time_obj)             \
  METHOD(MP_QSTR_period, period_obj)         \
  METHOD(MP_QSTR_orbit, orbit_obj)           \
  METHOD(MP_QSTR_zoom, zoom_obj)             \
  METHOD(MP_QSTR_background, background_obj) \
  METHOD(MP_QSTR_text, text_obj)

#define MODULE_NUMBERS(NUMBER)                          \
  NUMBER(MP_QSTR_RGB565, ZSTRIP_RGB565)                 \
  NUMBER(MP_QSTR_RGB565_SWAPPED, ZSTRIP_RGB565_SWAPPED) \
  NUMBER(MP_QSTR_GRAY4, ZSTRIP_GRAY4)                   \
  NUMBER(MP_QSTR_MONO, ZSTRIP_MONO)                     \
  NUMBER(MP_QSTR_RGB666, ZSTRIP_RGB666)                 \
  NUMBER(MP_QSTR_RGB444, ZSTRIP_RGB444)                 \
  NUMBER(MP_QSTR_XRGB8888, ZSTRIP_XRGB8888)             \
  NUMBER(MP_QSTR_BACKGROUND, ZSTRIP_BACKGROUND)         \
  NUMBER(MP_QSTR_INSTANCE, ZSTRIP_INSTANCE)             \
  NUMBER(MP_QSTR_OUTLINE, ZSTRIP_OUTLINE)               \
  NUMBER(MP_QSTR_QUADRIC, ZSTRIP_QUADRIC)               \
  NUMBER(MP_QSTR_LINE, ZSTRIP_LINE)                     \
  NUMBER(MP_QSTR_SPRITE, ZSTRIP_SPRITE)                 \
  NUMBER(MP_QSTR_LABEL, ZSTRIP_LABEL)

#if defined(MICROPY_ENABLE_DYNRUNTIME)

/* Not static, because only the table of global offsets can address writable data. */
#define COUNT(name, object) +1
mp_map_elem_t zstrip_player_locals[PLAYER_METHODS(COUNT)];
static MP_DEFINE_CONST_DICT(player_locals_dict, zstrip_player_locals);
mp_obj_full_type_t zstrip_player_type;

mp_obj_t mpy_init(mp_obj_fun_bc_t* self, size_t count, size_t named, mp_obj_t* arguments) {
  MP_DYNRUNTIME_INIT_ENTRY
  mp_map_elem_t* method = zstrip_player_locals;
#define STORE_METHOD(name, object) *method++ = (mp_map_elem_t){MP_OBJ_NEW_QSTR(name), MP_OBJ_FROM_PTR(&object)};
  PLAYER_METHODS(STORE_METHOD)
  zstrip_player_type.base.type = &mp_type_type;
  zstrip_player_type.name = MP_QSTR_Player;
  MP_OBJ_TYPE_SET_SLOT(&zstrip_player_type, make_new, make_player, 0);
  MP_OBJ_TYPE_SET_SLOT(&zstrip_player_type, locals_dict, (void*)&player_locals_dict, 1);
  mp_store_global(MP_QSTR_Player, MP_OBJ_FROM_PTR(&zstrip_player_type));
#define STORE_NUMBER(name, number) mp_store_global(name, MP_OBJ_NEW_SMALL_INT(number));
  MODULE_NUMBERS(STORE_NUMBER)
  MP_DYNRUNTIME_INIT_EXIT
}

#else

#define METHOD_ROW(name, object) {MP_ROM_QSTR(name), MP_ROM_PTR(&object)},
static const mp_rom_map_elem_t player_locals[] = {PLAYER_METHODS(METHOD_ROW)};
static MP_DEFINE_CONST_DICT(player_locals_dict, player_locals);

static MP_DEFINE_CONST_OBJ_TYPE(player_type, MP_QSTR_Player, MP_TYPE_FLAG_NONE, make_new, make_player, locals_dict,
                                &player_locals_dict);

#define NUMBER_ROW(name, number) {MP_ROM_QSTR(name), MP_ROM_INT(number)},
static const mp_rom_map_elem_t module_globals[] = {{MP_ROM_QSTR(MP_QSTR___name__), MP_ROM_QSTR(MP_QSTR_zstrip)},
                                                   {MP_ROM_QSTR(MP_QSTR_Player), MP_ROM_PTR(&player_type)},
                                                   MODULE_NUMBERS(NUMBER_ROW)};
static MP_DEFINE_CONST_DICT(module_globals_dict, module_globals);

const mp_obj_module_t zstrip_user_cmodule = {
    .base = {&mp_type_module},
    .globals = (mp_obj_dict_t*)&module_globals_dict,
};

MP_REGISTER_MODULE(MP_QSTR_zstrip, zstrip_user_cmodule);

#endif
