// Model files as Assimp is given them: texts in UTF-8, and without what its readers take wrongly.
#pragma once

#include <assimp/DefaultIOSystem.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace zstrip::sim {

/// Text in UTF-8 without a byte order mark: what has one of UTF-16 is converted, and what is no character becomes
/// U+FFFD.
std::string as_utf8(std::string_view text);

/// What is known of a model's files once Assimp has read them.
struct FilesRead {
  std::vector<std::string> not_opened;
  std::vector<std::string> warnings;
};

/// Texts are read by as_utf8: Assimp's readers take a byte order mark for the first word of a line. OBJ, its
/// materials and STL are read by plain_obj, plain_mtl and plain_stl. Of RAW, names of groups are left out: of several
/// groups its reader keeps one, and pointers to nothing.
class ModelFiles : public Assimp::DefaultIOSystem {
 public:
  /// `read`: is added to.
  ModelFiles(std::filesystem::path model, FilesRead& read) : model_(std::move(model)), read_(read) {}
  using Assimp::DefaultIOSystem::Open;
  Assimp::IOStream* Open(const char* file, const char* mode) override;

 private:
  /// A file that the model names, as find_file finds it.
  std::string place_of(const char* file) const;
  /// `text` as Assimp reads it right.
  std::string plain(const std::string& file, std::string text);

  std::filesystem::path model_;
  FilesRead& read_;
  bool of_blender_ = false;  ///< the model, an OBJ
};

}  // namespace zstrip::sim
