// The dynamic z-buffer's table as text and as JSON.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <utility>

#include "bench/dynamic_z_table.hpp"
#include "report/frame_record.hpp"
#include "report/number.hpp"

namespace zstrip::sim {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kLine = "{:<10} {:<17} {:>9} {:>9} {:>9}  {:<17} {:<5} {:>12} {:>6} {:>9}   {:>9} {:<5} {:>9}\n";

std::string shape(const DynamicZRow& row) {
  return fmt::format("{} of {}x{}", row.plan.strips, row.plan.strip_columns, row.plan.strip_rows);
}

const char* yes_or_no(bool value) { return value ? "yes" : "no"; }

/// The paper's figures for this row; empty where it has none.
struct PaperRow {
  bool right;
  const PaperFigures* figures;
};
std::optional<PaperRow> paper_row(const DynamicZRow& row) {
  const DynamicZPicture& picture = row.picture;
  if (row.memory == DepthMemory::classic) {
    return PaperRow{picture.classic_right, picture.classic_right ? &picture.classic : nullptr};
  }
  if (row.memory == DepthMemory::rectangle) return PaperRow{true, &picture.dynamic};
  return std::nullopt;
}

std::string line(const DynamicZRow& row, std::span<const DynamicZRow> rows) {
  const std::optional<PaperRow> paper = paper_row(row);
  const bool figures = paper && paper->figures != nullptr;
  const DynamicZRow* const other = compared_with(row, rows);
  return fmt::format(
      fmt::runtime(kLine), fmt::format("{0}x{0}", row.picture.side), name(row.memory), grouped(row.plan.depth_bytes),
      grouped(row.plan.bytes()), grouped(row.pixel_bytes), shape(row), yes_or_no(row.right),
      row.instructions ? fmt::format("{:.3f} M", static_cast<double>(*row.instructions) / 1e6) : "not counted",
      other != nullptr ? fmt::format("{:.2f}", work_ratio(row, *other)) : "-",
      fmt::format("{:.2f} ms", row.nanoseconds / 1e6), figures ? fmt::format("{} KB", paper->figures->kilobytes) : "-",
      paper ? yes_or_no(paper->right) : "-", figures ? fmt::format("{:.2f} ms", paper->figures->milliseconds) : "-");
}

Json to_object(const DynamicZRow& row, std::span<const DynamicZRow> rows) {
  const Plan& plan = row.plan;
  Json object{
      {"table", "dynamic-z"},
      {"picture", {{"width", row.picture.side}, {"height", row.picture.side}}},
      {"memory", name(row.memory)},
      {"view", {{"width", row.view.width}, {"height", row.view.height}}},
      {"plan",
       {{"mode", name(plan.mode)},
        {"strips", plan.strips},
        {"strip_rows", plan.strip_rows},
        {"strip_columns", plan.strip_columns}}},
      {"bytes",
       {{"instances", plan.instance_bytes},
        {"extents", plan.extent_bytes},
        {"vertices", plan.vertex_bytes},
        {"depth", plan.depth_bytes},
        {"arena", plan.bytes()},
        {"pixels", row.pixel_bytes}}},
      {"right", row.right},
      {"crc32", fmt::format("{:08x}", row.crc32)},
      {"instructions", nullptr},
      {"ns", row.nanoseconds},
      {"compared_with", nullptr},
      {"ratio", nullptr},
      {"paper", nullptr},
  };
  if (row.instructions) object["instructions"] = *row.instructions;
  if (const DynamicZRow* const other = compared_with(row, rows)) {
    object["compared_with"] = name(other->memory);
    object["ratio"] = work_ratio(row, *other);
  }
  if (const std::optional<PaperRow> paper = paper_row(row)) {
    object["paper"] = {{"right", paper->right}, {"kilobytes", nullptr}, {"milliseconds", nullptr}};
    if (paper->figures != nullptr) {
      object["paper"]["kilobytes"] = paper->figures->kilobytes;
      object["paper"]["milliseconds"] = paper->figures->milliseconds;
    }
  }
  return object;
}

}  // namespace

std::string dynamic_z_text(std::span<const DynamicZRow> rows) {
  std::string text = fmt::format(fmt::runtime(kLine), "picture", "memory", "z-buffer", "arena", "pixels", "strips",
                                 "right", "instructions", "ratio", "time", "paper's", "right", "time");
  for (const DynamicZRow& row : rows) text += line(row, rows);
  const bool counted = std::ranges::all_of(rows, [](const DynamicZRow& row) { return row.instructions.has_value(); });
  text += fmt::format(
      "{} triangles. Bytes of the z-buffer, of the whole arena and of one strip's pixels; {}.\n"
      "Ratio of {}: \"rectangle\" to \"classic\", \"small\" and \"small-and-pixels\" to \"rectangle\".\n"
      "Right: the pixels are those of a view of {}x{}, which cuts nothing. The paper's times are of a Pentium 4.\n",
      grouped(kTorusKnotTriangles), "what of these little memory has to hold is in the rows' names",
      counted ? "instructions" : "time (valgrind, which counts instructions, is missing)", kJudgeSide, kJudgeSide);
  return text;
}

std::string dynamic_z_json(std::span<const DynamicZRow> rows) {
  Json list = Json::array();
  for (const DynamicZRow& row : rows) list.push_back(to_object(row, rows));
  return list.dump(2) + "\n";
}

}  // namespace zstrip::sim
