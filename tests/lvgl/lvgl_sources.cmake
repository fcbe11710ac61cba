# zstrip_add_lvgl(TARGET): LVGL itself, from the folder ZSTRIP_LVGL, without drivers and other makers' renderers.
function(zstrip_add_lvgl target)
  file(GLOB_RECURSE sources ${ZSTRIP_LVGL}/src/*.c)
  list(FILTER sources EXCLUDE REGEX
    "/(drivers|vg_lite|nxp|opengles|nema_gfx|renesas|espressif|eve|dma2d|nanovg|thorvg|gltf)/|/draw/sdl/")
  add_library(${target} STATIC EXCLUDE_FROM_ALL ${sources})
  target_include_directories(${target} SYSTEM PUBLIC ${ZSTRIP_LVGL} ${CMAKE_CURRENT_FUNCTION_LIST_DIR})
  target_compile_definitions(${target} PUBLIC LV_CONF_INCLUDE_SIMPLE)
  target_compile_options(${target} PRIVATE -w)
endfunction()
