// The journal of a campaign: one line of JSON for each point, so that a run that was interrupted loses nothing.
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

/// What makes two measurements the same: scene, size, poses, target, settings, and the programs that measured.
std::string journal_key(const AccuracyRequest& request, const Settings& settings, std::uint32_t programs);

/// A number that changes with this program, and with the file `more` if there is one.
Result<std::uint32_t> fingerprint(const std::filesystem::path& more);

class Journal {
 public:
  /// Reads what is there; lines that are not whole, the last one of a run that was ended, are left out.
  static Result<Journal> open(const std::filesystem::path& file);

  /// What was measured under this key; nothing if it was not.
  std::optional<AccuracyPoint> find(const std::string& key) const;
  /// Writes a line and hands it to the system at once. Not safe from several threads.
  Result<Done> add(const std::string& key, const AccuracyPoint& point);

 private:
  std::filesystem::path path_;
  std::map<std::string, AccuracyPoint> points_;
  std::ofstream out_;
};

/// A point as JSON, without what the campaign adds; NaN becomes null.
std::string point_json(const AccuracyPoint& point);

}  // namespace zstrip::sim
