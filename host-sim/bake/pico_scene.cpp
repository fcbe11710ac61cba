// Puts the scene where firmware/boards/pico/show_baked.cpp looks for it, and knows the memory of that program.
#include "bake/pico_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "bake/blob_characters.hpp"
#include "bake/flash_bytes.hpp"
#include "bake/uf2_file.hpp"
#include "image/to_rgb.hpp"
#include "import/read_file.hpp"
#include "report/frame_record.hpp"
#include "zstrip/blob.hpp"
#include "zstrip/budget.hpp"
#include "zstrip_scenes/baked_stage.hpp"

namespace zstrip::sim {
namespace {

constexpr std::string_view kReads = pico::kReads;
static_assert(kReads.find(static_cast<char>('0' + kSceneBlobVersion)) != std::string_view::npos);

bool has_words(const pico::Pages& program, std::string_view words) {
  std::vector<std::uint8_t> bytes;
  for (const auto& [address, page] : program) bytes.insert(bytes.end(), page.begin(), page.end());
  return std::search(bytes.begin(), bytes.end(), words.begin(), words.end()) != bytes.end();
}

}  // namespace

Result<pico::Pages> read_pico_program(const std::string& path, const pico::Board& board) {
  const auto failed = [&path](const Failure& failure) {
    return Failure{failure.status, fmt::format("--with '{}' {}", path, failure.message)};
  };
  const Result<std::vector<std::uint8_t>> file = read_file(path, std::size_t{16} << 20);
  if (!file) return failed(file.failure());
  Result<pico::Pages> program = read_uf2(*file, board);
  if (!program) return failed(program.failure());
  if (program->lower_bound(pico::kScene) != program->end()) {
    return failed({ExitStatus::input,
                   fmt::format("fills the flash from {:08x} on, where the scene goes; take the program without a scene",
                               pico::kScene)});
  }
  if (!program->contains(pico::kFlash) || !has_words(*program, kReads)) {
    return failed({ExitStatus::input, fmt::format("is not the program that shows a {}; take {}.uf2 of the same release "
                                                  "as this command",
                                                  kReads, board.player)});
  }
  return program;
}

const pico::Board& board_of(const pico::Pages& program, const pico::Board& board) {
  for (const pico::Board* const other : pico::kBoards) {
    if (other->family == board.family && has_words(program, other->no_scene)) return *other;
  }
  return board;
}

Result<std::vector<std::uint8_t>> to_pico_file(std::span<const std::uint8_t> blob, const pico::Pages& program,
                                               const pico::Board& board) {
  if (blob.size() > board.scene_bytes()) {
    return Failure{ExitStatus::budget,
                   fmt::format("takes {} bytes, and the {}'s flash has {} for a scene; take fewer triangles or "
                               "smaller textures, or --textures palette8",
                               blob.size(), board.called, board.scene_bytes())};
  }
  pico::Pages pages = program;
  for (std::size_t at = 0; at < blob.size(); at += pico::kPage) {
    pico::Page& page = pages[pico::kScene + static_cast<std::uint32_t>(at)];
    page.fill(0xFF);
    std::ranges::copy(blob.subspan(at, std::min<std::size_t>(pico::kPage, blob.size() - at)), page.begin());
  }
  return pico::to_uf2(pages, board);
}

std::uint64_t kept_on_pico(const Scene& scene, const Animation& animation, const Turn& turn,
                           const BlobCharacters* characters) {
  // The sum is that of zstrip::Player; each piece begins at a multiple of kArenaAlignment.
  constexpr std::uint64_t kPieces = 8, kLineSet = 64;  // a LineSet has a pointer: 64 bytes on the board
  std::uint64_t kept = table_bytes(scene) + kPieces * kArenaAlignment;
  bool moves = !animation.tracks.empty();
  if (characters != nullptr) {
    kept += characters->table_bytes() + characters->ram().total();
    moves = std::ranges::any_of(characters->clips(), [](const Clip& clip) { return !clip.instances.tracks.empty(); });
  }
  if (moves || turn.what == Turning::instances || turn.what == Turning::instances_and_lines) {
    kept += scene.instances.size() * sizeof(Instance);
  }
  if (scenes::turns_lines(animation, turn)) kept += scene.lines.size() * kLineSet;
  return kept;
}

Result<Done> check_view_for_pico(const View& view) {
  if (view.width != pico::kPanelSide || view.height != pico::kPanelSide) {
    return Failure{
        ExitStatus::usage,
        fmt::format("--size {}x{}: the program for the Pico shows pictures of {}x{} pixels; leave the option "
                    "out, or bake a header (-o scene.hpp) for a program of your own",
                    view.width, view.height, pico::kPanelSide, pico::kPanelSide)};
  }
  if (view.format == PixelFormat::rgb565_swapped || view.format == PixelFormat::rgb565) return Done{};
  return Failure{ExitStatus::usage,
                 fmt::format("--format {}: the program for the Pico draws rgb565_swapped; leave the option out",
                             name(view.format))};
}

Result<Done> check_for_pico(Effects effects) {
  const bool has_runs =
      effects.any(effect::perspective_runs) && effects.has(effect::textures) && !effects.has(effect::orthographic);
  if (!has_runs && !effects.any(effect::depth_formats)) return Done{};
  return Failure{ExitStatus::usage, fmt::format("the program for the Pico draws {}; leave '{}' out of the scene file",
                                                has_runs ? "textures with the usual accuracy" : "with depth as z16",
                                                has_runs ? "perspective" : "depth_format")};
}

}  // namespace zstrip::sim
