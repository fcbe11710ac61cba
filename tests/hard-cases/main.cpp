// Runs the hard cases with RapidCheck's samples fixed: the same in every run. ZSTRIP_LONG multiplies them by 100.
// A failure prints the words that replay it alone, as RC_PARAMS="reproduce=..." of RapidCheck or as the corners.
#include <gtest/gtest.h>

#include <cstdlib>

int main(int argc, char** argv) {
  const bool is_long = std::getenv("ZSTRIP_LONG") != nullptr;
  constexpr int kKeepWhatIsSet = 0;
  setenv("RC_PARAMS", is_long ? "seed=66 max_success=100000" : "seed=66 max_success=1000", kKeepWhatIsSet);
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
