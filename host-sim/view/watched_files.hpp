// Notices that a scene was saved again.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace zstrip::sim {

/// The scene's file and those beside it or in folders below that it names, and that those name, as a glTF file does its
/// buffers and an OBJ file its materials and those their textures: all whose name stands in the bytes of a watched one.
/// A built-in scene has none. To be made before the scene is read: what is saved meanwhile has changed.
class WatchedFiles {
 public:
  explicit WatchedFiles(const std::string& scene);
  /// Whether one of them has changed since the last call, or since this was made. A file that is being replaced, and so
  /// is not there, has not changed yet.
  bool changed();

 private:
  std::map<std::filesystem::path, std::filesystem::file_time_type> times_;
};

}  // namespace zstrip::sim
