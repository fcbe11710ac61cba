// URIs that contain their data (RFC 2397), and escapes in other URIs (RFC 3986).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace zstrip::sim {

bool is_data_uri(std::string_view uri);
/// Returns the bytes of a data URI; nothing if its base64 is damaged.
std::optional<std::vector<std::uint8_t>> bytes_of_data_uri(std::string_view uri);
/// Returns "a b" for "a%20b"; invalid escapes do not change.
std::string without_escapes(std::string_view uri);

}  // namespace zstrip::sim
