// The files of a model as Assimp gets them: text in UTF-8, without input that its readers misread.
#pragma once

#include <assimp/DefaultIOSystem.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "import/assimp/obj_text.hpp"
#include "motion/affine.hpp"

namespace zstrip::sim {

/// Returns text in UTF-8 without a byte order mark: text with a mark of UTF-16 is converted, and invalid characters
/// become U+FFFD.
std::string as_utf8(std::string_view text);

/// Facts about a model's files that are known after Assimp has read them.
struct FilesRead {
  std::vector<std::string> not_opened;
  std::vector<std::string> warnings;
  ObjMaterials materials;
  std::size_t curves_and_solids = 0;  ///< of a DXF file, which Assimp leaves out
  Vector origin{};                    ///< that plain_obj subtracted from the positions
};

/// Text is converted by as_utf8, because Assimp's readers take a byte order mark for the first word of a line. OBJ and
/// its materials are converted by plain_obj and plain_mtl. In OFF each vertex and face gets a line of its own. Names of
/// groups in RAW are removed: with several groups the reader keeps only one, and dangling pointers.
/// The elements of DXF that Assimp leaves out are counted.
class ModelFiles : public Assimp::DefaultIOSystem {
 public:
  /// Results are added to `read`.
  ModelFiles(std::filesystem::path model, FilesRead& read) : model_(std::move(model)), read_(read) {}
  using Assimp::DefaultIOSystem::Open;
  Assimp::IOStream* Open(const char* file, const char* mode) override;

 private:
  /// Returns the path of a file that the model names, as find_file finds it.
  std::string place_of(const char* file) const;
  /// Returns `text` in a form that Assimp reads correctly.
  std::string plain(const std::string& file, std::string text);

  std::filesystem::path model_;
  FilesRead& read_;
  bool of_blender_ = false;  ///< the model is an OBJ written by Blender
};

}  // namespace zstrip::sim
