/** The gauge of gauge.c. @file */
#ifndef GAUGE_H
#define GAUGE_H

#include "lv_zstrip.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Fills `parent`, 240x240 pixels, with the gauge. The scene: host-sim/scenes/clips.toml. False after a fault, which
 * the gauge then shows. */
bool show_gauge(lv_obj_t* parent, const lv_zstrip_scene_t* scene);

#ifdef __cplusplus
}
#endif
#endif
