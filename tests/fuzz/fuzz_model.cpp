// PLY, STL and 3MF files, and texts of OBJ and MTL: any bytes become a model whose numbers are in range, or a failure.
// The first byte chooses the reader.
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "import/3mf/read_3mf.hpp"
#include "import/assimp/obj_text.hpp"
#include "import/foreign_file.hpp"
#include "import/ply/read_ply.hpp"
#include "import/stl/read_stl.hpp"
#include "require.hpp"

namespace {

using namespace zstrip::sim;

void judge(const Result<SourceModel>& read) {
  if (!read) {
    fuzz::require(read.failure().status == ExitStatus::input, "a damaged file is the input's fault");
    fuzz::require(read.failure().message.find('\n') == std::string::npos, "a failure is one line: %s",
                  read.failure().message.c_str());
    return;
  }
  const SourceModel& model = *read;
  fuzz::require(!model.meshes.empty() || !model.lines.empty(), "a model has a mesh, or lines");
  const auto has_places = [&](const auto& part) {
    fuzz::require(part.material < model.materials.size() && !part.indices.empty(), "materials exist");
    for (const std::uint32_t index : part.indices) {
      fuzz::require(index < part.vertices.size(), "vertices exist");
      for (const float c : part.vertices[index].position) fuzz::require(std::isfinite(c), "corners are finite");
      for (const float c : part.vertices[index].texcoord) fuzz::require(std::isfinite(c), "coordinates are finite");
    }
  };
  for (const SourceMesh& mesh : model.meshes) has_places(mesh);
  for (const SourceLines& lines : model.lines) has_places(lines);
  fuzz::require(model.textures.size() == model.texture_names.size(), "textures have names");
}

/// A text that is plain stays as it is.
void judge_texts(std::string_view text) {
  const auto no_file = [](std::string_view) { return false; };
  ObjMaterials materials;
  std::array<double, 3> origin{}, none{};
  const std::string plain = plain_obj(text, no_file, materials.used, origin);
  fuzz::require(plain_obj(plain, no_file, materials.used, none) == plain, "a plain OBJ is as it was");
  std::vector<std::string> warnings;
  const std::string mtl = plain_mtl(text, false, warnings, materials);
  for (const std::string& warning : warnings) {
    fuzz::require(warning.find('\n') == std::string::npos, "a warning is one line: %s", warning.c_str());
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view file(reinterpret_cast<const char*>(data) + 1, size - 1);
  const ReadPicture no_picture = [](const std::string&) -> Result<RgbImage> {
    return Failure{ExitStatus::input, "does not exist"};
  };
  switch (data[0] % 4) {
    case 0: judge(read_ply(file, no_picture, {}, Texcoords::all)); break;
    case 1: judge(read_stl(file, {})); break;
    case 2: judge(read_3mf(file, {}, Texcoords::all)); break;
    default: judge_texts(file);
  }
  const auto kind = foreign_kind(file.substr(0, kBytesOfKind), ".fbx");
  fuzz::require(!kind || kind->find('\n') == std::string::npos, "a kind is one line");
  return 0;
}
