// Tables of docs/measured/performance.md and visibility.md against a fresh run: one; with ZSTRIP_LONG all of them.
#include <gtest/gtest.h>

#include <cstdlib>

#include "support.hpp"

namespace zstrip::sim {
namespace {

/// "PART TABLE".
std::vector<std::string> tables() {
  if (std::getenv("ZSTRIP_LONG") == nullptr) return {"performance depth"};
  return {"performance boards", "performance depth",     "performance store", "performance stages", "performance peers",
          "visibility thesis",  "visibility depth-bits", "visibility boards", "visibility midpoint"};
}

using MeasuredBench = test::FolderTest;

TEST_F(MeasuredBench, TablesAreThoseOfAFreshRun) {
  for (const std::string& named : tables()) {
    const std::size_t space = named.find(' ');
    const test::Outcome outcome = test::run(ZSTRIP_SCRIPTS "/" + named.substr(0, space),
                                            {ZSTRIP_BUILD, "--compare", named.substr(space + 1)}, path(""));
    EXPECT_EQ(outcome.status, 0) << named << ":\n" << outcome.out << outcome.err;
  }
}

}  // namespace
}  // namespace zstrip::sim
