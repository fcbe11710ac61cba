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
  /// Of the frames that these options render; none, and a failure, if they do not.
  std::vector<std::string> checksums(const std::string& scene, const std::vector<std::string>& options,
                                     const std::string& output = "frames") const {
    std::vector<std::string> arguments{"render", scene, "-o", output, "--quiet", "--json", "-"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = zstrip(arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    std::vector<std::string> found;
    if (outcome.status != 0) return found;
    const nlohmann::json report = nlohmann::json::parse(outcome.out);
    for (const auto& frame : report.at("frames")) found.push_back(frame.at("crc32"));
    return found;
  }
  /// Of the only one.
  std::string checksum(const std::string& scene, const std::vector<std::string>& options) const {
    const std::vector<std::string> found = checksums(scene, options, "p.png");
    return found.empty() ? "" : found[0];
  }
};

}  // namespace zstrip::sim::test
