// The contract of the kernels on this processor: all cases of tests/kernels.
#include <gtest/gtest.h>

#include <ostream>
#include <string>

#include "contracts.hpp"

namespace zstrip::kernels_test {

std::ostream& operator<<(std::ostream& stream, const Contract& contract) { return stream << contract.name; }

namespace {

class Kernels : public testing::TestWithParam<Contract> {};

TEST_P(Kernels, WriteWhatThePortableOnesWrite) {
  const Contract& contract = GetParam();
  if (!contract.has_own) GTEST_SKIP() << "this processor has the portable one alone";
  const Outcome outcome = contract.compare(ZSTRIP_FEW_SAMPLES != 0 ? contract.on_boards : contract.on_hosts);
  EXPECT_EQ(outcome.difference, "") << "case " << outcome.number;
  EXPECT_GE(outcome.compared, contract.least);
}

INSTANTIATE_TEST_SUITE_P(Contract, Kernels, testing::ValuesIn(contracts().begin(), contracts().end()),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace zstrip::kernels_test
