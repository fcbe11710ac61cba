// A glTF file's two parts: its JSON, and the bytes that a .glb has beside it.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "import/gltf/json.hpp"
#include "result.hpp"

namespace zstrip::sim {

/// The bytes of what a file names by a relative URI, which may have escapes (%20). The failure's message starts with
/// a verb.
using ReadUri = std::function<Result<std::vector<std::uint8_t>>(const std::string& uri)>;

// Moving JSON throws nothing, which clang-tidy does not see.
struct GltfDocument {  // NOLINT(bugprone-exception-escape)
  GltfJson json;
  std::optional<std::vector<std::uint8_t>> binary;  ///< the second chunk of a .glb
  int version = 2;                                  ///< the first number of asset.version
};

/// Of a .gltf or .glb. The failure's message is a reason, in brackets later ("ends in the middle of ...").
Result<GltfDocument> parse_gltf(std::span<const std::uint8_t> file);

/// A damaged file: `reason` without a name and without a full stop.
Failure gltf_damaged(std::string reason);
/// The same as a message that starts with a verb, as readers of all formats say it.
Failure unreadable_model(const std::string& reason);

}  // namespace zstrip::sim
