// Whether functions in assembly for Thumb-2 take the place of their portable forms. Not in ARMv8-M, where nothing here
// could try them.
#pragma once

// A macro, because the assembler must not see what it does not know.
#if defined(__thumb2__) && (defined(__ARM_ARCH_7M__) || defined(__ARM_ARCH_7EM__))
#define ZSTRIP_HAS_THUMB2 1
#else
#define ZSTRIP_HAS_THUMB2 0
#endif

namespace zstrip::detail {

inline constexpr bool kHasThumb2 = ZSTRIP_HAS_THUMB2 == 1;

}  // namespace zstrip::detail
