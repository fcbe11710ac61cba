// Of one header: CMake says it.
#include "baked_from.hpp"

namespace zstrip::sim::test {

constexpr BakedFrom baked_from{BAKED_SCENE, BAKED_OPTIONS};

}  // namespace zstrip::sim::test
