// The contract of the kernels on a processor that is emulated. Exit status: 0 all are equal; 1 one differs, compared
// too little, or has no implementation of its own.

#include <cstdio>
#include <string>

#include "contracts.hpp"

int main() {
  bool failed = false;
  for (const zstrip::kernels_test::Contract& contract : zstrip::kernels_test::contracts()) {
    const auto outcome = contract.compare(contract.on_boards);
    const bool equal = contract.has_own && outcome.difference.empty() && outcome.compared >= contract.least;
    std::printf("%s: %u are equal, %u needed%s", std::string(contract.name).c_str(), outcome.compared, contract.least,
                contract.has_own ? "" : ", by C++ alone");
    if (!outcome.difference.empty()) {
      std::printf("; case %u: %s differs", outcome.number, std::string(outcome.difference).c_str());
    }
    std::printf("\n");
    failed = failed || !equal;
  }
  return failed ? 1 : 0;
}
