// The parts that a page does without: meshes that Draco has compressed and the workload R10k, which are refused,
// JPEG files, JSON and whole folders as output, Blender, threads, and signals: a trap ends the module, and the page
// says so.
#include "play/left_out.hpp"
#include "bake/project_files.hpp"
#include "image/jpeg_writer.hpp"
#include "import/blend_file.hpp"
#include "import/crash_guard.hpp"
#include "import/gltf/draco_meshes.hpp"
#include "render/parallel.hpp"
#include "report/bake_report.hpp"
#include "report/frame_record.hpp"
#include "zstrip_scenes/random.hpp"

namespace zstrip::scenes {

// The scene has 370 KB of random numbers, which cannot be compressed.
const TriangleSoup<10000> kRandom10k{};
const std::array<Meshlet, kRandom10kMeshlets> kRandom10kMeshletTable{};

}  // namespace zstrip::scenes

namespace zstrip::sim {

std::optional<Failure> left_out(std::string_view word) {
  if (word.starts_with("--json")) return Failure{ExitStatus::usage, "a page writes no JSON; the command does"};
  if (!word.starts_with("random10k")) return std::nullopt;
  return Failure{ExitStatus::usage,
                 "the scenes random10k, for measuring, are too large for a page; the command has them"};
}

Result<DracoMesh> decode_draco(const GltfJson&, std::span<const std::uint8_t>) {
  return Failure{ExitStatus::input, "the page does not read meshes that Draco has compressed; the command does"};
}

Result<std::vector<std::uint8_t>> write_jpeg(std::span<const std::uint8_t>, int, int) {
  return Failure{ExitStatus::usage, "a page writes no JPEG, but PNG; the command does"};
}

// Both are written only with --json, which left_out() refuses.
std::string bake_json(const BakeRecord&) { return {}; }
std::string to_json(const RunRecord&) { return {}; }

Result<Done> check_project_name(const std::string&) {
  return Failure{ExitStatus::usage, "a page writes no whole folder, but a sketch and its header; the command does"};
}
Result<Done> check_for_project(const BakedScene&, const std::string&, const Project&) { return Done{}; }
std::vector<ProjectFile> project_files(const BakedScene&, const std::string&, const Project&) { return {}; }
// Only whole folders ask for these rows.
std::uint16_t rgb_strip_rows(std::uint16_t, std::uint16_t) { return 0; }

ExportedBlend export_blend(const std::filesystem::path&, std::chrono::seconds) { return {}; }

CrashGuard::CrashGuard(const std::string&, const std::string&, std::chrono::seconds, std::uint64_t) {}
CrashGuard::~CrashGuard() = default;
void CrashGuard::lift_limits() {}
bool machine_gives(std::uint64_t) { return false; }

Result<Done> for_each_on_threads(std::uint32_t count, unsigned,
                                 const std::function<Result<Done>(unsigned thread, std::uint32_t index)>& work) {
  for (std::uint32_t index = 0; index < count; ++index) {
    if (const Result<Done> done = work(0, index); !done) return done.failure();
  }
  return Done{};
}

}  // namespace zstrip::sim
