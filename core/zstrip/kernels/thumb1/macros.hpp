// The text of assembler macros that the assembly for Thumb-1 shares. Each function contains the text, because macros
// outside of functions get lost if the linker changes the order of the files' code.
#pragma once

// Saves r4 to r11 and lr, .Lsaved bytes. The arguments from the fifth on follow on the stack.
#define ZSTRIP_THUMB1_PUSH \
  ".syntax unified\n"      \
  ".set .Lsaved, 36\n"     \
  "push  {r4-r7, lr}\n"    \
  "mov   r4, r8\n"         \
  "mov   r5, r9\n"         \
  "mov   r6, r10\n"        \
  "mov   r7, r11\n"        \
  "push  {r4-r7}\n"
// Restores the registers that ZSTRIP_THUMB1_PUSH saved, then returns.
#define ZSTRIP_THUMB1_POP \
  "pop   {r4-r7}\n"       \
  "mov   r8, r4\n"        \
  "mov   r9, r5\n"        \
  "mov   r10, r6\n"       \
  "mov   r11, r7\n"       \
  "pop   {r4-r7, pc}\n"

// zstrip_multiply_high a low high t u v [shift]: sets a to the upper word of its product with the word whose halves are
// low and high, rounded down, as in multiply_high_in_halves. `shift` is lsrs for unsigned words. Changes t, u and v.
#define ZSTRIP_THUMB1_MULTIPLY_HIGH                                                   \
  ".macro zstrip_multiply_high a:req low:req high:req t:req u:req v:req shift=asrs\n" \
  "  uxth  \\t, \\a\n"                                                                \
  "  \\shift \\a, \\a, #16\n"                                                         \
  "  movs  \\u, \\t\n"                                                                \
  "  muls  \\u, \\u, \\low\n"                                                         \
  "  lsrs  \\u, \\u, #16\n"                                                           \
  "  movs  \\v, \\a\n"                                                                \
  "  muls  \\v, \\v, \\low\n"                                                         \
  "  adds  \\u, \\u, \\v\n"                                                           \
  "  muls  \\t, \\t, \\high\n"                                                        \
  "  uxth  \\v, \\u\n"                                                                \
  "  adds  \\t, \\t, \\v\n"                                                           \
  "  muls  \\a, \\a, \\high\n"                                                        \
  "  \\shift \\u, \\u, #16\n"                                                         \
  "  adds  \\a, \\a, \\u\n"                                                           \
  "  \\shift \\t, \\t, #16\n"                                                         \
  "  adds  \\a, \\a, \\t\n"                                                           \
  ".endm\n"

// zstrip_reciprocal: r3 = reciprocal(r2 << r6), with r2 not 0 and r6 such that the highest bit is set. On entry r6
// holds the last reciprocal's shift, which is nearly always the right one, and r5 the table of reciprocals for an index
// that begins at 256. Changes r0 to r5. The same steps as in reciprocal_in_halves, with q in r4 and e in r5.
#define ZSTRIP_THUMB1_RECIPROCAL \
  ZSTRIP_THUMB1_MULTIPLY_HIGH    \
  ".macro zstrip_reciprocal\n"   \
  "  movs  r3, r2\n"             \
  "  lsls  r3, r3, r6\n"         \
  "  bpl   .Lnormalise\\@\n"     \
  "  movs  r4, r3\n"             \
  "  lsrs  r4, r4, r6\n"         \
  "  cmp   r4, r2\n"             \
  "  beq   .Lnormal\\@\n"        \
  ".Lnormalise\\@:\n"            \
  "  movs  r6, #0\n"             \
  "  movs  r3, r2\n"             \
  "  lsrs  r4, r3, #16\n"        \
  "  bne   .Lnormalise_8\\@\n"   \
  "  adds  r6, r6, #16\n"        \
  "  lsls  r3, r3, #16\n"        \
  ".Lnormalise_8\\@:\n"          \
  "  lsrs  r4, r3, #24\n"        \
  "  bne   .Lnormalise_4\\@\n"   \
  "  adds  r6, r6, #8\n"         \
  "  lsls  r3, r3, #8\n"         \
  ".Lnormalise_4\\@:\n"          \
  "  lsrs  r4, r3, #28\n"        \
  "  bne   .Lnormalise_2\\@\n"   \
  "  adds  r6, r6, #4\n"         \
  "  lsls  r3, r3, #4\n"         \
  ".Lnormalise_2\\@:\n"          \
  "  lsrs  r4, r3, #30\n"        \
  "  bne   .Lnormalise_1\\@\n"   \
  "  adds  r6, r6, #2\n"         \
  "  lsls  r3, r3, #2\n"         \
  ".Lnormalise_1\\@:\n"          \
  "  cmp   r3, #0\n"             \
  "  bmi   .Lnormal\\@\n"        \
  "  adds  r6, r6, #1\n"         \
  "  lsls  r3, r3, #1\n"         \
  ".Lnormal\\@:\n"               \
  "  lsrs  r2, r3, #16\n"        \
  "  lsrs  r4, r3, #23\n"        \
  "  lsls  r4, r4, #1\n"         \
  "  ldrh  r4, [r5, r4]\n"       \
  "  movs  r5, r4\n"             \
  "  muls  r5, r5, r2\n"         \
  "  rsbs  r5, r5, #0\n"         \
  "  lsls  r5, r5, #1\n"         \
  "  asrs  r5, r5, #8\n"         \
  "  muls  r5, r5, r4\n"         \
  "  asrs  r5, r5, #23\n"        \
  "  lsls  r4, r4, #1\n"         \
  "  adds  r4, r4, r5\n"         \
  "  movs  r5, r4\n"             \
  "  muls  r5, r5, r2\n"         \
  "  mvns  r0, r5\n"             \
  "  cmp   r0, r2\n"             \
  "  blo   .Lquotient\\@\n"      \
  "  adds  r4, r4, #1\n"         \
  "  adds  r5, r5, r2\n"         \
  ".Lquotient\\@:\n"             \
  "  uxth  r0, r3\n"             \
  "  adds  r5, r5, r0\n"         \
  "  uxth  r1, r4\n"             \
  "  muls  r0, r0, r1\n"         \
  "  lsrs  r0, r0, #16\n"        \
  "  adds  r5, r5, r0\n"         \
  "  asrs  r5, r5, #2\n"         \
  "  muls  r1, r1, r5\n"         \
  "  rsbs  r1, r1, #0\n"         \
  "  asrs  r1, r1, #16\n"        \
  "  subs  r1, r1, r5\n"         \
  "  asrs  r1, r1, #1\n"         \
  "  lsls  r4, r4, #13\n"        \
  "  adds  r3, r4, r1\n"         \
  "  lsls  r3, r3, #1\n"         \
  ".endm\n"

#define ZSTRIP_THUMB1_PURGE_MULTIPLY_HIGH ".purgem zstrip_multiply_high\n"
#define ZSTRIP_THUMB1_PURGE_RECIPROCAL ZSTRIP_THUMB1_PURGE_MULTIPLY_HIGH ".purgem zstrip_reciprocal\n"
