// The command, run in a folder of its own.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "image/decode.hpp"
#include "support.hpp"

namespace zstrip::sim::test {

class Command : public FolderTest {
 protected:
  Outcome zstrip(const std::vector<std::string>& arguments) const { return run(ZSTRIP_COMMAND, arguments, path("")); }
  RgbImage picture(const std::string& name) const {
    const std::string bytes = read(path(name));
    const auto image = decode_image({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
    EXPECT_TRUE(image);
    return *image;
  }
};

}  // namespace zstrip::sim::test
