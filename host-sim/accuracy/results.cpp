// CSV and JSON.
#include "accuracy/results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "accuracy/page.hpp"
#include "accuracy/plot.hpp"

namespace zstrip::sim {
namespace {

template <class T>
std::string field(const std::optional<T>& value) {
  return value ? fmt::format("{}", *value) : "";
}

/// Names of files may hold commas and quotes.
std::string csv_text(std::string_view name) {
  std::string text = "\"";
  for (const char c : name) text += c == '"' ? "\"\"" : std::string(1, c);
  return text + '"';
}

std::string number_field(double value) { return std::isnan(value) ? "," : fmt::format(",{:.6g}", value); }

}  // namespace

std::string accuracy_csv(std::span<const Campaign> campaigns) {
  std::string csv = "scene,target,width,height,poses,settings";
  for (const KnobInfo& knob : knobs()) csv += fmt::format(",{}", knob.name);
  csv += ",front,nanoseconds,instructions,least_fps,most_fps,ram_bytes,scene_bytes,program_bytes";
  for (const FigureInfo& figure : figures()) csv += fmt::format(",{}", figure.name);
  csv += '\n';
  for (const Campaign& campaign : campaigns) {
    const AccuracyRequest& request = campaign.request;
    for (const AccuracyPoint& point : campaign.points) {
      std::string settings = to_text(point.settings);
      std::ranges::replace(settings, ',', ' ');
      csv += fmt::format("{},{},{},{},{},{}", csv_text(request.scene), request.target, request.view.width,
                         request.view.height, request.frames, settings);
      for (const KnobInfo& knob : knobs()) csv += fmt::format(",{}", point.settings.name_of(knob.knob));
      const Cost& cost = point.cost;
      csv += fmt::format(",{},{:.0f},{},{},{},{},{},{}", point.on_front ? 1 : 0, cost.nanoseconds,
                         field(cost.instructions), field(cost.least_fps), field(cost.most_fps), cost.ram_bytes,
                         cost.scene_bytes, field(cost.program_bytes));
      for (const double value : point.errors.value) csv += number_field(value);
      csv += '\n';
    }
  }
  return csv;
}

std::string causes_csv(std::span<const Campaign> campaigns) {
  std::string csv = "scene,width,height,poses,cause,settings";
  for (const FigureInfo& figure : figures()) csv += fmt::format(",{}", figure.name);
  csv += '\n';
  const Campaign* last = nullptr;
  for (const Campaign& campaign : campaigns) {
    // Of all targets of a scene the same.
    const AccuracyRequest& request = campaign.request;
    if (last != nullptr && last->request.scene == request.scene) continue;
    last = &campaign;
    for (const CauseErrors& found : campaign.causes) {
      std::string settings = to_text(found.of.settings);
      std::ranges::replace(settings, ',', ' ');
      csv += fmt::format("{},{},{},{},{},{}", csv_text(request.scene), request.view.width, request.view.height,
                         request.frames, info(found.of.cause).name, settings);
      for (const double value : found.errors.value) csv += number_field(value);
      csv += '\n';
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
