// Detects that a file of the scene was saved again.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace zstrip::sim {

/// Watches the scene's file, and files in its folder and the folders below that a watched file names: all files whose
/// name is in the bytes of a watched file, such as buffers of a glTF file, materials of an OBJ file, and their
/// textures. A built-in scene has no files. Create it before the scene is read, so that a file saved in between counts
/// as changed.
class WatchedFiles {
 public:
  explicit WatchedFiles(const std::string& scene);
  /// True if a file has changed since the last call, or since the object was created. A file that is missing because it
  /// is being replaced does not count as changed yet.
  bool changed();

 private:
  std::map<std::filesystem::path, std::filesystem::file_time_type> times_;
};

}  // namespace zstrip::sim
