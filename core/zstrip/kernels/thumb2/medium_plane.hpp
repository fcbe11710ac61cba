// Computes the plane of a value of 32 bits over a medium triangle, in assembly, as MediumPlanes::plane() does.
#pragma once

// zstrip_medium_plane start, step_y, step_x: stores the plane of a value r1 at vertex 0, with differences r2 and r3 to
// vertices 1 and 2, at these offsets from r0. Needs the mantissa of 1 / area in r4, the shifted weights of vertices 1
// and 2 (right r11 and r9, down r10 and r8), and the distance to the anchor in r12 and lr, as in MediumScan::shared.
// Changes r1 to r3 and r5 to r7. Each function contains it, as in thumb1/macros.hpp.
//
// zstrip_medium_step at, way: computes a step in r7 and r5 from its product with the area in r6 and r5, and stores it
// at offset `at`. Then r6 and r5 are the step times `way`.
#define ZSTRIP_MEDIUM_PLANE                                                   \
  ".macro zstrip_medium_step at, way\n"                                       \
  "  umull r7, r5, r5, r4\n"                                                  \
  "  movs  r7, #0\n"                                                          \
  "  smlal r5, r7, r6, r4\n"                                                  \
  "  lsrs  r5, r5, #11\n"                                                     \
  "  orr   r5, r5, r7, lsl #21\n"                                             \
  "  asrs  r7, r7, #11\n"                                                     \
  "  lsrs  r6, r5, #8                @ the carry is the bit that rounds\n"    \
  "  orr   r6, r6, r7, lsl #24\n"                                             \
  "  adc   r6, r6, #0\n"                                                      \
  "  str   r6, [r0, #\\at]\n"                                                 \
  "  add   r7, r7, r5, lsr #31       @ the lower word counts with its sign\n" \
  "  mul   r7, r7, \\way\n"                                                   \
  "  smull r5, r6, r5, \\way\n"                                               \
  "  add   r6, r6, r7\n"                                                      \
  ".endm\n"                                                                   \
  ".macro zstrip_medium_plane start, step_y, step_x\n"                        \
  "  smull r5, r6, r2, r11\n"                                                 \
  "  smlal r5, r6, r3, r9\n"                                                  \
  "  zstrip_medium_step \\step_x, r12\n"                                      \
  "  push  {r5, r6}\n"                                                        \
  "  smull r5, r6, r2, r10\n"                                                 \
  "  smlal r5, r6, r3, r8\n"                                                  \
  "  zstrip_medium_step \\step_y, lr\n"                                       \
  "  pop   {r2, r3}\n"                                                        \
  "  adds  r5, r5, r2\n"                                                      \
  "  adc   r6, r6, r3\n"                                                      \
  "  lsrs  r5, r5, #12\n"                                                     \
  "  orr   r5, r5, r6, lsl #20\n"                                             \
  "  add   r1, r1, r5\n"                                                      \
  "  str   r1, [r0, #\\start]\n"                                              \
  ".endm\n"
