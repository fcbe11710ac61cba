// Which implementations of kernels the processor at hand takes instead of the portable ones: vectors, of SSE2 on every
// x86-64 and of NEON on every AArch64, on x86 and Armv7-A where they are enabled; assembly for Thumb-2 (Cortex-M3, M4,
// M7, M33, M55) and Thumb-1 (Cortex-M0, M0+), not for the Cortex-M23, which no emulator here has.
#pragma once

// Macros, because neither compiler nor assembler must see what they do not support.
#if defined(__SSE2__)
#define ZSTRIP_HAS_SSE2 1
#else
#define ZSTRIP_HAS_SSE2 0
#endif
#if defined(__ARM_NEON) && !defined(__ARM_BIG_ENDIAN)
#define ZSTRIP_HAS_NEON 1
#else
#define ZSTRIP_HAS_NEON 0
#endif
#define ZSTRIP_HAS_VECTORS (ZSTRIP_HAS_SSE2 || ZSTRIP_HAS_NEON)
#if defined(__thumb2__) && (defined(__ARM_ARCH_7M__) || defined(__ARM_ARCH_7EM__) || defined(__ARM_ARCH_8M_MAIN__) || \
                            defined(__ARM_ARCH_8_1M_MAIN__))
#define ZSTRIP_HAS_THUMB2 1
#else
#define ZSTRIP_HAS_THUMB2 0
#endif
#if defined(__ARM_ARCH_6M__)
#define ZSTRIP_HAS_THUMB1 1
#else
#define ZSTRIP_HAS_THUMB1 0
#endif

// Before a function that is not to be inlined where products of 64 bits are calls: half a kilobyte each time.
#if ZSTRIP_HAS_THUMB1
#define ZSTRIP_CALLED_ON_THUMB1 [[gnu::noinline]]
#else
#define ZSTRIP_CALLED_ON_THUMB1
#endif

// Without the instruction that counts leading zeros of a word they take a function of some fifteen.
#if ZSTRIP_HAS_THUMB1 || (defined(__riscv) && !defined(__riscv_zbb))
#define ZSTRIP_COUNTS_ZEROS 0
#else
#define ZSTRIP_COUNTS_ZEROS 1
#endif

#if defined(__OPTIMIZE_SIZE__)
#define ZSTRIP_FOR_SIZE 1
#else
#define ZSTRIP_FOR_SIZE 0
#endif

namespace zstrip::detail {

inline constexpr bool kForSize = ZSTRIP_FOR_SIZE == 1;  ///< second ways to draw, that are only quicker, are no code
inline constexpr bool kHasVectors = ZSTRIP_HAS_VECTORS;
inline constexpr bool kHasThumb1 = ZSTRIP_HAS_THUMB1 == 1;
inline constexpr bool kHasThumb2 = ZSTRIP_HAS_THUMB2 == 1;
inline constexpr bool kCountsZeros = ZSTRIP_COUNTS_ZEROS == 1;
inline constexpr bool kHasThumb = kHasThumb1 || kHasThumb2;  ///< every kernel in assembly is there for both

}  // namespace zstrip::detail
