// The scenes that compression is measured with: six frames each, 320x240.
#pragma once

#include <string>
#include <vector>

#include "images.hpp"

namespace store_test {

enum class Content { small_float, fitted, colour };

/// Frames 0, 10, ... 50 of a benchmark workload; of the room the six views of a turn. Empty if there is no such scene.
/// `bunny` comes from the model file; it is empty if that is not installed.
std::vector<Image> images_of(const std::string& scene, Content content);

}  // namespace store_test
