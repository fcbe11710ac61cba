// The assembly behind thumb/list_faces.hpp, and what it calls.
#include "zstrip/kernels/thumb/list_faces.hpp"

#include <cstddef>

#include "zstrip/kernels/processor.hpp"
#include "zstrip/kernels/thumb/records.hpp"
#include "zstrip/kernels/thumb1/macros.hpp"
#include "zstrip/kernels/thumb2/triangle_of_words.hpp"

namespace zstrip::detail {

#if ZSTRIP_HAS_THUMB1 || ZSTRIP_HAS_THUMB2

static_assert(offsetof(FaceLists, for_top) == 0 && offsetof(FaceLists, for_bottom) == 4 &&
              offsetof(FaceLists, inverse) == 8 && offsetof(FaceLists, strips) == 12 &&
              offsetof(FaceLists, lists) == 16 && offsetof(FaceLists, slots) == 20 && offsetof(FaceLists, batch) == 24);
static_assert(offsetof(FaceLists, bins) == 28 && offsetof(FaceLists, vertices) == 32 &&
              offsetof(FaceLists, last) == 36 && offsetof(FaceLists, end) == 40);
static_assert(offsetof(BinList, next) == 0 && offsetof(BinList, batch) == 4 && sizeof(BinList) == 8);
static_assert(kBinChunkSlots == 16);

// The list has no room yet for a triangle of this batch. Used: the assembly calls it by its name.
[[gnu::used]] bool append_to_list(Bins& bins, BinList& list, std::uint32_t batch,
                                  std::uint32_t triangle) asm("zstrip_append_to_list");
bool append_to_list(Bins& bins, BinList& list, std::uint32_t batch, std::uint32_t triangle) {
  return bins.append(list, static_cast<std::uint16_t>(batch), static_cast<std::uint16_t>(triangle));
}

[[gnu::naked]] bool list_faces_thumb(FaceLists&, const Triangle*, std::uint32_t) {
  asm(
#if ZSTRIP_HAS_THUMB1
#include "zstrip/kernels/thumb1/list_faces.inc"
#else
#include "zstrip/kernels/thumb2/list_faces.inc"
#endif
  );
}

#endif

}  // namespace zstrip::detail
