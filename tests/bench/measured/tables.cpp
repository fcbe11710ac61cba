// One function a file that is read, then the list of tables.
#include "bench/measured/tables.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace zstrip::measured {
namespace {

using nlohmann::ordered_json;
namespace fs = std::filesystem;

ordered_json read_json(const fs::path& file) {
  std::ifstream stream(file);
  if (!stream) throw std::runtime_error("cannot read " + file.string());
  return ordered_json::parse(stream);
}

/// Rows by their first words, in the order in which these come; a cell that nothing is put into is empty.
class Pivot {
 public:
  Pivot(std::size_t words, std::vector<std::string> columns) : words_(words), columns_(std::move(columns)) {}

  void put(const Row& words, const std::string& column, const std::string& value) {
    auto row =
        std::ranges::find_if(rows_, [&](const Row& r) { return std::equal(words.begin(), words.end(), r.begin()); });
    if (row == rows_.end()) {
      rows_.push_back(words);
      rows_.back().resize(words_ + columns_.size());
      row = rows_.end() - 1;
    }
    const auto at = std::ranges::find(columns_, column) - columns_.begin();
    row->at(words_ + static_cast<std::size_t>(at)) = value;
  }
  std::vector<Row> rows() const { return rows_; }

 private:
  std::size_t words_;
  std::vector<std::string> columns_;
  std::vector<Row> rows_;
};

std::string decimal(double value, int decimals) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return text;
}

/// A number as it is, null as nothing, a string without its quotes.
std::string text_of(const ordered_json& value) {
  if (value.is_null()) return "";
  return value.is_string() ? value.get<std::string>() : value.dump();
}

std::vector<Row> stages(const fs::path& fresh) {
  Pivot pivot(2, {"m3", "m4f", "m0"});
  for (const ordered_json& profile : read_json(fresh / "stages.json")) {
    const std::string workload = profile.at("workload"), target = profile.at("target");
    pivot.put({workload, "all"}, target, text_of(profile.at("instructions_per_frame")));
    for (const auto& [stage, instructions] : profile.at("stages").items())
      pivot.put({workload, stage}, target, text_of(instructions));
  }
  return pivot.rows();
}

std::vector<Row> peers(const fs::path& fresh) {
  Pivot pivot(1, {"K5", "CT", "R50", "R10k"});
  for (const char* file : {"peers.json", "peers_random.json"}) {
    for (const ordered_json& row : read_json(fresh / file))
      pivot.put({row.at("renderer")}, row.at("workload"), text_of(row.at("instructions_per_frame")));
  }
  return pivot.rows();
}

std::vector<Row> boards(const fs::path& fresh) {
  std::vector<Row> rows;
  const auto add = [&rows](const ordered_json& of, const std::string& how) {
    const auto megacycles = [&](const char* name, std::size_t i) {
      return decimal(of.at(name).at(i).get<double>() / 1e6, 3);
    };
    rows.push_back({of.at("workload"), of.at("board").get<std::string>() + how, text_of(of.at("config").at("strips")),
                    text_of(of.at("ram_bytes")), megacycles("core_cycles_per_frame", 0),
                    megacycles("core_cycles_per_frame", 1), decimal(of.at("frames_per_second").at(0), 2),
                    decimal(of.at("frames_per_second").at(1), 2)});
  };
  const std::pair<const char*, const char*> files[] = {{"boards.json", ""},
                                                       {"boards_two_cores.json", " (2 cores)"},
                                                       {"boards_40_rows.json", " at 40 rows"},
                                                       {"boards_two_cores_40_rows.json", " at 40 rows (2 cores)"}};
  for (const auto& [file, how] : files) {
    for (const ordered_json& of : read_json(fresh / file)) add(of, how);
  }
  return rows;
}

/// Of each format of depth.
std::vector<Row> depth(const fs::path& fresh) {
  Pivot pivot(1, {"m3", "m0"});
  for (const char* format : {"z16", "float", "z24", "state", "ranges"}) {
    for (const ordered_json& of : read_json(fresh / (std::string("depth_") + format + ".json")))
      pivot.put({format}, of.at("target"), text_of(of.at("instructions_per_frame")));
  }
  return pivot.rows();
}

/// Lines of CSV as they are.
std::vector<Row> ratios(const fs::path& fresh) {
  std::vector<Row> rows;
  std::ifstream lines(fresh / "ratios.csv");
  for (std::string line; std::getline(lines, line);) {
    Row row;
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) row.push_back(cell);
    rows.push_back(row);
  }
  if (rows.empty()) throw std::runtime_error("no ratios of the store were measured");
  return rows;
}

std::vector<Row> store(const fs::path& fresh) {
  Pivot pivot(2, {"bytes", "decode_m0", "decode_m3", "encode_m0", "encode_m3"});
  for (const char* target : {"m0", "m3"}) {
    std::ifstream lines(fresh / (std::string("store_") + target + ".jsonl"));
    for (std::string line; std::getline(lines, line);) {
      const ordered_json record = ordered_json::parse(line);
      const Row words{record.at("kind"), record.at("scene")};
      pivot.put(words, "bytes", decimal(record.at("bytes").get<double>() / record.at("tiles").get<double>(), 1));
      for (const char* what : {"decode", "encode"})
        pivot.put(words, std::string(what) + "_" + target,
                  decimal(record.at(std::string(what) + "_per_100_cells").get<double>() / 100, 1));
    }
  }
  std::vector<Row> rows = pivot.rows();
  std::ranges::sort(rows, {}, [](const Row& row) { return std::pair(row[0], row[1]); });
  if (rows.empty()) throw std::runtime_error("nothing of the store was measured");
  return rows;
}

/// Of one of the tables that `zstrip bench --table` prints on this machine.
std::function<std::vector<Row>(const fs::path&)> visibility(const std::string& table) {
  return [table](const fs::path& fresh) {
    std::vector<Row> rows;
    for (const ordered_json& of : read_json(fresh / (table + ".json"))) {
      const ordered_json& view = of.at("view");
      rows.push_back({of.at("scene"), text_of(view.at("width")) + "x" + text_of(view.at("height")), of.at("method"),
                      text_of(of.at("iterations")), text_of(of.at("depth_format")), text_of(of.at("comparisons")),
                      text_of(of.at("cells_read")), text_of(of.at("writes")),
                      decimal(of.at("writes").get<double>() / of.at("written_pixels").get<double>(), 2),
                      text_of(of.at("wrong_pixels")), text_of(of.at("bytes").at("depth")),
                      text_of(of.at("bytes").at("visibility")), text_of(of.at("instructions_per_frame"))});
    }
    return rows;
  };
}

std::vector<Row> board_visibility(const fs::path& fresh) {
  Pivot pivot(2, {"m0", "m3", "ram_bytes"});
  for (const ordered_json& of : read_json(fresh / "boards.json")) {
    const Row words{of.at("scene"), of.at("method")};
    pivot.put(words, of.at("target"), text_of(of.at("instructions_per_frame")));
    pivot.put(words, "ram_bytes", text_of(of.at("ram_bytes")));
  }
  return pivot.rows();
}

// A stage is told by how often a block of instructions runs: some hundreds may move to its neighbour.
constexpr Tolerance kStage{.share = 0.01, .at_least = 500};
constexpr Tolerance kModel{.share = 0.01, .at_least = 0.01};
constexpr Tolerance kRatio{.share = 0.001, .at_least = 0.005};
constexpr Tolerance kCell{.share = 0.01, .at_least = 0.1};

std::vector<BenchTable> performance_tables() {
  return {
      {"stages",
       "Stages",
       "Instructions of a frame, 320x240, the mean of frames 0 to 5, by stage; `library` are calls of libgcc.\n"
       "A stage that is empty is counted with another: assembly does several at once.",
       {.part = "performance", .columns = {{"workload"}, {"stage"}, {"m3", kStage}, {"m4f", kStage}, {"m0", kStage}}},
       stages},
      {"peers",
       "Other renderers",
       "Instructions of a frame on x86-64. K5 and CT at 320x240, frames 0 to 5; R50 and R10k at 640x480, frames 0 and "
       "1.",
       {.part = "performance",
        .columns = {{"renderer"},
                    {"K5", kInstructions},
                    {"CT", kInstructions},
                    {"R50", kInstructions},
                    {"R10k", kInstructions}}},
       peers},
      {"boards",
       "Boards",
       "Predicted: 320x240 in RGB565, the mean of frames 0 to 5. Millions of cycles of the core a frame, and frames a\n"
       "second, each least and most. Strips are as high as the planner chooses, or 40 rows.",
       {.part = "performance",
        .columns = {{"workload"},
                    {"board"},
                    {"strips", kExact},
                    {"ram_bytes", kExact},
                    {"least_cycles", kModel},
                    {"most_cycles", kModel},
                    {"least_fps", kModel},
                    {"most_fps", kModel}}},
       boards},
      {"depth",
       "Formats of depth",
       "Instructions of a frame of R50, 320x240, the mean of frames 0 to 19, with each format and with depth states "
       "of\n"
       "materials (`state`) and sub-ranges (`ranges`).",
       {.part = "performance", .columns = {{"depth"}, {"m3", kInstructions}, {"m0", kInstructions}}},
       depth},
      {"ratios",
       "Ratios of the depth and colour stores",
       "16 bits a cell of the smallest rectangle that holds the picture, by the bytes of the pool with its index: six\n"
       "frames of 320x240, their mean and the worst. Frames 0, 10, ... 50 of the workloads; of the room its turntable.",
       {.part = "performance", .columns = {{"content"}, {"scene"}, {"mean", kRatio}, {"worst", kRatio}}},
       ratios},
      {"store",
       "Records of the depth and colour stores",
       "Bytes of a tile of 64 cells, instructions a cell.",
       {.part = "performance",
        .columns = {{"record"},
                    {"scene"},
                    {"bytes", kCell},
                    {"decode_m0", kCell},
                    {"decode_m3", kCell},
                    {"encode_m0", kCell},
                    {"encode_m3", kCell}}},
       store},
  };
}

std::vector<BenchTable> visibility_tables() {
  const Table host{.part = "visibility",
                   .columns = {{"scene"},
                               {"size"},
                               {"method"},
                               {"iterations"},
                               {"depth"},
                               {"comparisons", kExact},
                               {"cells_read", kExact},
                               {"writes", kExact},
                               {"overdraw", kExact},
                               {"wrong", kExact},
                               {"depth_bytes", kExact},
                               {"method_bytes", kExact},
                               {"instructions", kInstructions}}};
  return {
      {"midpoint", "Hierarchical z and midpoint subdivision",
       "Frame 7 of three workloads. Instructions of a frame on x86-64.", host, visibility("midpoint")},
      {"thesis", "Painter, z-buffer and their combination", "The same frame; `front-to-back` is the combination.", host,
       visibility("thesis")},
      {"depth-bits", "What each format of depth tells apart",
       "48 pairs of squares that face the camera; wrong allows no tolerance of depth.", host, visibility("depth-bits")},
      {"boards",
       "On small processors",
       "Instructions of a frame on emulated cores, 320x240 in strips of 16 rows, streamed, the mean of the first four\n"
       "frames; RAM is the arena and one strip of pixels.",
       {.part = "visibility",
        .columns = {{"scene"}, {"method"}, {"m0", kInstructions}, {"m3", kInstructions}, {"ram_bytes", kExact}}},
       board_visibility},
  };
}

}  // namespace

std::vector<BenchTable> tables_of(const std::string& part) {
  if (part == "performance") return performance_tables();
  if (part == "visibility") return visibility_tables();
  return {};
}

}  // namespace zstrip::measured
