// The assembly of thumb/list_faces.hpp, and the function that it calls.
#include "zstrip/kernels/thumb/list_faces.hpp"

#include <cstddef>

#include "zstrip/base/processor.hpp"
#include "zstrip/kernels/thumb/records.hpp"
#include "zstrip/kernels/thumb1/macros.hpp"
#include "zstrip/kernels/thumb2/triangle_of_words.hpp"

namespace zstrip::detail {

#if ZSTRIP_HAS_THUMB1 || ZSTRIP_HAS_THUMB2

// clang-format off
#define ZSTRIP_FACE_LISTS(field, number)                           \
  field(faces, FaceLists, for_top, 0)                              \
  field(faces, FaceLists, for_bottom, 4)                           \
  field(faces, FaceLists, inverse, 8)                              \
  number(faces.inverse_high, offsetof(FaceLists, inverse) + 2, 10) \
  field(faces, FaceLists, strips, 12)                              \
  field(faces, FaceLists, lists, 16)                               \
  field(faces, FaceLists, slots, 20)                               \
  field(faces, FaceLists, batch, 24)                               \
  field(faces, FaceLists, bins, 28)                                \
  field(faces, FaceLists, vertices, 32)                            \
  field(faces, FaceLists, last, 36)                                \
  field(faces, FaceLists, end, 40)                                 \
  field(list, BinList, next, 0)                                    \
  field(list, BinList, batch, 4)                                   \
  number(list.size, sizeof(BinList), 8)
// clang-format on
ZSTRIP_CHECK_LAYOUT(ZSTRIP_FACE_LISTS)
static_assert(kBinChunkSlots == 16);

// Adds to a list that has no room for a triangle of this batch. `used`: the assembly calls it by name.
[[gnu::used]] bool append_to_list(Bins& bins, BinList& list, std::uint32_t batch,
                                  std::uint32_t triangle) asm("zstrip_append_to_list");
bool append_to_list(Bins& bins, BinList& list, std::uint32_t batch, std::uint32_t triangle) {
  return bins.append(list, static_cast<std::uint16_t>(batch), static_cast<std::uint16_t>(triangle));
}

[[gnu::naked]] bool list_faces_thumb(FaceLists&, const Triangle*, std::uint32_t) {
  asm(ZSTRIP_NAMES(ZSTRIP_RECORDS) ZSTRIP_NAMES(ZSTRIP_FACE_LISTS)
#if ZSTRIP_HAS_THUMB1
#include "zstrip/kernels/thumb1/list_faces.inc"
#else
#include "zstrip/kernels/thumb2/list_faces.inc"
#endif
  );
}

#endif

}  // namespace zstrip::detail
