// True in builds with AddressSanitizer: GCC defines a macro, Clang answers __has_feature.
#pragma once

namespace zstrip::sim {

#if defined(__SANITIZE_ADDRESS__)
inline constexpr bool kAddressSanitizer = true;
#elif defined(__has_feature)
inline constexpr bool kAddressSanitizer = __has_feature(address_sanitizer);
#else
inline constexpr bool kAddressSanitizer = false;
#endif

}  // namespace zstrip::sim
