// Kernel: divides texture coordinates by w. Used on processors without long products; the result has the same bits as
// that of TextureCoordinates<false>::position in C++.
#pragma once

#include "zstrip/base/processor.hpp"
#include "zstrip/kernels/thumb1/texel_position.hpp"

namespace zstrip::detail {

inline constexpr bool kDividesTexelsInAssembly = kHasThumb1 && !kForSize;

}  // namespace zstrip::detail
