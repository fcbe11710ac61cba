// Tables of docs/measured/performance.md and visibility.md against a fresh run: one, another every day; with
// ZSTRIP_LONG all of them, those too that take minutes.
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>

#include "support.hpp"

namespace zstrip::sim {
namespace {

struct Named {
  const char *part, *table;
};

std::vector<Named> tables_of_today() {
  const std::vector<Named> quick{{"performance", "boards"}, {"performance", "depth"},     {"performance", "store"},
                                 {"visibility", "thesis"},  {"visibility", "depth-bits"}, {"visibility", "boards"}};
  if (std::getenv("ZSTRIP_LONG") == nullptr) {
    const auto today = std::chrono::floor<std::chrono::days>(std::chrono::system_clock::now()).time_since_epoch();
    return {quick[static_cast<std::size_t>(today.count()) % quick.size()]};
  }
  std::vector<Named> all{{"performance", "stages"}, {"performance", "peers"}, {"visibility", "midpoint"}};
  all.insert(all.end(), quick.begin(), quick.end());
  return all;
}

using MeasuredBench = test::FolderTest;

TEST_F(MeasuredBench, TablesAreThoseOfAFreshRun) {
  for (const Named& named : tables_of_today()) {
    const test::Outcome outcome =
        test::run(std::string(ZSTRIP_SCRIPTS "/") + named.part, {ZSTRIP_BUILD, "--compare", named.table}, path(""));
    EXPECT_EQ(outcome.status, 0) << named.part << ' ' << named.table << ":\n" << outcome.out << outcome.err;
  }
}

}  // namespace
}  // namespace zstrip::sim
