// The record of a run as JSON; the keys are documented in README.md.
#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "image/to_rgb.hpp"
#include "report/frame_record.hpp"
#include "report/heat_json.hpp"
#include "report/ram_json.hpp"
#include "report/work_names.hpp"
#include "visibility/methods.hpp"

namespace zstrip::sim {
namespace {

using Json = nlohmann::ordered_json;

Json picked_json(const PickedPixel& pixel) {
  constexpr const char* kNames[] = {"background", "instance", "outline", "quadric", "line", "sprite", "label"};
  const Picked& picked = pixel.picked;
  Json object{{"x", pixel.place.x}, {"y", pixel.place.y}, {"shown", kNames[static_cast<std::size_t>(picked.shown)]}};
  if (picked.shown == Shown::background) return object;
  object["index"] = picked.index;
  if (picked.shown <= Shown::outline || picked.shown == Shown::line) object["triangle"] = picked.triangle;
  if (!pixel.name.empty()) object["name"] = pixel.name;
  if (!pixel.material.empty()) object["material"] = pixel.material;
  if (picked.textured) object["texture"] = {picked.u / 65536.0, picked.v / 65536.0};
  return object;
}

Json to_object(std::size_t index, const FrameRecord& frame, bool has_panel) {
  const FrameReport& report = frame.report;
  const Plan& plan = report.plan;
  const Statistics& statistics = report.statistics;
  const Rect& bounds = report.bounds;
  Json object{
      {"frame", index},
      {"file", frame.file},
      {"crc32", fmt::format("{:08x}", report.crc32)},
      {"time_ns", report.nanoseconds},
      {"mode", name(report.mode)},
      {"strips", plan.strips},
      {"strip_rows", plan.strip_rows},
      {"strip_columns", plan.strip_columns},
      {"ram_bytes", ram_bytes(report)},
      {"bounds", {{"left", bounds.left}, {"top", bounds.top}, {"right", bounds.right}, {"bottom", bounds.bottom}}},
      {"statistics",
       {{"triangles", statistics.triangles},
        {"drawn", statistics.drawn},
        {"clipped", statistics.clipped},
        {"covering", statistics.covering},
        {"vertices", statistics.vertices},
        {"fragments", statistics.fragments},
        {"depth_passes", statistics.depth_passes}}}};
  for (std::size_t kind = 0; kind < kWorkKinds; ++kind) {
    if (statistics.work.of[kind] != 0)
      object["statistics"]["work"][std::string(kWorkNames[kind])] = statistics.work.of[kind];
  }
  if (has_panel) {
    object["bus"] = {{"bytes", frame.bus.bytes}, {"time_ns", frame.bus.nanoseconds}};
    object["drawn_strips"] = report.drawn_strips;
  }
  if (frame.wrong) object["wrong_pixels"] = *frame.wrong;
  if (frame.heat) object["accuracy"] = heat_json(*frame.heat);
  if (frame.picked) object["picked"] = picked_json(*frame.picked);
  if (report.method.methods == 0) return object;
  const VisibilityStatistics& counts = report.visibility;
  object["ram_bytes"]["visibility"] = plan.visibility_bytes;
  object["visibility"] = {{"method", visibility_name(report.method)},
                          {"comparisons", counts.comparisons},
                          {"cells_read", counts.cells_read},
                          {"writes", counts.writes},
                          {"untested", counts.untested},
                          {"splits", counts.splits},
                          {"hidden_instances", counts.instances},
                          {"hidden_meshlets", counts.meshlets},
                          {"drawn_first", counts.drawn_first},
                          {"hidden_triangles", counts.triangles},
                          {"hidden_run_pixels", counts.run_pixels},
                          {"back_faces", counts.back_faces},
                          {"small", counts.small},
                          {"outside", counts.outside},
                          {"outside_cells", counts.outside_cells}};
  return object;
}

}  // namespace

std::string to_json(const RunRecord& run) {
  Json frames = Json::array();
  for (std::size_t i = 0; i < run.frames.size(); ++i)
    frames.push_back(to_object(i, run.frames[i], run.panel.has_value()));
  Json object = {{"scene", run.scene},        {"width", run.view.width},
                 {"height", run.view.height}, {"format", name(run.view.format)},
                 {"dither", run.view.dither}, {"samples", run.view.samples},
                 {"warnings", run.warnings}};
  if (run.panel) {
    object["panel"] = {{"name", run.panel->name},
                       {"bus", run.panel->bus},
                       {"rotation", run.panel->rotation},
                       {"mirrored", run.panel->mirrored},
                       {"changes", run.panel->changes}};
  }
  object["frames"] = std::move(frames);
  // Names of files may be any bytes; those that are not UTF-8 are replaced, not refused.
  return object.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace zstrip::sim
