// Chooses the implementation of bilinear texels.
#include "zstrip/base/processor.hpp"
#include "zstrip/kernels/fragment_run.hpp"
#include "zstrip/kernels/portable/bilinear.hpp"
#include "zstrip/kernels/thumb2/bilinear.hpp"

namespace zstrip::detail {

template <bool palettes, bool alpha>
void fetch_bilinear(const RunTexels& texels, const RunPlace& place, std::uint32_t* colours, std::int32_t count) {
  if constexpr (kHasThumb2 && !kForSize) {  // for size C++ takes a hundred bytes less
    BilinearRun run(texels, place, colours, count);
    if constexpr (alpha) {
      fetch_bilinear_alpha_thumb2(run);
    } else {
      fetch_bilinear_thumb2(run);
    }
  } else {
    fetch_bilinear_portable<palettes, alpha>(texels, place, colours, count);
  }
}
template void fetch_bilinear<false, false>(const RunTexels&, const RunPlace&, std::uint32_t*, std::int32_t);
template void fetch_bilinear<false, true>(const RunTexels&, const RunPlace&, std::uint32_t*, std::int32_t);
template void fetch_bilinear<true, false>(const RunTexels&, const RunPlace&, std::uint32_t*, std::int32_t);
template void fetch_bilinear<true, true>(const RunTexels&, const RunPlace&, std::uint32_t*, std::int32_t);

}  // namespace zstrip::detail
