/* LVGL's settings for the tests of lv_zstrip: its software renderer with every format, few widgets. */
#ifndef LV_CONF_H
#define LV_CONF_H
#define LV_COLOR_DEPTH 16
#ifndef LV_MEM_SIZE /* a board has less */
#define LV_MEM_SIZE (1024 * 1024U)
#endif
#define LV_DEF_REFR_PERIOD 10
#define LV_USE_LOG 1
#define LV_LOG_LEVEL LV_LOG_LEVEL_WARN
#define LV_LOG_USE_TIMESTAMP 0
#define LV_USE_ASSERT_STYLE 1
#define LV_USE_ASSERT_OBJ 1
#define LV_USE_ASSERT_MEM_INTEGRITY 1
#define LV_ASSERT_HANDLER __builtin_abort(); /* no header: LVGL 9.6 has another name for the one of 9.5 */
#define LV_BUILD_EXAMPLES 0
#define LV_BUILD_DEMOS 0
#endif
