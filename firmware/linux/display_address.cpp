// The text with which a user names a display: KIND:KEY=VALUE,...
#include "display_address.hpp"

#include <cctype>
#include <charconv>

namespace zstrip::panel {
namespace {

/// Parses the whole text as a decimal number, with an optional K, M or G.
std::optional<std::uint64_t> number(std::string_view text) {
  std::uint64_t value = 0;
  std::uint64_t factor = 1;
  if (text.ends_with('K')) factor = 1'000;
  if (text.ends_with('M')) factor = 1'000'000;
  if (text.ends_with('G')) factor = 1'000'000'000;
  if (factor != 1) text.remove_suffix(1);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  if (value > UINT32_MAX / factor) return std::nullopt;
  return value * factor;
}

}  // namespace

hal::Outcome<DisplayAddress> DisplayAddress::parse(const std::string& text) {
  DisplayAddress address;
  // Without a device a comma may replace the colon: drm,size=640x480.
  const std::size_t kind_end = text.find_first_of(":,");
  address.kind_ = text.substr(0, kind_end);
  std::string_view rest;
  if (kind_end != std::string::npos) {
    rest = std::string_view(text).substr(kind_end + 1);
    if (rest.empty()) return hal::Fault{"'" + text + "' has nothing behind its " + text[kind_end]};
  }
  for (bool first = true; !rest.empty(); first = false) {
    const std::size_t comma = rest.find(',');
    const std::string part(rest.substr(0, comma));
    if (comma + 1 == rest.size()) return hal::Fault{"'" + text + "' has a comma without a KEY=VALUE"};
    rest = comma == std::string_view::npos ? std::string_view() : rest.substr(comma + 1);
    const std::size_t equals = part.find('=');
    if (part.empty() || equals == 0) return hal::Fault{"'" + text + "' has a comma without a KEY=VALUE"};
    if (first && part.find('/') < equals) {
      address.device_ = part;
      continue;
    }
    if (first && equals == std::string::npos &&
        (part[0] == '@' || std::isdigit(static_cast<unsigned char>(part[0])) != 0)) {
      const std::size_t at = part.find('@');
      if (at != 0) address.values_.emplace("size", part.substr(0, at));
      if (at != std::string::npos) address.values_.emplace("scale", part.substr(at + 1));
      continue;
    }
    std::optional<std::string> value;
    if (equals != std::string::npos) value = part.substr(equals + 1);
    if (!address.values_.emplace(part.substr(0, equals), value).second)
      return hal::Fault{"'" + text + "' has " + part.substr(0, equals) + " twice"};
  }
  return address;
}

hal::Fault DisplayAddress::fault(const std::string& key, const std::string& what) const {
  return {"--display " + kind_ + ": " + key + " " + what};
}

std::optional<hal::Fault> DisplayAddress::refused_device() const {
  if (device_.empty()) return std::nullopt;
  return fault("'" + device_ + "'", "is no KEY=VALUE, which this display needs; see --help");
}

std::optional<std::string> DisplayAddress::take(const std::string& key) {
  const auto node = values_.extract(key);
  if (node.empty()) return std::nullopt;
  return node.mapped().value_or("yes");
}

hal::Outcome<std::optional<std::string>> DisplayAddress::take_name(const std::string& key) {
  const auto node = values_.extract(key);
  if (node.empty()) return std::optional<std::string>();
  if (node.mapped().value_or("").empty()) return fault(key, "needs a value");
  return node.mapped();
}

hal::Outcome<std::optional<hal::ScreenSize>> DisplayAddress::take_size(const std::string& key) {
  const std::optional<std::string> value = take(key);
  if (!value) return std::optional<hal::ScreenSize>();
  const std::size_t cross = value->find('x');
  const auto width = number(std::string_view(*value).substr(0, cross));
  const auto height = cross == std::string::npos ? std::nullopt : number(std::string_view(*value).substr(cross + 1));
  if (!width || !height || *width < 1 || *height < 1 || *width > hal::kMaxScreen || *height > hal::kMaxScreen)
    return fault(key, "must be WIDTHxHEIGHT, each 1 to 4096, not '" + *value + "'");
  return std::optional(hal::ScreenSize{static_cast<std::uint16_t>(*width), static_cast<std::uint16_t>(*height)});
}

hal::Outcome<std::optional<std::uint32_t>> DisplayAddress::take_number(const std::string& key, std::uint32_t least,
                                                                       std::uint32_t most) {
  const std::optional<std::string> value = take(key);
  if (!value) return std::optional<std::uint32_t>();
  const auto parsed = number(*value);
  if (!parsed || *parsed < least || *parsed > most) {
    return fault(key, "must be a number from " + std::to_string(least) + " to " + std::to_string(most) + ", not '" +
                          *value + "'");
  }
  return std::optional(static_cast<std::uint32_t>(*parsed));
}

hal::Outcome<bool> DisplayAddress::take_flag(const std::string& key, bool unless_given) {
  const std::optional<std::string> value = take(key);
  if (!value) return unless_given;
  if (*value == "yes") return true;
  if (*value == "no") return false;
  return fault(key, "is yes or no, not '" + *value + "'");
}

std::optional<hal::Fault> DisplayAddress::untaken() const {
  if (values_.empty()) return std::nullopt;
  return fault(values_.begin()->first, "is not known there; see --help");
}

}  // namespace zstrip::panel
