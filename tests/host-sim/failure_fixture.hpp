// Tests of failures: one line that names the thing, the documented exit status, and no partial file.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "result.hpp"
#include "support.hpp"

namespace zstrip::sim::test {

class FailureTest : public FolderTest {
 protected:
  /// Runs zstrip in the folder and checks the contract of failures; `mention` must be in the message.
  void expect_failure(ExitStatus status, const std::string& mention, const std::vector<std::string>& arguments,
                      const Limits& limits = {}) {
    const std::vector<std::string> before = files();
    const Outcome outcome = run(ZSTRIP_COMMAND, arguments, path(""), limits);
    EXPECT_EQ(outcome.status, static_cast<int>(status)) << outcome.err;
    EXPECT_EQ(outcome.err.rfind("zstrip: ", 0), 0U) << outcome.err;
    EXPECT_EQ(outcome.err.find('\n'), outcome.err.size() - 1) << "one line: " << outcome.err;
    EXPECT_NE(outcome.err.find(mention), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(files(), before) << "a failure leaves no file";
  }
};

}  // namespace zstrip::sim::test
