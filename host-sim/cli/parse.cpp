// Parses the values of command-line options.
#include "cli/parse.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <optional>
#include <string_view>
#include <vector>

#include "cli/nearest_name.hpp"
#include "compose/perspective_runs.hpp"
#include "image/to_rgb.hpp"
#include "report/frame_record.hpp"
#include "text/colour.hpp"
#include "text/text.hpp"

namespace zstrip::sim {
namespace {

Failure bad_value(std::string_view option, std::string_view value, std::string_view expected) {
  return {ExitStatus::usage, fmt::format("{} '{}' must be {}", option, value, expected)};
}

/// Parses the whole text as a number.
template <typename T>
std::optional<T> number(std::string_view text) {
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// Returns the value with the name `text`.
template <typename T, std::size_t size>
Result<T> named(std::string_view option, std::string_view text, const std::pair<std::string_view, T> (&values)[size]) {
  std::vector<std::string_view> names;
  for (const auto& [name, value] : values) {
    if (text == name) return value;
    names.push_back(name);
  }
  return usage(unknown_name(option, text, names));
}

}  // namespace

Failure usage(std::string message) { return {ExitStatus::usage, std::move(message)}; }

Result<std::pair<std::uint16_t, std::uint16_t>> parse_size(const std::string& text) {
  const auto side = [](std::string_view part) {
    const auto value = number<std::uint16_t>(part);
    return value && *value >= 1 && *value <= kMaxViewSize ? *value : std::uint16_t{0};
  };
  const std::size_t cross = text.find('x');
  if (cross != std::string::npos) {
    const std::uint16_t width = side(std::string_view(text).substr(0, cross));
    const std::uint16_t height = side(std::string_view(text).substr(cross + 1));
    if (width > 0 && height > 0) return std::pair{width, height};
  }
  return bad_value("--size", text, "WIDTHxHEIGHT, each from 1 to 4096, for example 320x240");
}

Result<std::uint32_t> parse_bytes(const std::string& text, std::string_view option) {
  constexpr std::pair<std::string_view, std::uint64_t> kUnits[] = {{"", 1},         {"b", 1},         {"k", 1 << 10},
                                                                   {"kb", 1 << 10}, {"kib", 1 << 10}, {"m", 1 << 20},
                                                                   {"mb", 1 << 20}, {"mib", 1 << 20}};
  const std::size_t digits = std::min(text.find_first_not_of("0123456789"), text.size());
  const std::size_t letters = std::min(text.find_first_not_of(' ', digits), text.size());
  const auto* const unit =
      std::ranges::find(kUnits, lower(text.substr(letters)), [](const auto& u) { return u.first; });
  const auto value = number<std::uint32_t>(std::string_view(text).substr(0, digits));
  if (unit != std::end(kUnits) && value && *value >= 1 && *value * unit->second <= 0xFFFFFFFF) {
    return static_cast<std::uint32_t>(*value * unit->second);
  }
  return bad_value(option, text,
                   "a number of bytes from 1 to 4095M, for example 20000, 20K or 1M; K, KB and KiB are 1024 bytes");
}

Result<std::uint16_t> parse_strip_rows(const std::string& text) {
  if (text == "auto") return std::uint16_t{0};
  const auto value = number<std::uint16_t>(text);
  if (value && *value >= 1 && *value <= kMaxViewSize) return *value;
  return bad_value("--strip-rows", text, "a number of rows from 1 to 4096, or auto");
}

Result<std::uint16_t> parse_strip_columns(const std::string& text) {
  if (text == "auto") return std::uint16_t{0};
  const auto value = number<std::uint16_t>(text);
  if (value && *value >= 1 && *value <= kMaxViewSize) return *value;
  return bad_value("--strip-columns", text, "a multiple of 8 up to the picture's width, or auto");
}

Result<Done> parse_strips(const std::string& rows_text, const std::string& columns_text, const View& view,
                          Budget& budget) {
  const Result<std::uint16_t> rows = parse_strip_rows(rows_text);
  if (!rows) return rows.failure();
  if (*rows > view.height) {
    return Failure{ExitStatus::usage,
                   fmt::format("--strip-rows {} is more than the picture's {} rows", *rows, view.height)};
  }
  const Result<std::uint16_t> columns = parse_strip_columns(columns_text);
  if (!columns) return columns.failure();
  if (*columns > view.width || (*columns != view.width && *columns % 8 != 0)) {
    return Failure{
        ExitStatus::usage,
        fmt::format("--strip-columns {} is neither a multiple of 8 up to the picture's {} columns nor all of them",
                    *columns, view.width)};
  }
  budget.strip_rows = *rows;
  budget.strip_columns = *columns;
  return Done{};
}

Result<std::array<double, 3>> parse_vector(const std::string& option, const std::string& text) {
  std::array<double, 3> vector{};
  std::string_view rest = text;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t comma = i < 2 ? rest.find(',') : rest.size();
    if (comma == std::string_view::npos)
      return bad_value(option, text, "three numbers with commas, for example 0,1.5,-3");
    const auto value = number<double>(rest.substr(0, comma));
    if (!value || !std::isfinite(*value)) {
      return bad_value(option, text, "three numbers with commas, for example 0,1.5,-3");
    }
    vector[i] = *value;
    rest.remove_prefix(i < 2 ? comma + 1 : comma);
  }
  return vector;
}

Result<Colour> parse_colour(const std::string& option, const std::string& text) {
  const auto colour = sim::parse_colour(std::string_view(text).substr(text.starts_with('#') ? 1 : 0));
  if (colour) return *colour;
  return bad_value(option, text, "red, green and blue, two hexadecimal digits each, for example ced3d6");
}

Result<PixelFormat> parse_format(const std::string& text) {
  std::vector<std::string_view> names;
  for (int index = 0; index <= static_cast<int>(kLastPixelFormat); ++index) {
    const auto format = static_cast<PixelFormat>(index);
    names.emplace_back(name(format));
    if (text == names.back()) return format;
  }
  return usage(unknown_name("--format", text, names));
}

Result<DepthFormat> parse_depth_format(const std::string& text) {
  constexpr std::pair<std::string_view, DepthFormat> kFormats[] = {
      {"z16", DepthFormat::z16}, {"float", DepthFormat::float16}, {"z24", DepthFormat::z24}};
  return named("--depth-format", text, kFormats);
}

Result<Effects> parse_perspective(const std::string& text) { return named("--perspective", text, kPerspectiveRuns); }

Result<std::optional<UpAxis>> parse_up_axis(const std::optional<std::string>& text) {
  if (!text) return std::optional<UpAxis>();
  constexpr std::pair<std::string_view, UpAxis> kAxes[] = {{"x", UpAxis::plus_x}, {"-x", UpAxis::minus_x},
                                                           {"y", UpAxis::plus_y}, {"-y", UpAxis::minus_y},
                                                           {"z", UpAxis::plus_z}, {"-z", UpAxis::minus_z}};
  const Result<UpAxis> axis = named("--up", *text, kAxes);
  if (!axis) return axis.failure();
  return std::optional<UpAxis>(*axis);
}

Result<ImageType> parse_image_type(const std::string& text) {
  constexpr std::pair<std::string_view, ImageType> kTypes[] = {
      {"png", ImageType::png}, {"jpeg", ImageType::jpeg}, {"ppm", ImageType::ppm}, {"raw", ImageType::raw}};
  return named("--image", text, kTypes);
}

}  // namespace zstrip::sim
