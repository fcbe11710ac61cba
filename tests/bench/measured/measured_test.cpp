// Tables of docs/measured/performance.md and visibility.md against a fresh run: one, another every day; with
// ZSTRIP_LONG all of them, those too that take minutes.
#include <gtest/gtest.h>

#include "measured/sample.hpp"
#include "support.hpp"

namespace zstrip::sim {
namespace {

/// "PART TABLE".
std::vector<std::string> tables_of_today() {
  const std::vector<std::string> quick{"performance boards", "performance depth",     "performance store",
                                       "visibility thesis",  "visibility depth-bits", "visibility boards"};
  std::vector<std::string> tables = measured::sample_of_today(quick, 1);
  if (tables.size() == quick.size())
    tables.insert(tables.end(), {"performance stages", "performance peers", "visibility midpoint"});
  return tables;
}

using MeasuredBench = test::FolderTest;

TEST_F(MeasuredBench, TablesAreThoseOfAFreshRun) {
  for (const std::string& named : tables_of_today()) {
    const std::size_t space = named.find(' ');
    const test::Outcome outcome = test::run(ZSTRIP_SCRIPTS "/" + named.substr(0, space),
                                            {ZSTRIP_BUILD, "--compare", named.substr(space + 1)}, path(""));
    EXPECT_EQ(outcome.status, 0) << named << ":\n" << outcome.out << outcome.err;
  }
}

}  // namespace
}  // namespace zstrip::sim
