// The dynamic z-buffer's table as text and as JSON.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

#include "bench/dynamic_z_table.hpp"
#include "report/frame_record.hpp"
#include "text/number.hpp"

namespace zstrip::sim {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kLine =
    "{:<10} {:<16} {:>7} {:>9} {:>9} {:>9}  {:<16} {:<5} {:>8} {:>12} {:>5} {:>8}   {:>7} {:<5} {:>9}\n";

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
      fmt::runtime(kLine), row.memory == DepthMemory::classic ? fmt::format("{0}x{0}", row.picture.side) : "",
      name(row.memory), row.allowed_bytes != 0 ? grouped(row.allowed_bytes) : "-", grouped(row.plan.depth_bytes),
      grouped(row.plan.bytes()), grouped(row.pixel_bytes), shape(row), yes_or_no(row.right), grouped(row.vertices),
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
      {"allowed_bytes", nullptr},
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
      {"vertices_transformed", row.vertices},
      {"instructions_per_frame", nullptr},
      {"ns_per_frame", row.nanoseconds},
      {"compared_with", nullptr},
      {"ratio", nullptr},
      {"paper", nullptr},
  };
  if (row.allowed_bytes != 0) object["allowed_bytes"] = row.allowed_bytes;
  if (row.instructions) object["instructions_per_frame"] = *row.instructions;
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
  std::string text =
      fmt::format(fmt::runtime(kLine), "picture", "memory", "allowed", "z-buffer", "arena", "pixels", "strips", "right",
                  "vertices", "instructions", "ratio", "time", "paper's", "right", "time");
  for (const DynamicZRow& row : rows) text += line(row, rows);
  text += fmt::format("One frame of {} triangles. z-buffer, arena and the pixels of a strip are in bytes.\n",
                      grouped(kTorusKnotTriangles));
  text += "classic: the z-buffer has the size of the view, 1024x768, and is cleared in whole.\n";
  text += "rectangle: it has that of the figure, the paper's dynamic one.\n";
  text += "small: the arena keeps to the bytes allowed; small-and-pixels: arena and pixels together do.\n";
  text += "vertices: transformed, again in each strip that their meshlet touches.\n";
  const bool counted = std::ranges::all_of(rows, [](const DynamicZRow& row) { return row.instructions.has_value(); });
  text += fmt::format("ratio, of {}: rectangle to classic, the others to rectangle.\n",
                      counted ? "instructions" : "time, as valgrind, which counts instructions, cannot be run");
  text += fmt::format("right: the pixels are those of a view of {0}x{0}. The paper's times are of a Pentium 4.\n",
                      kJudgeSide);
  return text;
}

std::string dynamic_z_json(std::span<const DynamicZRow> rows) {
  Json list = Json::array();
  for (const DynamicZRow& row : rows) list.push_back(to_object(row, rows));
  return list.dump(2) + "\n";
}

}  // namespace zstrip::sim
