/* What a program in C does with zstrip_player.h. */
#ifndef C_PROGRAM_H
#define C_PROGRAM_H

#include <zstrip_player.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct {
  unsigned char* pixels; /* RGB565 */
  uint16_t width, height;
  int strips;
} picture;

/* Draws the scene as it is after so many milliseconds, with a text; the words of the error, or "". */
const char* show(picture* to, const void* scene, size_t scene_bytes, void* memory, size_t memory_bytes,
                 const zstrip_pipeline* pipeline, uint32_t milliseconds);

/* Opens and fits the scene, and finds what the middle of the picture shows; the words of the error, or "". */
const char* pick_middle(zstrip_picked* picked, const void* scene, size_t scene_bytes, void* memory, size_t memory_bytes,
                        const zstrip_pipeline* pipeline, const zstrip_picker* picker);

/* Fits any number as the format; only C has such values of an enumeration. */
int fit_format(zstrip_player* player, long format);

#ifdef __cplusplus
}
#endif
#endif
