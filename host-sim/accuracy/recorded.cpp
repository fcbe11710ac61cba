// Converts lines of CSV to points of campaigns.
#include "accuracy/recorded.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <ranges>
#include <sstream>
#include <stdexcept>

namespace zstrip::sim {
namespace {

RecordedTable::Row fields_of(const std::string& line) {
  RecordedTable::Row found;
  std::istringstream stream(line);
  for (std::string field; std::getline(stream, field, ',');) found.push_back(field);
  return found;
}

/// Throws std::out_of_range and std::invalid_argument if a field is not a number.
AccuracyPoint point_of(const RecordedTable& table, const RecordedTable::Row& row) {
  const auto field = [&](std::string_view name) { return table.field(row, name); };
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

Result<RecordedTable> RecordedTable::read(const std::string& file, const std::vector<std::string>& first) {
  RecordedTable table;
  table.file_ = file;
  std::ifstream csv(file);
  std::string line;
  if (!std::getline(csv, line)) return Failure{ExitStatus::input, fmt::format("'{}' cannot be read", file)};
  table.names_ = fields_of(line);
  if (table.names_.size() < first.size() || !std::equal(first.begin(), first.end(), table.names_.begin())) {
    return Failure{ExitStatus::input,
                   fmt::format("'{}' is not a table of accuracy figures: its columns do not begin with {}", file,
                               fmt::join(first, ", "))};
  }
  while (std::getline(csv, line)) {
    table.rows_.push_back(fields_of(line));
    table.rows_.back().resize(table.names_.size());
  }
  return table;
}

std::string RecordedTable::field(const Row& row, std::string_view name) const {
  const auto found = std::ranges::find(names_, name);
  return found == names_.end() ? "" : row[static_cast<std::size_t>(found - names_.begin())];
}

const RecordedTable::Row* RecordedTable::find(const std::vector<std::string>& first) const {
  const auto found = std::ranges::find_if(rows_, [&](const Row& row) {
    return row.size() >= first.size() && std::ranges::equal(first.begin(), first.end(), row.begin(),
                                                            row.begin() + static_cast<std::ptrdiff_t>(first.size()));
  });
  return found == rows_.end() ? nullptr : &*found;
}

Result<std::vector<Campaign>> recorded_campaigns(const RecordedTable& table) {
  std::vector<Campaign> campaigns;
  for (const RecordedTable::Row& row : table.rows()) {
    if (table.field(row, "m3").empty()) continue;
    try {
      AccuracyPoint point = point_of(table, row);
      if (campaigns.empty() || campaigns.back().request.scene != point.scene) {
        campaigns.push_back(
            {.request = {.scene = point.scene, .view = {}, .target = "m3", .firmware = ""}, .points = {}});
      }
      campaigns.back().points.push_back(std::move(point));
    } catch (const std::exception& error) {
      return Failure{ExitStatus::input,
                     fmt::format("'{}' is not a table of accuracy figures: {} in the line of {}, {}", table.file(),
                                 error.what(), table.field(row, "scene"), table.field(row, "settings"))};
    }
  }
  for (Campaign& campaign : campaigns) find_front(campaign);
  return campaigns;
}

}  // namespace zstrip::sim
