// The contracts of the kernels for Helium, on a board: a part of what its self-test compares, which compiles quickly.
// Exit status: 0 all are equal; 1 one differs, or compared too little.
#include <cstdint>
#include <iterator>

#include "contracts.hpp"
#include "cortex_m/console.hpp"
#include "zstrip/base/processor.hpp"

namespace {

using namespace zstrip::kernels_test;
using zstrip::board::print;

static_assert(zstrip::detail::kHasMve, "the compiler's processor has no Helium");

struct Compared {
  const char* name;
  Outcome (*compare)(std::uint32_t number_of_cases);
  std::uint32_t cases;
  std::uint32_t least;  ///< of Outcome::compared
};

constexpr Compared kContracts[] = {{"transform", compare_transforms, 400, 4'000},
                                   {"runs", compare_small_runs, 400, 40'000},
                                   {"texels", compare_textured_runs, 4'000, 3'000}};
static_assert(std::size(kContracts) == ZSTRIP_MVE_KERNELS, "a kernel for Helium is compared by no contract here");

bool is_equal(const Compared& contract) {
  const Outcome outcome = contract.compare(contract.cases);
  print(contract.name);
  print(": ");
  zstrip::board::print_decimal(outcome.compared);
  print(" are equal\n");
  if (!outcome.difference.empty()) {
    print("case ");
    zstrip::board::print_decimal(outcome.number);
    print(": ");
    print(outcome.difference.data());  // a literal
    print(" differs\n");
  }
  return outcome.difference.empty() && outcome.compared >= contract.least;
}

}  // namespace

int main() {
  bool equal = true;
  for (const Compared& contract : kContracts) equal = is_equal(contract) && equal;
  return equal ? 0 : 1;
}
