// Model files as Assimp is given them: texts in UTF-8, and without what its readers take wrongly.
#pragma once

#include <assimp/DefaultIOSystem.h>

#include <string>
#include <string_view>
#include <vector>

namespace zstrip::sim {

/// Text in UTF-16 with a byte order mark, as UTF-8; what is no character becomes U+FFFD. Any other text as it is.
std::string as_utf8(std::string_view text);

/// Files with a byte order mark of UTF-16 are read by as_utf8: Assimp's readers take it for UTF-8, or take the lower
/// byte alone. Of RAW, names of groups are left out: of several groups its reader keeps one, and pointers to nothing.
class ModelFiles : public Assimp::DefaultIOSystem {
 public:
  /// `not_opened`: is added to.
  explicit ModelFiles(std::vector<std::string>& not_opened) : not_opened_(not_opened) {}
  using Assimp::DefaultIOSystem::Open;
  Assimp::IOStream* Open(const char* file, const char* mode) override;

 private:
  std::vector<std::string>& not_opened_;
};

}  // namespace zstrip::sim
