// Kernel: lists the triangles of a meshlet that face the viewer, of a one-sided surface whose vertices are narrow, in
// the bins of strips that are whole rows of the picture.
//
// Each triangle is added to the strips that its rows reach, in the order of triangles; some may have no pixel's centre.
// Every implementation makes the lists of portable/list_faces.hpp.
#pragma once

#include <cstdint>

#include "zstrip/kernels/portable/list_faces.hpp"
#include "zstrip/kernels/processor.hpp"
#include "zstrip/kernels/thumb/list_faces.hpp"

namespace zstrip::detail {

/// False if the bins' memory is full. Cannot be inlined: what is around it would take its registers.
[[gnu::noinline]] inline bool list_faces(FaceLists& faces, const Triangle* triangles, std::uint32_t count) {
  if constexpr (kHasThumb) return list_faces_thumb(faces, triangles, count);
  return list_faces_portable(faces, triangles, count);
}

}  // namespace zstrip::detail
