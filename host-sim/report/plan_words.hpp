// A plan in words.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "zstrip/budget.hpp"
#include "zstrip/effects.hpp"

namespace zstrip::sim {

/// Returns "streamed, 4 strips of 16 rows", or "streamed, 24 strips of 56x60".
std::string shape(const Plan& plan, const View& view);

/// Returns the bytes of each purpose, in the order of a plan's table.
std::array<std::pair<Purpose, std::uint32_t>, 7> by_purpose(const Plan& plan);

/// Returns "1,234 bytes (instances 160, depth 1,074), and 512 for the pixels of a strip".
std::string memory(const Plan& plan, std::uint32_t strip_pixel_bytes, Effects method);

/// Says how many bytes a visibility method takes and saves in a plan: "painter: 800 bytes for sorting, 30,720 bytes of
/// z-buffer saved".
std::string visibility_words(const Plan& plan, Effects method);

/// Returns the names of the `effects` that estimated_cost does not include.
std::vector<std::string> left_out_of_estimates(Effects effects);

}  // namespace zstrip::sim
