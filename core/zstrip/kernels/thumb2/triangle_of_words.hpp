// Area and box of triangles whose vertices are words of both coordinates, y above x, in assembly. Processors with
// instructions for two halves of a word (Cortex-M4, M7, M33, M55) need half as many instructions.
//
// zstrip_triangle_area: computes twice the signed area of the vertices r4, r5 and r6 in r7. Changes r8, r9 and r12.
//
// zstrip_triangle_box: computes the box of the vertices r4 (the highest), r5 and r6, in pixels: left r7, top r4, right
// r8 and bottom r5. Compares the sum of its sides with kSmallExtent, for `hs`. Changes r6, r9 and r12.
//
// Each function contains this text, as in thumb1/macros.hpp.
#pragma once

#if defined(__ARM_FEATURE_DSP)

// Differences are below 2^15. ssub16 sets the flags with which sel selects halves.
#define ZSTRIP_TRIANGLE_OF_WORDS                                    \
  ".macro zstrip_triangle_area\n"                                   \
  "  ssub16 r9, r5, r4\n"                                           \
  "  ssub16 r12, r6, r4\n"                                          \
  "  smusdx r7, r12, r9\n"                                          \
  ".endm\n"                                                         \
  ".macro zstrip_triangle_box\n"                                    \
  "  ssub16 r7, r5, r4\n"                                           \
  "  sel   r8, r5, r4\n"                                            \
  "  sel   r9, r4, r5\n"                                            \
  "  ssub16 r7, r8, r6\n"                                           \
  "  sel   r8, r8, r6                @ greatest\n"                  \
  "  ssub16 r7, r6, r9\n"                                           \
  "  sel   r9, r9, r6                @ least\n"                     \
  "  ssub16 r6, r8, r9\n"                                           \
  "  add   r6, r6, r6, lsl #16       @ the sum in the upper half\n" \
  "  sbfx  r7, r9, #4, #12\n"                                       \
  "  asrs  r5, r8, #20\n"                                           \
  "  sbfx  r8, r8, #4, #12\n"                                       \
  "  asrs  r4, r4, #20\n"                                           \
  "  cmp   r6, #.Lsmall.extent << 16\n"                             \
  ".endm\n"

#else

#define ZSTRIP_TRIANGLE_OF_WORDS                                     \
  ".macro zstrip_triangle_area\n"                                    \
  "  sub   r9, r5, r4                @ differences are below 2^15\n" \
  "  sub   r12, r6, r4\n"                                            \
  "  asr   r8, r4, #16\n"                                            \
  "  sxth  r9, r9\n"                                                 \
  "  sxth  r12, r12\n"                                               \
  "  rsb   r7, r8, r5, asr #16\n"                                    \
  "  rsb   r8, r8, r6, asr #16\n"                                    \
  "  mul   r7, r12, r7\n"                                            \
  "  mls   r7, r9, r8, r7\n"                                         \
  ".endm\n"                                                          \
  ".macro zstrip_triangle_box\n"                                     \
  "  sxth  r7, r4\n"                                                 \
  "  sxth  r8, r5\n"                                                 \
  "  sxth  r9, r6\n"                                                 \
  "  asrs  r4, r4, #16               @ top\n"                        \
  "  asrs  r5, r5, #16\n"                                            \
  "  asrs  r6, r6, #16\n"                                            \
  "  cmp   r5, r6\n"                                                 \
  "  it    lt\n"                                                     \
  "  movlt r5, r6                    @ bottom\n"                     \
  "  cmp   r7, r8\n"                                                 \
  "  ittt  gt\n"                                                     \
  "  movgt r12, r7\n"                                                \
  "  movgt r7, r8\n"                                                 \
  "  movgt r8, r12\n"                                                \
  "  cmp   r9, r7\n"                                                 \
  "  it    lt\n"                                                     \
  "  movlt r7, r9                    @ left\n"                       \
  "  cmp   r9, r8\n"                                                 \
  "  it    gt\n"                                                     \
  "  movgt r8, r9                    @ right\n"                      \
  "  sub   r6, r8, r7\n"                                             \
  "  sub   r9, r5, r4\n"                                             \
  "  add   r6, r6, r9\n"                                             \
  "  asrs  r7, r7, #4\n"                                             \
  "  asr   r8, r8, #4\n"                                             \
  "  asrs  r4, r4, #4\n"                                             \
  "  asrs  r5, r5, #4\n"                                             \
  "  cmp   r6, #.Lsmall.extent\n"                                    \
  ".endm\n"

#endif
