// Whether functions in assembly take the place of their portable forms: for Thumb-2 (Cortex-M3, M4, M7), for Thumb-1
// (Cortex-M0, M0+). Not in ARMv8-M, where nothing here could try them.
#pragma once

// Macros, because the assembler must not see what it does not know.
#if defined(__thumb2__) && (defined(__ARM_ARCH_7M__) || defined(__ARM_ARCH_7EM__))
#define ZSTRIP_HAS_THUMB2 1
#else
#define ZSTRIP_HAS_THUMB2 0
#endif
#if defined(__ARM_ARCH_6M__)
#define ZSTRIP_HAS_THUMB1 1
#else
#define ZSTRIP_HAS_THUMB1 0
#endif

namespace zstrip::detail {

inline constexpr bool kHasThumb1 = ZSTRIP_HAS_THUMB1 == 1;
inline constexpr bool kHasThumb2 = ZSTRIP_HAS_THUMB2 == 1;
inline constexpr bool kHasThumb = kHasThumb1 || kHasThumb2;  ///< every such function is there for both

}  // namespace zstrip::detail
