// The picture that a baked program leaves on the screen of tests/adapters; see compare_screen.hpp.
#include "compare_screen.hpp"

#include <cstdint>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <vector>

#include "screen.hpp"

namespace zstrip {

namespace adapters_test {
Screen& screen() {
  static Screen only;
  return only;
}
}  // namespace adapters_test

namespace package {

int compare_screen(const char* picture) {
  using adapters_test::screen;
  std::ifstream file(picture, std::ios::binary);
  const std::vector<char> bytes(std::istreambuf_iterator<char>(file), {});
  std::vector<std::uint16_t> expected(bytes.size() / 2);
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const auto byte = [&](std::size_t at) { return static_cast<std::uint8_t>(bytes[at]); };
    expected[i] = static_cast<std::uint16_t>(byte(2 * i) << 8 | byte(2 * i + 1));
  }
  if (!screen().complaint.empty()) {
    std::printf("%s\n", screen().complaint.c_str());
    return 1;
  }
  if (screen().colours == expected) return 0;
  std::printf("the screen shows another picture than %s\n", picture);
  return 1;
}

}  // namespace package
}  // namespace zstrip
