// Scene files as texts.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "compose/scene_file.hpp"

namespace zstrip::sim::test {

inline SceneFile parsed(const std::string& text) {
  Result<SceneFile> file = parse_scene_file(text, "scene.toml");
  EXPECT_TRUE(file) << file.failure().message;
  return file ? std::move(*file) : SceneFile{};
}

inline std::string failure(const std::string& text) {
  const Result<SceneFile> file = parse_scene_file(text, "scene.toml");
  EXPECT_FALSE(file);
  if (file) return "";
  EXPECT_EQ(file.failure().status, ExitStatus::input);
  return file.failure().message;
}

inline const std::string kCube =
    "[[model]]\nname = 'cube'\nbuilt_in = 'cube'\n[[instance]]\nmodel = 'cube'\n";  // 5 lines

}  // namespace zstrip::sim::test
