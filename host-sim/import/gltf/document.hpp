// The two parts of a glTF file: its JSON, and the additional bytes of a .glb.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "import/gltf/json.hpp"
#include "import/unreadable.hpp"
#include "result.hpp"

namespace zstrip::sim {

/// Returns the bytes of a file with a relative URI, which may have escapes (%20). The failure's message starts with a
/// verb.
using ReadUri = std::function<Result<std::vector<std::uint8_t>>(const std::string& uri)>;

// Moving JSON throws nothing, which clang-tidy cannot see.
struct GltfDocument {  // NOLINT(bugprone-exception-escape)
  GltfJson json;
  std::optional<std::vector<std::uint8_t>> binary;  ///< the second chunk of a .glb
  int version = 2;                                  ///< the first number of asset.version
  std::vector<std::string> warnings;                ///< damage that leaves a readable file
};

/// Parses a .gltf or .glb. The failure's message is a reason, later shown in brackets ("ends in the middle of ...").
Result<GltfDocument> parse_gltf(std::span<const std::uint8_t> file);

/// Returns the failure of a damaged file: `reason` has no name and no full stop.
Failure gltf_damaged(std::string reason);

}  // namespace zstrip::sim
