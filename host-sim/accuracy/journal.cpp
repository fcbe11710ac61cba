// Converts points to lines of JSON and back.
#include "accuracy/journal.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <vector>

namespace zstrip::sim {
namespace {

using nlohmann::json;

json number_or_null(double value) { return std::isfinite(value) ? json(value) : json(nullptr); }

template <class T>
void set(json& object, const char* name, const std::optional<T>& value) {
  object[name] = value ? json(*value) : json(nullptr);
}

template <class T>
std::optional<T> optional_of(const json& value) {
  if (value.is_null()) return std::nullopt;
  return value.get<T>();
}

json to_object(const AccuracyPoint& point) {
  json object;
  object["scene"] = point.scene;
  object["target"] = point.target;
  object["settings"] = to_text(point.settings);
  for (const KnobInfo& knob : knobs()) object["knobs"][std::string(knob.name)] = point.settings.name_of(knob.knob);
  for (std::size_t i = 0; i < kFigures; ++i) {
    object["errors"][std::string(figures()[i].name)] = number_or_null(point.errors.value[i]);
  }
  json& cost = object["cost"];
  cost["nanoseconds"] = point.cost.nanoseconds;
  set(cost, "instructions", point.cost.instructions);
  set(cost, "least_fps", point.cost.least_fps);
  set(cost, "most_fps", point.cost.most_fps);
  cost["ram_bytes"] = point.cost.ram_bytes;
  cost["scene_bytes"] = point.cost.scene_bytes;
  set(cost, "program_bytes", point.cost.program_bytes);
  return object;
}

/// Throws nlohmann::json::exception if the object is not a point.
std::optional<AccuracyPoint> to_point(const json& object) {
  AccuracyPoint point;
  point.scene = object.at("scene");
  point.target = object.at("target");
  const Result<Settings> settings = parse_settings(object.at("settings").get<std::string>());
  if (!settings) return std::nullopt;
  point.settings = *settings;
  for (std::size_t i = 0; i < kFigures; ++i) {
    point.errors.value[i] = optional_of<double>(object.at("errors").at(std::string(figures()[i].name)))
                                .value_or(std::numeric_limits<double>::quiet_NaN());
  }
  const json& cost = object.at("cost");
  point.cost.nanoseconds = cost.at("nanoseconds");
  point.cost.instructions = optional_of<std::uint64_t>(cost.at("instructions"));
  point.cost.least_fps = optional_of<double>(cost.at("least_fps"));
  point.cost.most_fps = optional_of<double>(cost.at("most_fps"));
  point.cost.ram_bytes = cost.at("ram_bytes");
  point.cost.scene_bytes = cost.at("scene_bytes");
  point.cost.program_bytes = optional_of<std::uint64_t>(cost.at("program_bytes"));
  return point;
}

}  // namespace

std::string journal_key(const AccuracyRequest& request, const Settings& settings, std::uint32_t programs) {
  return fmt::format("{}|{}x{}|{}|{}|{}|{:08x}", request.scene, request.view.width, request.view.height, request.frames,
                     request.target, to_text(settings), programs);
}

Result<std::uint32_t> fingerprint(const std::filesystem::path& more) {
  uLong sum = crc32_z(0, nullptr, 0);
  for (const std::filesystem::path& path : {std::filesystem::path("/proc/self/exe"), more}) {
    if (path.empty()) continue;
    std::ifstream file(path, std::ios::binary);
    std::vector<char> buffer(1 << 16);
    while (file.read(buffer.data(), static_cast<std::streamsize>(buffer.size())) || file.gcount() > 0) {
      sum = crc32_z(sum, reinterpret_cast<const Bytef*>(buffer.data()), static_cast<z_size_t>(file.gcount()));
    }
    if (file.bad()) return Failure{ExitStatus::environment, fmt::format("cannot read '{}'", path.string())};
  }
  return static_cast<std::uint32_t>(sum);
}

Result<Journal> Journal::open(const std::filesystem::path& file) {
  Journal journal;
  journal.path_ = file;
  std::ifstream in(file);
  bool whole = true;
  for (std::string line; std::getline(in, line);) {
    whole = !in.eof();
    try {
      const json object = json::parse(line);
      if (const std::optional<AccuracyPoint> point = to_point(object)) journal.points_[object.at("key")] = *point;
    } catch (const json::exception&) {
      continue;
    }
  }
  in.close();
  journal.out_.open(file, std::ios::app);
  if (!whole) journal.out_ << '\n';
  if (!journal.out_) {
    return Failure{ExitStatus::output,
                   fmt::format("'{}' cannot be written; name another folder with -o", file.string())};
  }
  return journal;
}

std::optional<AccuracyPoint> Journal::find(const std::string& key) const {
  const auto found = points_.find(key);
  if (found == points_.end()) return std::nullopt;
  return found->second;
}

Result<Done> Journal::add(const std::string& key, const AccuracyPoint& point) {
  json object = to_object(point);
  object["key"] = key;
  out_ << object.dump() << '\n' << std::flush;
  if (!out_)
    return Failure{ExitStatus::output, fmt::format("'{}' cannot be written; is the disk full?", path_.string())};
  points_[key] = point;
  return Done{};
}

std::string point_json(const AccuracyPoint& point) { return to_object(point).dump(); }

}  // namespace zstrip::sim
