// The command, run in a folder of its own.
#pragma once

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
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
  /// Of the first frame that these options render; empty, and a failure, if they do not.
  std::string checksum(const std::string& scene, const std::vector<std::string>& options) const {
    std::vector<std::string> arguments{"render", scene, "-o", "p.png", "--quiet", "--json", "-"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = zstrip(arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    if (outcome.status != 0) return "";
    return nlohmann::json::parse(outcome.out).at("frames").at(0).at("crc32").get<std::string>();
  }
};

}  // namespace zstrip::sim::test
