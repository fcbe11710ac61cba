// Kernel: adds the front faces of a meshlet to the bins of their strips. The surface is one-sided, its vertices are
// narrow, and strips are whole rows of the picture.
//
// Each triangle is added to the strips that its rows reach, in the order of triangles; some may cover no pixel centre.
// Every implementation makes the same lists as portable/list_faces.hpp.
#pragma once

#include <cstdint>

#include "zstrip/base/processor.hpp"
#include "zstrip/kernels/portable/list_faces.hpp"
#include "zstrip/kernels/thumb/list_faces.hpp"

namespace zstrip::detail {

/// Returns false if the bins' memory is full. Not inlined, because the caller would take its registers.
[[gnu::noinline]] inline bool list_faces(FaceLists& faces, const Triangle* triangles, std::uint32_t count) {
  if constexpr (kHasThumb) return list_faces_thumb(faces, triangles, count);
  return list_faces_portable(faces, triangles, count);
}

}  // namespace zstrip::detail
