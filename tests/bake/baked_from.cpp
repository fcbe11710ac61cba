// Of one header: CMake says it.
#include "baked_from.hpp"

namespace zstrip::sim::test {

constexpr BakedFrom baked_from{BAKED_SCENE, BAKED_OPTIONS, BAKED_REPORT};

}  // namespace zstrip::sim::test
