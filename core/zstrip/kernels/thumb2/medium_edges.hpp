// The assembly at the start of each row of a medium triangle.
#pragma once

// zstrip_medium_edges: moves both edges a row down. Returns the row's first column in lr and the number of columns in
// r12. Changes r1 to r10. Needs the names of thumb/medium_layout.hpp. Each function contains it: thumb1/macros.hpp.
#define ZSTRIP_MEDIUM_EDGES                 \
  ".macro zstrip_medium_edges\n"            \
  "  ldm   r0, {r1-r10}\n"                  \
  "  mov   lr, r1\n"                        \
  "  sub   r12, r6, r1\n"                   \
  "  adds  r2, r2, r4\n"                    \
  "  adc   r1, r1, r3\n"                    \
  "  it    cs\n"                            \
  "  subcs r2, r2, r5\n"                    \
  "  strd  r1, r2, [r0, #.Lmedium.left]\n"  \
  "  adds  r7, r7, r9\n"                    \
  "  adc   r6, r6, r8\n"                    \
  "  it    cs\n"                            \
  "  subcs r7, r7, r10\n"                   \
  "  strd  r6, r7, [r0, #.Lmedium.right]\n" \
  ".endm\n"
