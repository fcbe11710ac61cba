// The values of command-line options: what a parser accepts is in its documented range and means the same when written
// again; what it refuses is a usage error that quotes the value.
#include <fmt/format.h>

#include <cmath>
#include <initializer_list>
#include <string>

#include "cli/parse.hpp"
#include "require.hpp"

namespace {

using namespace zstrip;
using namespace zstrip::sim;

/// A refusal names the option and quotes the text.
template <typename T>
bool accepted(const Result<T>& result, const char* option, const std::string& text) {
  if (result) return true;
  const std::string& message = result.failure().message;
  fuzz::require(result.failure().status == ExitStatus::usage, "a bad value is a usage error");
  fuzz::require(message.starts_with(option) && message.find(text) != std::string::npos,
                "a refusal names option and value: %s", message.c_str());
  return false;
}

void judge_numbers(const std::string& text) {
  const auto size = parse_size(text);
  if (accepted(size, "--size", text)) {
    const auto [width, height] = *size;
    fuzz::require(width >= 1 && width <= kMaxViewSize && height >= 1 && height <= kMaxViewSize, "sizes of 1 to 4096");
    fuzz::require(*parse_size(fmt::format("{}x{}", width, height)) == *size, "a size reads as it is written");
  }
  const auto bytes = parse_bytes(text);
  if (accepted(bytes, "--ram", text)) {
    fuzz::require(*bytes >= 1, "at least one byte");
    fuzz::require(*parse_bytes(fmt::format("{}", *bytes)) == *bytes, "bytes read as they are written");
  }
  const auto rows = parse_strip_rows(text);
  if (accepted(rows, "--strip-rows", text)) {
    fuzz::require(*rows <= kMaxViewSize && (*rows == 0) == (text == "auto"), "rows of 1 to 4096, or auto");
  }
  const auto vector = parse_vector("--eye", text);
  if (accepted(vector, "--eye", text)) {
    const auto& v = *vector;
    fuzz::require(std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]), "finite numbers");
    fuzz::require(*parse_vector("--eye", fmt::format("{},{},{}", v[0], v[1], v[2])) == v,
                  "a vector reads as it is written: %s", text.c_str());
  }
}

void judge_names(const std::string& text) {
  const auto is_one_of = [&text](std::initializer_list<const char*> names) {
    for (const char* name : names) {
      if (text == name) return true;
    }
    return false;
  };
  fuzz::require(accepted(parse_format(text), "--format", text) ==
                    is_one_of({"rgb565", "rgb565_swapped", "gray4", "mono", "rgb666", "rgb444", "xrgb8888"}),
                "seven formats");
  fuzz::require(accepted(parse_up_axis(text), "--up", text) == is_one_of({"x", "-x", "y", "-y", "z", "-z"}),
                "six axes");
  fuzz::require(accepted(parse_image_type(text), "--image", text) == is_one_of({"png", "ppm", "raw"}),
                "three picture types");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  judge_numbers(text);
  judge_names(text);
  return 0;
}
