/* The widget of lv_zstrip.h: an image for LVGL, whose decoder draws the strips that LVGL asks for. Without LVGL 9 this
 * file is empty, because packages compile every file. */
#if defined(__has_include)
#if __has_include("lvgl.h") && __has_include("lvgl_private.h")
#include "lvgl.h"
#if LVGL_VERSION_MAJOR >= 9
#define LV_ZSTRIP_HAS_LVGL
#endif
#endif
#endif

#ifdef LV_ZSTRIP_HAS_LVGL

#include "lv_zstrip.h"
#include "lvgl_private.h"

typedef struct {
  lv_obj_t obj;
  lv_image_dsc_t source; /* LVGL finds the decoder by it */
  lv_draw_buf_t rows;    /* the strip that was drawn last */
  lv_mutex_t drawing;    /* held from the first area that LVGL asks for to the last one */
  lv_timer_t* timer;
  lv_zstrip_scene_t scene;
  zstrip_player* player;    /* null without a scene */
  const char* error;        /* "" if nothing is wrong */
  uint32_t ticks;           /* of LVGL, when the motion moved last */
  uint32_t clock;           /* milliseconds that were played, for scenes with clips */
  uint32_t time, from, to;  /* milliseconds of the motion */
  uint32_t background;      /* 0xRRGGBB, mixed into smoothed edges of a transparent widget */
  lv_area_t drag;           /* x1, y1: the moves since the press, at most 65535; x2, y2: the angles at the press */
  uint16_t right, up, zoom; /* 65536 is 360 degrees; percent */
  zstrip_picked picked;
  unsigned transparent : 1, playing : 1, interactive : 1;
  unsigned fitted : 1;    /* a plan for the widget's size and transparency was tried */
  unsigned planned : 1;   /* and there is one */
  unsigned has_clips : 1; /* the player keeps the time */
  unsigned moved : 1;     /* the next frame differs */
  unsigned failed : 1;    /* while drawing, when nothing can be invalidated */
  unsigned dragged : 1;   /* too far for a click */
} lv_zstrip_t;

/* What the data of an image source points at, if a widget is the source. */
static const uint8_t source_tag = 0;

static lv_zstrip_t* widget_of(const void* source) {
  const lv_image_dsc_t* image = source;
  if (lv_image_src_get_type(source) != LV_IMAGE_SRC_VARIABLE || image->data != &source_tag) return NULL;
  return (lv_zstrip_t*)((uintptr_t)source - offsetof(lv_zstrip_t, source));
}

static void fail(lv_zstrip_t* widget, const char* error) {
  widget->error = error;
  LV_LOG_ERROR("lv_zstrip: %s", error);
}

/* The decoder */

static lv_result_t image_info(lv_image_decoder_t* decoder, lv_image_decoder_dsc_t* dsc, lv_image_header_t* header) {
  LV_UNUSED(decoder);
  const lv_zstrip_t* widget = dsc->src_type == LV_IMAGE_SRC_VARIABLE ? widget_of(dsc->src) : NULL;
  if (widget == NULL) return LV_RESULT_INVALID;
  *header = widget->source.header;
  return LV_RESULT_OK;
}

static lv_result_t open_image(lv_image_decoder_t* decoder, lv_image_decoder_dsc_t* dsc) {
  LV_UNUSED(decoder);
  dsc->decoded = NULL; /* LVGL asks for areas */
  return LV_RESULT_OK;
}

/* LVGL calls it until it returns LV_RESULT_INVALID. Other threads of LVGL may draw other parts of the widget meanwhile:
 * they wait, because there is one buffer. */
static lv_result_t next_area(lv_image_decoder_t* decoder, lv_image_decoder_dsc_t* dsc, const lv_area_t* wanted,
                             lv_area_t* area) {
  LV_UNUSED(decoder);
  lv_zstrip_t* widget = widget_of(dsc->src);
  const bool is_first = area->y1 == LV_COORD_MIN;
  if (is_first) lv_mutex_lock(&widget->drawing);
  const int32_t row = is_first ? LV_MAX(wanted->y1, 0) : area->y2 + 1;
  zstrip_strip strip;
  const bool is_inside = row <= wanted->y2 && row < (int32_t)widget->source.header.h;
  if (!is_inside || !zstrip_player_strip(widget->player, (uint16_t)row, &strip)) {
    if (is_inside) widget->failed = 1;
    lv_mutex_unlock(&widget->drawing);
    return LV_RESULT_INVALID;
  }
  /* In RGB565A8 the alpha bytes follow the pixels, as the mask does. */
  lv_draw_buf_t* rows = &widget->rows;
  rows->header = widget->source.header;
  rows->header.h = strip.height;
  rows->data = (uint8_t*)strip.pixels;
  rows->unaligned_data = rows->data;
  rows->data_size = (uint32_t)(strip.bytes + (strip.mask != NULL ? strip.bytes / 2 : 0));
  dsc->decoded = rows;
  lv_area_set(area, strip.left, strip.top, strip.left + strip.width - 1, strip.top + strip.height - 1);
  return LV_RESULT_OK;
}

static void close_image(lv_image_decoder_t* decoder, lv_image_decoder_dsc_t* dsc) {
  LV_UNUSED(decoder);
  LV_UNUSED(dsc);
}

/* Adds the decoder to LVGL's list, once between lv_init and lv_deinit. */
static bool add_decoder(void) {
  lv_image_decoder_t* decoder = NULL;
  while ((decoder = lv_image_decoder_get_next(decoder)) != NULL) {
    if (decoder->info_cb == image_info) return true;
  }
  decoder = lv_image_decoder_create();
  if (decoder == NULL) return false;
  decoder->name = "zstrip";
  lv_image_decoder_set_info_cb(decoder, image_info);
  lv_image_decoder_set_open_cb(decoder, open_image);
  lv_image_decoder_set_get_area_cb(decoder, next_area);
  lv_image_decoder_set_close_cb(decoder, close_image);
  return true;
}

/* Frames */

/* Returns the colour behind the model: that of the widget's background, or else of the nearest parent that has one. */
static uint32_t background_behind(lv_obj_t* obj) {
  for (; obj != NULL; obj = lv_obj_get_parent(obj)) {
    if (lv_obj_get_style_bg_opa(obj, LV_PART_MAIN) < LV_OPA_50) continue;
    const lv_color_t colour = lv_obj_get_style_bg_color_filtered(obj, LV_PART_MAIN);
    return lv_color_to_u32(colour) & 0xFFFFFF;
  }
  return 0;
}

static void begin_frame(lv_zstrip_t* widget) {
  zstrip_player* player = widget->player;
  if (!widget->has_clips) zstrip_player_seek(player, widget->time);
  zstrip_player_orbit(player, widget->right, widget->up);
  zstrip_player_zoom(player, widget->zoom);
  zstrip_player_background(player, widget->transparent ? widget->background : ZSTRIP_BAKED_BACKGROUND);
  widget->moved = 0;
  widget->error = "";
  if (!zstrip_player_begin(player)) fail(widget, zstrip_player_error(player));
}

/* Plans the picture, and begins a frame, if the widget has another size than before. False if nothing can be drawn. */
static bool prepare(lv_zstrip_t* widget) {
  if (widget->player == NULL) return false;
  if (widget->fitted) return widget->planned && widget->error[0] == 0;
  lv_area_t content;
  lv_obj_get_content_coords(&widget->obj, &content);
  const int32_t width = lv_area_get_width(&content), height = lv_area_get_height(&content);
  if (width <= 0 || height <= 0) return false;
  widget->fitted = 1;
  widget->planned = 0;
  widget->error = "";
  /* Also of a size that cannot be drawn: the next one is compared with it. */
  lv_image_header_t* header = &widget->source.header;
  header->w = (uint32_t)width & 0xFFFF;
  header->h = (uint32_t)height & 0xFFFF;
#if !LV_USE_DRAW_SW || !LV_DRAW_SW_SUPPORT_RGB565
  fail(widget, "lv_conf.h has no LV_USE_DRAW_SW, or no LV_DRAW_SW_SUPPORT_RGB565");
  return false;
#endif
  if (width > 4096 || height > 4096) {
    fail(widget, "the widget is larger than 4096 pixels");
    return false;
  }
  const zstrip_fit_options options = {0, 1, widget->transparent, 1};
  if (!zstrip_player_fit_with(widget->player, (uint16_t)width, (uint16_t)height, ZSTRIP_RGB565, &options)) {
    fail(widget, zstrip_player_error(widget->player));
    return false;
  }
  widget->planned = 1;
  header->magic = LV_IMAGE_HEADER_MAGIC;
  header->cf = widget->transparent ? LV_COLOR_FORMAT_RGB565A8 : LV_COLOR_FORMAT_RGB565;
  header->stride = (uint32_t)(2 * width) & 0xFFFF;
  if (widget->transparent) widget->background = background_behind(&widget->obj);
  begin_frame(widget);
  zstrip_area all;
  zstrip_player_changed(widget->player, &all); /* LVGL draws all of the widget by itself */
  return widget->error[0] == 0;
}

static void fit_again(lv_zstrip_t* widget) {
  widget->fitted = 0;
  lv_obj_invalidate(&widget->obj);
}

/* Advances the motion by the time since it was advanced last. */
static void advance(lv_zstrip_t* widget) {
  uint32_t passed = lv_tick_elaps(widget->ticks);
  widget->ticks = lv_tick_get();
  if (!widget->playing || passed == 0) return;
  widget->moved = 1;
  if (widget->has_clips) {
    widget->clock += passed;
    zstrip_player_play(widget->player, widget->clock);
    return;
  }
  const uint32_t end = widget->to > widget->from ? widget->to : zstrip_player_period(widget->player);
  const uint32_t begin = widget->to > widget->from ? widget->from : 0;
  if (widget->time < begin) { /* it was set to a time before the part, and plays up to it */
    const uint32_t before = LV_MIN(begin - widget->time, passed);
    widget->time += before;
    passed -= before;
    if (widget->time < begin) return;
  }
  const uint32_t time = widget->time - begin + passed % (end - begin);
  widget->time = begin + time % (end - begin);
}

/* Begins the next frame, and has LVGL draw the rectangle that changed. */
static void show_next(lv_zstrip_t* widget) {
  const bool was_wrong = widget->error[0] != 0;
  begin_frame(widget);
  zstrip_area changed;
  zstrip_player_changed(widget->player, &changed);
  if (was_wrong || widget->error[0] != 0) {
    lv_obj_invalidate(&widget->obj);
  } else if (changed.width != 0) {
    lv_area_t area;
    lv_obj_get_content_coords(&widget->obj, &area);
    lv_area_set(&area, area.x1 + changed.left, area.y1 + changed.top, area.x1 + changed.left + changed.width - 1,
                area.y1 + changed.top + changed.height - 1);
    lv_obj_invalidate_area(&widget->obj, &area);
  }
}

static void step(lv_timer_t* timer) {
  lv_zstrip_t* widget = lv_timer_get_user_data(timer);
  if (widget->player == NULL) return;
  if (widget->failed) {
    widget->failed = 0;
    fail(widget, zstrip_player_error(widget->player));
    lv_obj_invalidate(&widget->obj);
  }
  advance(widget);
  if (!lv_obj_is_visible(&widget->obj)) return;
  prepare(widget);
  if (!widget->planned) return;
  if (widget->transparent && widget->background != background_behind(&widget->obj)) {
    widget->background = background_behind(&widget->obj);
    widget->moved = 1;
  }
  if (widget->moved) show_next(widget);
}

/* Drawing */

static bool takes_rgb565(lv_color_format_t format) {
  switch (format) {
    case LV_COLOR_FORMAT_RGB565:
    case LV_COLOR_FORMAT_RGB565A8:
    case LV_COLOR_FORMAT_RGB565_SWAPPED:
    case LV_COLOR_FORMAT_RGB888:
    case LV_COLOR_FORMAT_XRGB8888:
    case LV_COLOR_FORMAT_ARGB8888:
    case LV_COLOR_FORMAT_ARGB8888_PREMULTIPLIED:
    case LV_COLOR_FORMAT_L8:
    case LV_COLOR_FORMAT_AL88: return true;
    default: return false;
  }
}

static void draw_words(lv_layer_t* layer, lv_zstrip_t* widget, const char* words) {
  lv_draw_label_dsc_t dsc;
  lv_draw_label_dsc_init(&dsc);
  dsc.base.layer = layer;
  lv_obj_init_draw_label_dsc(&widget->obj, LV_PART_MAIN, &dsc);
  dsc.text = words;
  dsc.text_local = 1;
  lv_area_t area;
  lv_obj_get_content_coords(&widget->obj, &area);
  /* LVGL draws longer words beyond the area in some of its pieces of a screen, and not in others. */
  const lv_area_t whole = layer->_clip_area;
  if (lv_area_intersect(&layer->_clip_area, &whole, &area)) lv_draw_label(layer, &dsc, &area);
  layer->_clip_area = whole;
}

static void draw(lv_event_t* e, lv_zstrip_t* widget) {
  lv_layer_t* layer = lv_event_get_layer(e);
  const bool is_ready = prepare(widget);
  if (is_ready && !takes_rgb565(layer->color_format)) {
    /* Another layer may have another format: this is no fault of the widget. */
    static const char words[] = "a display of this colour format cannot show RGB565";
    LV_LOG_ERROR("lv_zstrip: %s: lv_color_format_t %d", words, (int)layer->color_format);
    draw_words(layer, widget, words);
  } else if (is_ready) {
    lv_area_t area;
    lv_obj_get_content_coords(&widget->obj, &area);
    lv_draw_image_dsc_t dsc;
    lv_draw_image_dsc_init(&dsc);
    dsc.base.layer = layer;
    lv_obj_init_draw_image_dsc(&widget->obj, LV_PART_MAIN, &dsc);
    dsc.src = &widget->source;
    dsc.clip_radius = lv_obj_get_style_radius(&widget->obj, LV_PART_MAIN);
    dsc.image_area = area;
    lv_draw_image(layer, &dsc, &area);
  } else if (widget->error[0] != 0) {
    draw_words(layer, widget, widget->error);
  }
}

/* Tells LVGL that it need not draw what is behind an opaque picture. */
static void check_cover(lv_event_t* e, lv_zstrip_t* widget) {
  lv_cover_check_info_t* info = lv_event_get_param(e);
  lv_obj_t* obj = &widget->obj;
  if (info->res == LV_COVER_RES_MASKED || widget->transparent || !prepare(widget)) return;
  lv_area_t content;
  lv_obj_get_content_coords(obj, &content);
  if (lv_obj_get_style_image_opa(obj, LV_PART_MAIN) < LV_OPA_MAX ||
      lv_obj_get_style_opa(obj, LV_PART_MAIN) < LV_OPA_MAX ||
      !lv_area_is_in(info->area, &content, lv_obj_get_style_radius(obj, LV_PART_MAIN))) {
    return;
  }
  info->res = LV_COVER_RES_COVER;
}

/* Touches */

static void set_orbit(lv_zstrip_t* widget, int32_t right, int32_t up) {
  const int32_t limit = 65536 * 80 / 360;
  widget->right = (uint16_t)right;
  widget->up = (uint16_t)LV_CLAMP(-limit, up, limit);
  widget->moved = 1;
}

/* 32768 times the sum, and an angle more, are an int32_t. LVGL's coordinates are below 2^29. */
static int32_t add_move(int32_t sum, int32_t move) {
  const int32_t limit = 65535;
  return LV_CLAMP(-limit, sum + move, limit);
}

/* Half a turn for the widget's width: the model follows the finger. */
static void drag(lv_zstrip_t* widget, lv_indev_t* indev) {
  if (indev == NULL || !widget->interactive) return;
  lv_point_t move;
  lv_indev_get_vect(indev, &move);
  if (move.x == 0 && move.y == 0) return;
  widget->drag.x1 = add_move(widget->drag.x1, move.x);
  widget->drag.y1 = add_move(widget->drag.y1, move.y);
  const int32_t limit = indev->scroll_limit;
  if (LV_ABS(widget->drag.x1) > limit || LV_ABS(widget->drag.y1) > limit) widget->dragged = 1;
  if (!widget->dragged) return;
  const int32_t width = LV_MAX(lv_obj_get_width(&widget->obj), 1);
  set_orbit(widget, widget->drag.x2 - widget->drag.x1 * 32768 / width,
            widget->drag.y2 + widget->drag.y1 * 32768 / width);
}

static void click(lv_zstrip_t* widget, lv_indev_t* indev) {
  if (indev == NULL || widget->dragged || widget->scene.picker == NULL) return;
  lv_point_t point;
  lv_indev_get_point(indev, &point);
  lv_obj_transform_point(&widget->obj, &point, LV_OBJ_POINT_TRANSFORM_FLAG_INVERSE_RECURSIVE);
  lv_area_t content;
  lv_obj_get_content_coords(&widget->obj, &content);
  zstrip_picked picked;
  if (!lv_zstrip_pick(&widget->obj, point.x - content.x1, point.y - content.y1, &picked)) return;
  widget->picked = picked;
  lv_obj_send_event(&widget->obj, LV_EVENT_VALUE_CHANGED, &widget->picked);
}

/* The class */

/* LVGL has these two from 9.6 on, where it calls functions for flags deprecated. */
static void set_scrollable(lv_obj_t* obj, bool scrollable) {
#if LV_VERSION_CHECK(9, 6, 0)
  lv_obj_set_scrollable(obj, scrollable);
#else
  (scrollable ? lv_obj_add_flag : lv_obj_remove_flag)(obj, LV_OBJ_FLAG_SCROLLABLE);
#endif
}

static void set_scroll_chain(lv_obj_t* obj, bool chain) {
#if LV_VERSION_CHECK(9, 6, 0)
  lv_obj_set_scroll_chain(obj, chain);
#else
  (chain ? lv_obj_add_flag : lv_obj_remove_flag)(obj, LV_OBJ_FLAG_SCROLL_CHAIN);
#endif
}

static void construct(const lv_obj_class_t* class_p, lv_obj_t* obj) {
  LV_UNUSED(class_p);
  lv_zstrip_t* widget = (lv_zstrip_t*)obj;
  widget->error = "";
  widget->zoom = 100;
  widget->source.header.magic = LV_IMAGE_HEADER_MAGIC;
  widget->source.data = &source_tag;
  widget->interactive = 1;
  lv_mutex_init(&widget->drawing);
  set_scrollable(obj, false);
  set_scroll_chain(obj, false);
  widget->timer = lv_timer_create(step, LV_DEF_REFR_PERIOD, widget);
  if (!add_decoder() || widget->timer == NULL) fail(widget, "LVGL has no memory for the widget");
}

static void destruct(const lv_obj_class_t* class_p, lv_obj_t* obj) {
  LV_UNUSED(class_p);
  lv_zstrip_t* widget = (lv_zstrip_t*)obj;
  if (widget->timer != NULL) lv_timer_delete(widget->timer);
  lv_mutex_delete(&widget->drawing);
}

static void handle_event(const lv_obj_class_t* class_p, lv_event_t* e) {
  LV_UNUSED(class_p);
  if (lv_obj_event_base(&lv_zstrip_class, e) != LV_RESULT_OK) return;
  lv_zstrip_t* widget = (lv_zstrip_t*)lv_event_get_current_target(e);
  switch (lv_event_get_code(e)) {
    case LV_EVENT_DRAW_MAIN: draw(e, widget); break;
    case LV_EVENT_COVER_CHECK: check_cover(e, widget); break;
    case LV_EVENT_SIZE_CHANGED:
    case LV_EVENT_STYLE_CHANGED: {
      /* Only another size of the picture needs another plan. */
      lv_area_t content;
      lv_obj_get_content_coords(&widget->obj, &content);
      if (lv_area_get_width(&content) != (int32_t)widget->source.header.w ||
          lv_area_get_height(&content) != (int32_t)widget->source.header.h) {
        fit_again(widget);
      }
      break;
    }
    case LV_EVENT_PRESSED:
      widget->dragged = 0;
      lv_area_set(&widget->drag, 0, 0, (int16_t)widget->right, (int16_t)widget->up);
      break;
    case LV_EVENT_PRESSING: drag(widget, lv_event_get_indev(e)); break;
    case LV_EVENT_CLICKED: click(widget, lv_event_get_indev(e)); break;
    case LV_EVENT_ROTARY:
      if (widget->interactive) {
        const int32_t zoom = widget->zoom + (int32_t)widget->zoom * lv_event_get_rotary_diff(e) / 10;
        lv_zstrip_set_zoom(&widget->obj, (uint16_t)LV_CLAMP(10, zoom, 1000));
      }
      break;
    default: break;
  }
}

const lv_obj_class_t lv_zstrip_class = {
    .base_class = &lv_obj_class,
    .constructor_cb = construct,
    .destructor_cb = destruct,
    .event_cb = handle_event,
    .name = "lv_zstrip",
    .width_def = LV_DPI_DEF,
    .height_def = LV_DPI_DEF,
    .editable = LV_OBJ_CLASS_EDITABLE_TRUE, /* LVGL then sends it the turns of a wheel */
    .instance_size = sizeof(lv_zstrip_t),
};

/* What obj is. Another object fails an assertion of LVGL: LV_ASSERT_OBJ, which LVGL 9.6 calls deprecated. */
static lv_zstrip_t* checked(lv_obj_t* obj) {
  LV_ASSERT_NULL(obj);
#if LV_USE_ASSERT_OBJ
  LV_ASSERT_MSG(lv_obj_has_class(obj, &lv_zstrip_class), "this object is no lv_zstrip");
  LV_ASSERT_MSG(lv_obj_is_valid(obj), "this lv_zstrip is deleted or corrupt");
#endif
  return (lv_zstrip_t*)obj;
}

lv_obj_t* lv_zstrip_create(lv_obj_t* parent) {
  lv_obj_t* obj = lv_obj_class_create_obj(&lv_zstrip_class, parent);
  if (obj != NULL) lv_obj_class_init_obj(obj);
  return obj;
}

bool lv_zstrip_set_scene(lv_obj_t* obj, const lv_zstrip_scene_t* scene) {
  lv_zstrip_t* widget = checked(obj);
  widget->player = NULL;
  widget->error = "";
  widget->time = widget->from = widget->to = 0;
  widget->right = widget->up = 0;
  widget->zoom = 100;
  widget->ticks = lv_tick_get();
  widget->playing = 1;
  fit_again(widget);
  if (scene == NULL) return true;
  widget->scene = *scene;
  zstrip_player* player = zstrip_player_in(scene->memory, scene->memory_bytes, scene->pipeline);
  if (player == NULL) {
    fail(widget, "the memory is too small for the player, or an address is null");
    return false;
  }
  if (!zstrip_player_open(player, scene->scene, scene->scene_bytes)) {
    fail(widget, zstrip_player_error(player));
    return false;
  }
  widget->player = player;
  widget->has_clips = zstrip_player_clips(player) != 0;
  widget->clock = 0;
  zstrip_player_play(player, 0);
  lv_obj_update_layout(obj);
  prepare(widget);
  return widget->error[0] == 0;
}

void lv_zstrip_set_transparent(lv_obj_t* obj, bool transparent) {
  lv_zstrip_t* widget = checked(obj);
  if (widget->transparent == transparent) return;
  widget->transparent = transparent;
  fit_again(widget);
}

void lv_zstrip_play(lv_obj_t* obj) {
  lv_zstrip_t* widget = checked(obj);
  if (!widget->playing) widget->ticks = lv_tick_get();
  widget->playing = 1;
}

void lv_zstrip_pause(lv_obj_t* obj) {
  lv_zstrip_t* widget = checked(obj);
  widget->playing = 0;
}

bool lv_zstrip_play_clip(lv_obj_t* obj, uint32_t clip, uint16_t fade, bool loops) {
  lv_zstrip_t* widget = checked(obj);
  /* The player's words would replace those that the widget may be showing. */
  if (!zstrip_player_play_clip(widget->player, clip, fade, loops)) {
    LV_LOG_WARN("lv_zstrip: there is no clip %u: the scene has %u clips", (unsigned)clip,
                (unsigned)lv_zstrip_get_clips(obj));
    return false;
  }
  widget->moved = 1;
  lv_zstrip_play(obj);
  return true;
}

uint32_t lv_zstrip_get_clips(lv_obj_t* obj) { return (uint32_t)zstrip_player_clips(checked(obj)->player); }

const char* lv_zstrip_get_clip_name(lv_obj_t* obj, uint32_t clip) {
  return zstrip_player_clip_name(checked(obj)->player, clip);
}

void lv_zstrip_set_part(lv_obj_t* obj, uint32_t from, uint32_t to) {
  lv_zstrip_t* widget = checked(obj);
  widget->from = from;
  widget->to = to;
  lv_zstrip_set_time(obj, to > from ? from : 0);
}

void lv_zstrip_set_time(lv_obj_t* obj, uint32_t time) {
  lv_zstrip_t* widget = checked(obj);
  if (widget->has_clips && widget->player != NULL) {
    zstrip_player_seek(widget->player, time);
  } else {
    widget->time = time;
  }
  widget->ticks = lv_tick_get();
  widget->moved = 1;
}

uint32_t lv_zstrip_get_time(lv_obj_t* obj) {
  lv_zstrip_t* widget = checked(obj);
  return widget->has_clips ? zstrip_player_time(widget->player) : widget->time;
}

/* Tenths of a degree, and 1/65536 of a turn; rounded to nearest. */
static int32_t angle_of(int32_t tenths) {
  const int64_t scaled = (int64_t)tenths * 65536;
  return (int32_t)((scaled + (scaled < 0 ? -1800 : 1800)) / 3600);
}
static int32_t tenths_of(uint16_t angle) {
  const int32_t scaled = (int32_t)(int16_t)angle * 3600;
  const int32_t tenths = (scaled + (scaled < 0 ? -32768 : 32768)) / 65536;
  return tenths < 1800 ? tenths : -1800; /* the same angle */
}

void lv_zstrip_set_orbit(lv_obj_t* obj, int32_t right, int32_t up) {
  set_orbit(checked(obj), angle_of(right), angle_of(LV_CLAMP(-900, up, 900)));
}

int32_t lv_zstrip_get_orbit_right(lv_obj_t* obj) { return tenths_of(checked(obj)->right); }

int32_t lv_zstrip_get_orbit_up(lv_obj_t* obj) { return tenths_of(checked(obj)->up); }

void lv_zstrip_set_zoom(lv_obj_t* obj, uint16_t percent) {
  lv_zstrip_t* widget = checked(obj);
  widget->zoom = (uint16_t)LV_CLAMP(10, percent, 1000);
  widget->moved = 1;
}

uint16_t lv_zstrip_get_zoom(lv_obj_t* obj) { return checked(obj)->zoom; }

void lv_zstrip_set_interactive(lv_obj_t* obj, bool interactive) {
  lv_zstrip_t* widget = checked(obj);
  widget->interactive = interactive;
  set_scroll_chain(obj, !interactive);
}

bool lv_zstrip_pick(lv_obj_t* obj, int32_t x, int32_t y, zstrip_picked* picked) {
  lv_zstrip_t* widget = checked(obj);
  if (!prepare(widget) || widget->scene.picker == NULL) return false;
  const lv_image_header_t* header = &widget->source.header;
  if (x < 0 || y < 0 || x >= (int32_t)header->w || y >= (int32_t)header->h) return false;
  return zstrip_player_pick(widget->player, widget->scene.picker, (uint16_t)x, (uint16_t)y, picked) != 0;
}

const char* lv_zstrip_get_error(lv_obj_t* obj) { return checked(obj)->error; }

#else

typedef int lv_zstrip_needs_lvgl; /* a file in C must not be empty */

#endif
