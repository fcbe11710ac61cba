// The kind of file that `zstrip bake` writes, chosen by the ending of its output.
#pragma once

#include <cstdint>
#include <string>

#include "result.hpp"

namespace zstrip::sim {

/// `project`: a folder with a program and its header.
enum class BakeKind : std::uint8_t { header, sketch, program, project, blob, pico };

/// True for constants, and for programs that include them.
constexpr bool is_source(BakeKind kind) {
  return kind == BakeKind::header || kind == BakeKind::sketch || kind == BakeKind::program || kind == BakeKind::project;
}

/// An existing folder, or a name that ends in '/', is a project. Returns a usage error for another ending.
Result<BakeKind> bake_kind(const std::string& output);

}  // namespace zstrip::sim
