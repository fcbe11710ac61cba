// The contracts of the kernels for Helium, on a board: a part of what its self-test compares, which compiles quickly.
// Exit status: 0 all are equal; 1 one differs, or compared too little.
#include <cstdint>

#include "contracts.hpp"
#include "cortex_m/console.hpp"
#include "zstrip/base/processor.hpp"

namespace {

using namespace zstrip::kernels_test;
using zstrip::board::print;

static_assert(zstrip::detail::kHasMve, "the compiler's processor has no Helium");

bool is_equal(const char* name, const Outcome& outcome, std::uint32_t least) {
  print(name);
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
  return outcome.difference.empty() && outcome.compared >= least;
}

}  // namespace

int main() {
  const bool equal[] = {is_equal("transform", compare_transforms(400), 4'000),
                        is_equal("runs", compare_small_runs(400), 40'000),
                        is_equal("texels", compare_textured_runs(4'000), 3'000)};
  return equal[0] && equal[1] && equal[2] ? 0 : 1;
}
