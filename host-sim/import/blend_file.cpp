// Exports a .blend file to glTF 2.0 in a folder of its own.
#include "import/blend_file.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

#include "bench/child_process.hpp"
#include "import/read_file.hpp"

namespace zstrip::sim {
namespace {

/// After a file that it cannot open, blender goes on with its own cube. Options that a release does not have are left
/// out. Applying modifiers would lose shape keys.
constexpr const char* kExport =
    "import bpy, sys\n"
    "if not bpy.data.filepath:\n"
    "    sys.exit(2)\n"
    "run = bpy.ops.export_scene.gltf\n"
    "words = dict(filepath=sys.argv[-1], check_existing=False, export_format='GLB', export_cameras=True,\n"
    "             export_lights=True, use_active_scene=True, use_renderable=True,\n"
    "             export_apply=not any(mesh.shape_keys for mesh in bpy.data.meshes))\n"
    "known = run.get_rna_type().properties.keys()\n"
    "run(**{key: value for key, value in words.items() if key in known})\n";

/// A folder that is removed with what it has.
class OwnFolder {
 public:
  OwnFolder() {
    std::error_code error;
    std::string name = (std::filesystem::temp_directory_path(error) / "zstrip-XXXXXX").string();
    if (!error && ::mkdtemp(name.data()) != nullptr) path_ = name;
  }
  ~OwnFolder() {
    std::error_code ignored;
    if (!path_.empty()) std::filesystem::remove_all(path_, ignored);
  }
  OwnFolder(const OwnFolder&) = delete;
  OwnFolder& operator=(const OwnFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

ExportedBlend run_blender(const std::filesystem::path& whole, std::chrono::seconds limit) {
  const OwnFolder folder;
  if (folder.path().empty()) return {{}, "there is no folder for temporary files"};
  const std::filesystem::path output = folder.path() / "scene.glb";
  if (!run_program({"blender", "--version"}, limit)) return {};
  // If the time is up, the program cannot remove its own temporary files.
  const Result<ChildOutput> done = run_program(
      {"env", "TMPDIR=" + folder.path().string(), "blender", "--background", "--factory-startup", "--disable-autoexec",
       "--python-exit-code", "1", whole.string(), "--python-expr", kExport, "--", output.string()},
      limit);
  if (!done) return {{}, fmt::format("it did not end within {} s", limit.count())};
  const auto says = [&](const char* words) { return done->text.find(words) != std::string::npos; };
  if (says("No module named 'numpy'")) return {{}, "its exporter needs numpy, in Debian the package python3-numpy"};
  if (says("Failed to read blend file") || says("File format is not supported")) {
    return {{}, "it cannot read the file, which is damaged or of a newer release"};
  }
  Result<std::vector<std::uint8_t>> glb = read_file(output);
  if (done->exit_status != 0 || !glb) return {{}, fmt::format("it ended with status {}", done->exit_status)};
  ExportedBlend exported{std::move(*glb)};
  if (says("newer Blender binary")) {
    exported.warnings.emplace_back("written by a newer Blender than the installed one, which may lose parts of it");
  }
  return exported;
}

}  // namespace

ExportedBlend export_blend(const std::filesystem::path& path, std::chrono::seconds limit) {
  struct Last {
    std::filesystem::path path;
    std::filesystem::file_time_type written;
    ExportedBlend exported;
  };
  // Blender takes seconds, and zstrip fit reads a model up to fifty times.
  static std::optional<Last> last;
  std::error_code error;
  const std::filesystem::path whole = std::filesystem::absolute(path, error);
  const std::filesystem::file_time_type written = std::filesystem::last_write_time(path, error);
  if (error) return {{}, error.message()};
  const bool is_known = last && last->path == whole && last->written == written && !last->exported.glb.empty();
  if (!is_known) last = {whole, written, run_blender(whole, limit)};
  return last->exported;
}

}  // namespace zstrip::sim
