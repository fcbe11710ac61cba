// The data of workload R50.
#include "triangle_soup.hpp"
#include "zstrip/scene/validate.hpp"

namespace zstrip::scenes {

constexpr TriangleSoup<50> kRandom50 = random_triangles<50>(1000, kRandom50HalfExtent.x);

static_assert(validate(random50.scene));

}  // namespace zstrip::scenes
