// Selects the implementations of kernels for the processor. Vectors: SSE2 on every x86-64, NEON on every AArch64, both
// also on x86 and Armv7-A if they are enabled. Assembly: Thumb-2 (Cortex-M3, M4, M7, M33, M55) and Thumb-1 (Cortex-M0,
// M0+), but not the Cortex-M23, for which there is no emulator here. Helium, the vectors of a Cortex-M55, replaces some
// of the assembly for Thumb-2.
#pragma once

// These are macros, because neither the compiler nor the assembler may see code that it does not support.
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
#if defined(__ARM_FEATURE_MVE) && !defined(__ARM_BIG_ENDIAN)
#define ZSTRIP_HAS_MVE 1
#else
#define ZSTRIP_HAS_MVE 0
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

// Set to 1 for a program that leaves the interpolators of an RP2040 to zstrip: Thumb-1 then fetches texels with them.
#if !defined(ZSTRIP_HAS_INTERPOLATORS)
#define ZSTRIP_HAS_INTERPOLATORS 0
#endif

// Prevents inlining on processors that call a function for 64-bit products: each copy would take half a kilobyte.
#if ZSTRIP_HAS_THUMB1
#define ZSTRIP_CALLED_ON_THUMB1 [[gnu::noinline]]
#else
#define ZSTRIP_CALLED_ON_THUMB1
#endif

// Processors without an instruction that counts leading zeros call a function of some fifteen instructions.
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

inline constexpr bool kForSize = ZSTRIP_FOR_SIZE == 1;  ///< with -Os the specialised rasterisers are left out; the
                                                        ///< generic path draws the same pixels
inline constexpr bool kHasVectors = ZSTRIP_HAS_VECTORS;
inline constexpr bool kHasMve = ZSTRIP_HAS_MVE == 1;
inline constexpr bool kHasThumb1 = ZSTRIP_HAS_THUMB1 == 1;
inline constexpr bool kHasThumb2 = ZSTRIP_HAS_THUMB2 == 1;
inline constexpr bool kCountsZeros = ZSTRIP_COUNTS_ZEROS == 1;
inline constexpr bool kHasThumb = kHasThumb1 || kHasThumb2;  ///< every kernel in assembly exists for both

}  // namespace zstrip::detail
