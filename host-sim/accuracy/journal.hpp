// The journal of a campaign: one line of JSON for each point, so that an interrupted run loses no measurement.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <string>

#include "accuracy/measure.hpp"
#include "result.hpp"

namespace zstrip::sim {

/// Returns the key of a measurement: scene, size, poses, target, settings, and the programs that measured.
std::string journal_key(const AccuracyRequest& request, const Settings& settings, std::uint32_t programs);

/// Returns a number that changes with this program, and with the file `more` if it exists.
Result<std::uint32_t> fingerprint(const std::filesystem::path& more);

class Journal {
 public:
  /// Reads the existing file. Incomplete lines are ignored, such as the last line of an interrupted run.
  static Result<Journal> open(const std::filesystem::path& file);

  /// Returns the point that was measured under this key, or nothing.
  std::optional<AccuracyPoint> find(const std::string& key) const;
  /// Writes a line and flushes it at once. Not safe from several threads.
  Result<Done> add(const std::string& key, const AccuracyPoint& point);

 private:
  std::filesystem::path path_;
  std::map<std::string, AccuracyPoint> points_;
  std::ofstream out_;
};

/// Returns a point as JSON, without the data that the campaign adds; NaN becomes null.
std::string point_json(const AccuracyPoint& point);

}  // namespace zstrip::sim
