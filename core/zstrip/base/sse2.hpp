// Whether functions with SSE2 take the place of their portable forms: on every x86-64, and on x86 where it is asked
// for.
#pragma once

#if defined(__SSE2__)
#define ZSTRIP_HAS_SSE2 1
#else
#define ZSTRIP_HAS_SSE2 0
#endif

namespace zstrip::detail {

inline constexpr bool kHasSse2 = ZSTRIP_HAS_SSE2 == 1;

}  // namespace zstrip::detail
