// Runs the command and reads its reports.
#include "command_report.hpp"

#include <gtest/gtest.h>
#include <zlib.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>

#include "support.hpp"

namespace zstrip::sim::test {
namespace {

std::vector<std::string> words_of(const std::string& text) {
  std::istringstream stream(text);
  return {std::istream_iterator<std::string>(stream), {}};
}

std::vector<std::string> render_options(const std::string& options) {
  std::vector<std::string> kept;
  const std::vector<std::string> words = words_of(options);
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i] == "--ortho" || words[i] == "--dither") kept.push_back(words[i]);
    for (const char* option : {"--size", "--format", "--samples", "--up", "--orbit", "--fov", "--visibility"}) {
      if (words[i] == option) kept.insert(kept.end(), {words[i], words[i + 1]});
    }
  }
  return kept;
}

}  // namespace

bool is_turntable(const std::string& options) {
  const std::vector<std::string> words = words_of(options);
  return std::find(words.begin(), words.end(), "--turntable") != words.end();
}

std::vector<std::string> rendered_frames(const std::string& scene, const std::string& options, bool moves,
                                         const std::string& folder) {
  std::vector<std::string> arguments{"render", scene, "--quiet", "--json", "-"};
  const std::vector<std::string> kept = render_options(options);
  arguments.insert(arguments.end(), kept.begin(), kept.end());
  for (const char* word : {"-o", "frames", "--frames", moves ? "4" : "1"}) arguments.emplace_back(word);
  const Outcome outcome = run(ZSTRIP_COMMAND, arguments, folder);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  std::vector<std::string> crcs;
  if (outcome.status != 0) return crcs;
  const auto report = nlohmann::json::parse(outcome.out);
  for (const auto& frame : report.at("frames")) {
    EXPECT_GT(frame.at("statistics").at("fragments"), 100);
    crcs.push_back(frame.at("crc32"));
  }
  return crcs;
}

PlanReport baked_plan(const std::string& report) {
  std::ifstream file(report);
  const auto plan = nlohmann::json::parse(file).at("plan");
  const auto& ram = plan.at("ram_bytes");
  return {ram.at("arena"), ram.at("strip_pixels"), plan.at("strips"), plan.at("mode")};
}

std::string crc32_of(std::span<const std::byte> bytes) {
  const uLong crc =
      ::crc32(::crc32(0, nullptr, 0), reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(bytes.size()));
  char text[9];
  std::snprintf(text, sizeof text, "%08lx", crc);
  return text;
}

}  // namespace zstrip::sim::test
