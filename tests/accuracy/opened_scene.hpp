// A built-in scene as the tests of figures look at it: small, one pose.
#pragma once

#include <gtest/gtest.h>

#include <memory>

#include "accuracy/measure.hpp"

namespace zstrip::sim {

inline std::unique_ptr<AccuracyScene> scene(const char* name) {
  auto opened = AccuracyScene::open({.scene = name, .view = {96, 72}, .frames = 1, .firmware = ""});
  EXPECT_TRUE(opened) << opened.failure().message;
  return std::move(*opened);
}

}  // namespace zstrip::sim
