// The visibility tables as text and as JSON.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "bench/visibility_table.hpp"
#include "text/number.hpp"

namespace zstrip::sim {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kLine =
    "{:<14} {:<10} {:<29} {:>2} {:<6} {:>12} {:>10} {:>10} {:>8} {:>8} {:>9} {:>9} {:>9} {:>12} {:>9}\n";

const char* name(DepthFormat format) {
  switch (format) {
    case DepthFormat::float16: return "float";
    case DepthFormat::z24: return "z24";
    case DepthFormat::z16: break;
  }
  return "z16";
}

bool has_iterations(const VisibilityRow& row) { return row.row_case.method.starts_with("midpoint"); }
bool has_depth(const VisibilityRow& row) { return row.plan.depth_bytes != 0; }

double overdraw(const VisibilityRow& row) {
  return row.written == 0 ? 0 : static_cast<double>(row.writes) / static_cast<double>(row.written);
}

std::string line(const VisibilityRow& row) {
  const VisibilityRowCase& c = row.row_case;
  return fmt::format(fmt::runtime(kLine), c.scene, fmt::format("{}x{}", c.view.width, c.view.height), c.method,
                     has_iterations(row) ? std::to_string(c.iterations) : "-",
                     has_depth(row) ? name(c.depth_format) : "-", grouped(row.comparisons), grouped(row.cells_read),
                     grouped(row.writes), fmt::format("{:.2f}", overdraw(row)), grouped(row.splits), grouped(row.wrong),
                     grouped(row.plan.depth_bytes), grouped(row.plan.visibility_bytes),
                     row.instructions ? fmt::format("{:.3f} M", static_cast<double>(*row.instructions) / 1e6) : "-",
                     fmt::format("{:.2f} ms", row.nanoseconds / 1e6));
}

}  // namespace

std::string visibility_text(std::string_view table, std::span<const VisibilityRow> rows) {
  std::string text =
      fmt::format(fmt::runtime(kLine), "scene", "size", "method", "N", "depth", "comparisons", "cells read", "writes",
                  "overdraw", "splits", "wrong", "z-buffer", "method's", "instructions", "time");
  for (const VisibilityRow& row : rows) text += line(row);
  text +=
      "comparisons: of a depth with a cell, a tile's bound or a node's. cells read: besides, to find bounds again.\n";
  text += "overdraw: writes for each pixel that was written. wrong: pixels, by a judge in double precision.\n";
  text += "z-buffer and the method's own memory are in bytes; the picture is one strip.\n";
  if (table == "midpoint") {
    text +=
        "The report, one scene of its own at 800x600, 2 splits: hierarchical z 20,216 comparisons and 57 ms, midpoint "
        "12,635 and 51 ms.\n";
  } else if (table == "thesis") {
    text +=
        "The thesis, 24-bit colour and depth: 1.6 MB at 640x480, 12 MB at 1920x1080; it ranks the combination as "
        "right, "
        "with less overdraw and slower than the z-buffer, because the sort must finish first.\n";
  } else {
    text += "wrong: pixels of pairs of layers that the format cannot tell apart, without any tolerance of depth.\n";
  }
  return text;
}

std::string visibility_json(std::string_view table, std::span<const VisibilityRow> rows) {
  Json list = Json::array();
  for (const VisibilityRow& row : rows) {
    const VisibilityRowCase& c = row.row_case;
    Json object{
        {"table", table},
        {"scene", c.scene},
        {"view", {{"width", c.view.width}, {"height", c.view.height}}},
        {"method", c.method},
        {"iterations", nullptr},
        {"depth_format", has_depth(row) ? Json(name(c.depth_format)) : Json(nullptr)},
        {"comparisons", row.comparisons},
        {"cells_read", row.cells_read},
        {"fragments", row.fragments},
        {"writes", row.writes},
        {"written_pixels", row.written},
        {"splits", row.splits},
        {"wrong_pixels", row.wrong},
        {"bytes",
         {{"depth", row.plan.depth_bytes}, {"visibility", row.plan.visibility_bytes}, {"arena", row.plan.bytes()}}},
        {"instructions_per_frame", nullptr},
        {"ns_per_frame", row.nanoseconds}};
    if (has_iterations(row)) object["iterations"] = c.iterations;
    if (row.instructions) object["instructions_per_frame"] = *row.instructions;
    list.push_back(std::move(object));
  }
  return list.dump(2) + "\n";
}

}  // namespace zstrip::sim
