// What `zstrip bake` writes, by the ending of its output.
#pragma once

#include <cstdint>
#include <string>

#include "result.hpp"

namespace zstrip::sim {

enum class BakeKind : std::uint8_t { header, sketch, program, blob, pico };

/// True for constants, and for programs that include them.
constexpr bool is_source(BakeKind kind) {
  return kind == BakeKind::header || kind == BakeKind::sketch || kind == BakeKind::program;
}

/// Returns a usage error for another ending.
Result<BakeKind> bake_kind(const std::string& output);

}  // namespace zstrip::sim
