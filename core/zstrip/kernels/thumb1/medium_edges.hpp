// The assembly at the start of each row of a medium triangle.
#pragma once

// zstrip_medium_edges: moves both edges of the scan in r0 a row down. Returns the row's first column in r7, the one
// after its last in r1, and the address after the edges, that of depth_row, in r6. Changes r2 to r5. Needs the names of
// thumb/medium_layout.hpp. Each function contains it, as in macros.hpp.
//
// zstrip_medium_edge at: moves the edge at offset `at`, whose address is in r6; r6 then points after it. Returns its
// column in r1.
#define ZSTRIP_THUMB1_MEDIUM_EDGES                                                         \
  ".macro zstrip_medium_edge at\n"                                                         \
  "  ldm   r6!, {r1-r5}            @ pixel, remainder, step, its remainder, denominator\n" \
  "  adds  r2, r2, r4              @ a carry: one more pixel\n"                            \
  "  bcc   .Lmedium_edge\\@\n"                                                             \
  "  subs  r2, r2, r5\n"                                                                   \
  "  adds  r3, r3, #1\n"                                                                   \
  ".Lmedium_edge\\@:\n"                                                                    \
  "  adds  r3, r3, r1\n"                                                                   \
  "  str   r3, [r0, #\\at + .Ledge.pixel]\n"                                               \
  "  str   r2, [r0, #\\at + .Ledge.remainder]\n"                                           \
  ".endm\n"                                                                                \
  ".macro zstrip_medium_edges\n"                                                           \
  "  movs  r6, r0\n"                                                                       \
  "  zstrip_medium_edge .Lmedium.left\n"                                                   \
  "  movs  r7, r1\n"                                                                       \
  "  zstrip_medium_edge .Lmedium.right\n"                                                  \
  ".endm\n"
#define ZSTRIP_THUMB1_PURGE_MEDIUM_EDGES ".purgem zstrip_medium_edge\n.purgem zstrip_medium_edges\n"
