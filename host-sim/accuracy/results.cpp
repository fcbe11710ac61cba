// CSV and JSON.
#include "accuracy/results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "accuracy/page.hpp"
#include "accuracy/plot.hpp"

namespace zstrip::sim {
namespace {

template <class T>
std::string field(const std::optional<T>& value) {
  return value ? fmt::format(",{}", *value) : ",";
}

/// Quotes a name: names of files may contain commas and quotes.
std::string csv_text(const std::string& name) {
  if (name.find_first_of(",\"") == std::string::npos) return name;
  std::string text = "\"";
  for (const char c : name) text += c == '"' ? "\"\"" : std::string(1, c);
  return text + '"';
}

std::string settings_text(const Settings& settings) {
  std::string text = to_text(settings);
  std::ranges::replace(text, ',', ' ');
  return text;
}

std::string names_of_figures() {
  std::string names;
  for (const FigureInfo& figure : figures()) names += fmt::format(",{}", figure.name);
  return names + '\n';
}

std::string figures_text(const Errors& errors) {
  std::string text;
  for (const double value : errors.value) text += std::isnan(value) ? "," : fmt::format(",{:.6g}", value);
  return text + '\n';
}

/// A scene's points with the same settings, by target.
using SamePoints = std::map<std::string, const AccuracyPoint*>;

}  // namespace

std::string accuracy_csv(std::span<const Campaign> campaigns) {
  std::vector<std::string> targets;
  std::map<std::pair<std::string, std::string>, SamePoints> rows;
  for (const Campaign& campaign : campaigns) {
    const std::string& target = campaign.request.target;
    if (std::ranges::find(targets, target) == targets.end()) targets.push_back(target);
    for (const AccuracyPoint& point : campaign.points)
      rows[{scene_name(campaign.request), settings_text(point.settings)}][target] = &point;
  }
  std::string csv = "scene,settings";
  for (const std::string& target : targets) csv += "," + (target == "host" ? "nanoseconds" : target);
  csv += ",ram_bytes,scene_bytes,program_bytes" + names_of_figures();
  for (const auto& [key, points] : rows) {
    csv += fmt::format("{},{}", csv_text(key.first), key.second);
    for (const std::string& target : targets) {
      const auto found = points.find(target);
      csv += found == points.end() ? ","
             : target == "host"    ? fmt::format(",{:.0f}", found->second->cost.nanoseconds)
                                   : field(found->second->cost.instructions);
    }
    const auto m3 = points.find("m3");
    const AccuracyPoint& point = *(m3 == points.end() ? points.begin() : m3)->second;
    csv += fmt::format(",{},{}", point.cost.ram_bytes, point.cost.scene_bytes) + field(point.cost.program_bytes) +
           figures_text(point.errors);
  }
  return csv;
}

std::string causes_csv(std::span<const Campaign> campaigns) {
  std::string csv = "scene,cause,settings" + names_of_figures();
  std::map<std::string, const Campaign*> scenes;  // the causes are the same for all targets of a scene
  for (const Campaign& campaign : campaigns) scenes.try_emplace(scene_name(campaign.request), &campaign);
  for (const auto& [scene, campaign] : scenes) {
    for (const CauseErrors& found : campaign->causes) {
      csv += fmt::format("{},{},{}", csv_text(scene), info(found.of.cause).name, settings_text(found.of.settings)) +
             figures_text(found.errors);
    }
  }
  return csv;
}

std::string accuracy_json(std::span<const Campaign> campaigns) {
  using nlohmann::json;
  json all = json::array();
  for (const Campaign& campaign : campaigns) {
    const AccuracyRequest& request = campaign.request;
    json object{{"scene", request.scene},        {"target", request.target}, {"width", request.view.width},
                {"height", request.view.height}, {"poses", request.frames},  {"points", json::array()}};
    const AccuracyPoint* best = recommended(campaign);
    object["recommended"] = best == nullptr ? json(nullptr) : json(to_text(best->settings));
    for (const AccuracyPoint& point : campaign.points) {
      json entry = json::parse(point_json(point));
      entry["front"] = point.on_front;
      entry["command"] = command_of(point, request);
      object["points"].push_back(std::move(entry));
    }
    object["causes"] = json::array();
    for (const CauseErrors& found : campaign.causes) {
      json entry{{"cause", info(found.of.cause).name}, {"settings", to_text(found.of.settings)}};
      for (std::size_t i = 0; i < kFigures; ++i) {
        const double value = found.errors.value[i];
        entry["errors"][std::string(figures()[i].name)] = std::isnan(value) ? json(nullptr) : json(value);
      }
      object["causes"].push_back(std::move(entry));
    }
    all.push_back(std::move(object));
  }
  return all.dump(1) + "\n";
}

}  // namespace zstrip::sim
