// Lines of CSV to points of campaigns.
#include "accuracy/recorded.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <map>
#include <sstream>
#include <string_view>

namespace zstrip::sim {
namespace {

/// Throws std::out_of_range and std::invalid_argument where a field is missing or no number.
AccuracyPoint point_of(const std::map<std::string, std::size_t>& at, const std::vector<std::string>& row) {
  const auto field = [&](std::string_view name) { return row.at(at.at(std::string(name))); };
  AccuracyPoint point{.scene = field("scene"), .target = "m3", .settings = {}, .part = "one", .errors = {}, .cost = {}};
  std::string settings = field("settings");
  std::ranges::replace(settings, ' ', ',');
  const Result<Settings> read = parse_settings(settings);
  if (!read) throw std::invalid_argument(read.failure().message);
  point.settings = *read;
  point.cost.instructions = std::stoull(field("m3"));
  point.cost.ram_bytes = std::stoull(field("ram_bytes"));
  point.cost.scene_bytes = std::stoull(field("scene_bytes"));
  for (std::size_t i = 0; i < kFigures; ++i) {
    const std::string value = field(figures()[i].name);
    point.errors.value[i] = value.empty() ? std::numeric_limits<double>::quiet_NaN() : std::stod(value);
  }
  return point;
}

}  // namespace

std::vector<std::string> csv_fields(const std::string& line) {
  std::vector<std::string> found;
  std::istringstream stream(line);
  for (std::string field; std::getline(stream, field, ',');) found.push_back(field);
  return found;
}

Result<std::vector<Campaign>> read_recorded(const std::string& file) {
  std::ifstream csv(file);
  std::string line;
  if (!std::getline(csv, line)) return Failure{ExitStatus::input, fmt::format("'{}' cannot be read", file)};
  std::map<std::string, std::size_t> at;
  const std::vector<std::string> names = csv_fields(line);
  for (std::size_t i = 0; i < names.size(); ++i) at[names[i]] = i;
  std::vector<Campaign> campaigns;
  while (std::getline(csv, line)) {
    std::vector<std::string> row = csv_fields(line);
    row.resize(names.size());
    try {
      if (row.at(at.at("m3")).empty()) continue;
      AccuracyPoint point = point_of(at, row);
      if (campaigns.empty() || campaigns.back().request.scene != point.scene) {
        campaigns.push_back(
            {.request = {.scene = point.scene, .view = {}, .target = "m3", .firmware = ""}, .points = {}});
      }
      campaigns.back().points.push_back(std::move(point));
    } catch (const std::exception& error) {
      return Failure{ExitStatus::input, fmt::format("'{}' is no table of accuracy figures: {} in the line '{}'", file,
                                                    error.what(), line)};
    }
  }
  for (Campaign& campaign : campaigns) find_front(campaign);
  return campaigns;
}

}  // namespace zstrip::sim
