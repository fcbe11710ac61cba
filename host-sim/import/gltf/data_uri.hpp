// URIs that hold their data themselves (RFC 2397), and escapes in those that do not (RFC 3986).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace zstrip::sim {

bool is_data_uri(std::string_view uri);
/// The bytes of a data URI; none where its base64 is damaged.
std::optional<std::vector<std::uint8_t>> bytes_of_data_uri(std::string_view uri);
/// "a%20b" as "a b"; what is no escape stays as it is.
std::string without_escapes(std::string_view uri);

}  // namespace zstrip::sim
