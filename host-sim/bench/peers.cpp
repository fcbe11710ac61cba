// Measured instructions of other renderers, in millions a frame.
#include "bench/peers.hpp"

#include <array>
#include <cstddef>

namespace zstrip::sim {
namespace {

struct Column {
  std::string_view target, workload;
  std::uint16_t width, height;
};

constexpr std::size_t kColumns = 6;
using Columns = std::array<Column, kColumns>;

struct Row {
  std::string_view peer;
  std::array<double, kColumns> million_instructions;
};

constexpr Columns kBoardColumns{{{"m0", "K5", 320, 240},
                                 {"m0", "CT", 320, 240},
                                 {"m3", "K5", 320, 240},
                                 {"m3", "CT", 320, 240},
                                 {"m4f", "K5", 320, 240},
                                 {"m4f", "CT", 320, 240}}};
constexpr std::array kBoardRows{
    Row{"small3dlib", {13.23, 8.73, 5.47, 5.07, 5.47, 5.06}},  // integers, no sub-pixels, affine textures
    Row{"Pico3D", {11.36, 22.5, 3.73, 6.49, 3.84, 6.56}},      // integers, no sub-pixels, affine textures, 10-bit depth
    Row{"tgx", {67.3, 76.7, 31.0, 39.7, 3.30, 2.91}},         Row{"TinyGL", {95.3, 21.7, 42.3, 10.5, 7.77, 3.97}},
    Row{"pingo", {175, 279, 75.2, 102, 7.42, 14.0}},          Row{"PortableGL", {240, 1054, 110.5, 505, 10.7, 51.2}},
};

constexpr Columns kHostColumns{{{"host", "K5", 320, 240},
                                {"host", "CT", 320, 240},
                                {"host", "R50", 640, 480},
                                {"host", "R10k", 640, 480},
                                {"host", "R50", 1920, 1080},
                                {"host", "R10k", 1920, 1080}}};
constexpr std::array kHostRows{
    Row{"small3dlib", {5.49, 5.12, 4.38, 16.3, 22.4, 37.7}},
    Row{"TinyGL", {5.87, 4.27, 1.82, 13.8, 9.1, 23.4}},
    Row{"tgx", {3.64, 2.62, 2.09, 15.0, 11.0, 25.7}},
    Row{"Allegro 4", {5.81, 2.13, 1.75, 18.9, 8.1, 31.2}},
    Row{"PortableGL", {8.98, 37.1, 27.5, 35.3, 142, 128}},
    Row{"OSMesa llvmpipe", {6.41, 3.31, 4.13, 27.6, 18.4, 60.2}},
};

template <std::size_t row_count>
Peer best_of(const Columns& columns, const std::array<Row, row_count>& rows, const BenchCase& bench_case) {
  Peer best{};
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const Column& column = columns[i];
    if (column.target != bench_case.target || column.workload != bench_case.workload ||
        column.width != bench_case.view.width || column.height != bench_case.view.height) {
      continue;
    }
    for (const Row& row : rows) {
      if (best.name.empty() || row.million_instructions[i] < best.million_instructions) {
        best = {row.peer, row.million_instructions[i]};
      }
    }
  }
  return best;
}

}  // namespace

Peer best_peer(const BenchCase& bench_case) {
  if (bench_case.frames != kPeerFrames) return {};
  const Peer on_board = best_of(kBoardColumns, kBoardRows, bench_case);
  return on_board.name.empty() ? best_of(kHostColumns, kHostRows, bench_case) : on_board;
}

}  // namespace zstrip::sim
