// Kernel: the division of texture coordinates by w. Without long products a function of its own; its implementation
// gives what TextureCoordinates<false>::position does in C++, bit by bit.
#pragma once

#include "zstrip/kernels/processor.hpp"
#include "zstrip/kernels/thumb1/texel_position.hpp"

namespace zstrip::detail {

/// True if divide_texels_thumb1 divides.
inline constexpr bool kDividesTexelsInAssembly = kHasThumb1 && !kForSize;

}  // namespace zstrip::detail
