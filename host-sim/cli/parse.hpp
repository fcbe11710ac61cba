// Parses the values of command-line options. Each failure is a usage error that says the option, its value and the
// accepted values.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "image/encode.hpp"
#include "import/source_model.hpp"
#include "result.hpp"
#include "zstrip/budget.hpp"
#include "zstrip/effects.hpp"
#include "zstrip/scene.hpp"
#include "zstrip/scene/depth_format.hpp"
#include "zstrip/view.hpp"

namespace zstrip::sim {

/// `message` is one line.
Failure usage(std::string message);

/// Parses "320x240": each side 1..4096.
Result<std::pair<std::uint16_t, std::uint16_t>> parse_size(const std::string& text);

/// Parses "20000", "20K" or "4M" (1024 and 1024 * 1024 bytes), also "20KB" or "20 KiB" in any case; 1 to 4 GB - 1.
/// `option`: for the failure.
Result<std::uint32_t> parse_bytes(const std::string& text, std::string_view option = "--ram");

/// Parses "auto" as 0, else 1..4096.
Result<std::uint16_t> parse_strip_rows(const std::string& text);

/// Parses "auto" as 0, else 1..4096. The planner checks if it fits the picture.
Result<std::uint16_t> parse_strip_columns(const std::string& text);

/// Parses both into the budget of a picture of this size; also a usage error if the picture cannot be divided like
/// that.
Result<Done> parse_strips(const std::string& rows, const std::string& columns, const View& view, Budget& budget);

/// Parses "x,y,z": finite numbers; `option` is for the message.
Result<std::array<double, 3>> parse_vector(const std::string& option, const std::string& text);

/// Parses "ced3d6" or "#ced3d6"; `option` is for the message.
Result<Colour> parse_colour(const std::string& option, const std::string& text);

/// Parses z16, float or z24.
Result<DepthFormat> parse_depth_format(const std::string& text);
/// Returns one of effect::perspective_runs, or nothing for runs of 16.
Result<Effects> parse_perspective(const std::string& text);
Result<PixelFormat> parse_format(const std::string& text);
/// Parses "x", "-x", "y", ...; empty: not given.
Result<std::optional<UpAxis>> parse_up_axis(const std::optional<std::string>& text);
Result<ImageType> parse_image_type(const std::string& text);

}  // namespace zstrip::sim
