/* picture FILE WIDTH HEIGHT: draws the scene of a .zsc with zstrip_player.h and writes the pixels, RGB565, to standard
   output. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <zstrip_player.h>

const zstrip_pipeline* scene_pipeline(void); /* of pipeline.cpp */

typedef struct {
  unsigned char* pixels;
  size_t row; /* bytes */
} picture;

static int take(void* context, const zstrip_strip* strip) {
  picture* to = context;
  const unsigned char* from = strip->pixels;
  uint16_t y;
  for (y = 0; y < strip->height; ++y) {
    memcpy(to->pixels + (size_t)(strip->top + y) * to->row + 2U * strip->left, from, 2U * strip->width);
    from += 2U * strip->width;
  }
  return 1;
}

int main(int count, char** words) {
  static uint32_t scene[64 * 1024]; /* at a multiple of 4 */
  static uint32_t memory[16 * 1024];
  zstrip_player* player = zstrip_player_in(memory, sizeof memory, scene_pipeline());
  FILE* file = count == 4 ? fopen(words[1], "rb") : NULL;
  size_t bytes, height;
  picture shown;
  if (player == NULL || file == NULL) return 2;
  bytes = fread(scene, 1, sizeof scene, file);
  fclose(file);
  shown.row = 2U * (size_t)atoi(words[2]);
  height = (size_t)atoi(words[3]);
  shown.pixels = calloc(height, shown.row);
  if (shown.pixels == NULL) return 2;
  if (!zstrip_player_open(player, scene, bytes) ||
      !zstrip_player_fit(player, (uint16_t)(shown.row / 2U), (uint16_t)height, ZSTRIP_RGB565, 1) ||
      !zstrip_player_draw(player, take, &shown)) {
    fprintf(stderr, "%s\n", zstrip_player_error(player));
    return 1;
  }
  return fwrite(shown.pixels, shown.row, height, stdout) == height ? 0 : 1;
}
