/* A gauge of LVGL 9 with a model in it: docs/lvgl.md. A runner turns a small planet; an arc around it shows how much of
 * the motion has passed, labels lie over it, and a button chooses what the runner does. A touch of the runner says what
 * was touched, and a drag looks at it from another side. */
#include "gauge.h"

#include "lv_zstrip.h"

/* The parts of the motion of host-sim/scenes/clips.toml, in milliseconds. */
typedef struct {
  const char* name;
  uint32_t from, to;
} clip_t;
static const clip_t clips[] = {{"walk", 400, 3000}, {"wave", 3500, 5200}, {"run", 5600, 8000}};

static lv_obj_t *model, *arc, *name, *touched;
static unsigned shown;

static void show_clip(unsigned clip) {
  shown = clip % (sizeof clips / sizeof clips[0]);
  lv_zstrip_set_part(model, clips[shown].from, clips[shown].to);
  lv_label_set_text_static(name, clips[shown].name);
}

static void next_clip(lv_event_t* e) {
  LV_UNUSED(e);
  show_clip(shown + 1);
}

static void show_touch(lv_event_t* e) {
  const zstrip_picked* picked = lv_event_get_param(e);
  if (picked->shown == ZSTRIP_INSTANCE) {
    lv_label_set_text_fmt(touched, "part %u", picked->index);
  } else {
    lv_label_set_text_static(touched, "nothing");
  }
}

static void show_time(lv_timer_t* timer) {
  LV_UNUSED(timer);
  const clip_t* clip = &clips[shown];
  lv_arc_set_value(arc, (int32_t)((lv_zstrip_get_time(model) - clip->from) * 100 / (clip->to - clip->from)));
}

bool show_gauge(lv_obj_t* parent, const lv_zstrip_scene_t* scene) {
  lv_obj_set_style_bg_color(parent, lv_color_hex(0x101828), 0);
  lv_obj_set_style_bg_grad_color(parent, lv_color_hex(0x285070), 0);
  lv_obj_set_style_bg_grad_dir(parent, LV_GRAD_DIR_VER, 0);
  lv_obj_set_style_text_color(parent, lv_color_hex(0xE0F0FF), 0);

  arc = lv_arc_create(parent);
  lv_obj_set_size(arc, 196, 196);
  lv_obj_align(arc, LV_ALIGN_TOP_MID, 0, 8);
  lv_arc_set_rotation(arc, 135);
  lv_arc_set_bg_angles(arc, 0, 270);
  lv_obj_remove_style(arc, NULL, LV_PART_KNOB);
#if LV_VERSION_CHECK(9, 6, 0)
  lv_obj_set_clickable(arc, false);
#else
  lv_obj_remove_flag(arc, LV_OBJ_FLAG_CLICKABLE);
#endif

  model = lv_zstrip_create(parent);
  lv_obj_set_size(model, 162, 162);
  lv_obj_set_style_radius(model, LV_RADIUS_CIRCLE, 0);
  lv_obj_align_to(model, arc, LV_ALIGN_CENTER, 0, 0);
  lv_zstrip_set_transparent(model, true);
  lv_obj_add_event_cb(model, show_touch, LV_EVENT_VALUE_CHANGED, NULL);

  name = lv_label_create(parent);
  lv_obj_align_to(name, arc, LV_ALIGN_BOTTOM_MID, 0, -24);
  touched = lv_label_create(parent);
  lv_obj_align(touched, LV_ALIGN_BOTTOM_LEFT, 12, -16);
  lv_label_set_text_static(touched, "touch it");

  lv_obj_t* button = lv_button_create(parent);
  lv_obj_align(button, LV_ALIGN_BOTTOM_RIGHT, -8, -6);
  lv_obj_add_event_cb(button, next_clip, LV_EVENT_CLICKED, NULL);
  lv_label_set_text_static(lv_label_create(button), "Next");

  const bool is_shown = lv_zstrip_set_scene(model, scene);
  show_clip(0);
  lv_timer_create(show_time, LV_DEF_REFR_PERIOD, NULL);
  return is_shown;
}
