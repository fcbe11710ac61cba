// Bilinear texels in C++; see kernels/fragment_run.hpp.
#pragma once

#include <cstdint>

#include "zstrip/kernels/fragment_run.hpp"

namespace zstrip::detail {

template <bool palettes, bool alpha>
void fetch_bilinear_portable(const RunTexels& texels, const RunPlace& place, std::uint32_t* colours,
                             std::int32_t count);

}  // namespace zstrip::detail
