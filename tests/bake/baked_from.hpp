// What a header was baked from, for the test of it.
#pragma once

namespace zstrip::sim::test {

struct BakedFrom {
  const char* scene;    ///< a file or a built-in scene
  const char* options;  ///< of `zstrip bake`, separated by spaces
  const char* report;   ///< the file of its option --json
};
extern const BakedFrom baked_from;

}  // namespace zstrip::sim::test
