// Files that are no models are named as what they are.
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "import/blend_file.hpp"
#include "import/foreign_file.hpp"
#include "import_fixture.hpp"

namespace zstrip::sim::test {
namespace {

/// Replaces PATH while it lives.
class OtherPath {
 public:
  explicit OtherPath(const std::string& path) { ::setenv("PATH", path.c_str(), 1); }
  ~OtherPath() { ::setenv("PATH", before_.c_str(), 1); }
  OtherPath(const OtherPath&) = delete;
  OtherPath& operator=(const OtherPath&) = delete;

 private:
  std::string before_ = ::getenv("PATH");
};

TEST_F(Import, FilesThatAreNoModelsAreNamedAsWhatTheyAre) {
  const std::string zeros(64, '\0');
  const std::string fbx = std::string("Kaydara FBX Binary  \0\x1A\0", 23) + std::string("\xD4\x17\0\0", 4) + zeros;
  const struct {
    std::string name, content, words;
  } cases[] = {
      {"a.glb", "<!DOCTYPE html>\n<html><body>SECRET</body></html>", "is a web page"},
      {"a.obj", "\n <html lang='en'>SECRET", "is a web page"},
      {"a.stl", "<?xml version='1.0'?><!DOCTYPE HTML PUBLIC 'x'><html>", "is a web page"},
      {"a.gltf", "PK\3\4" + zeros, "is a zip archive; unpack it first"},
      {"a.glb", "\x1F\x8B\x08" + zeros, "is packed by gzip; unpack it first"},
      {"a.blend", "\x28\xB5\x2F\xFD" + zeros, "which only the program blender reads: install it"},
      {"a.ply", "Rar!\x1A\x07" + zeros, "is a RAR archive"},
      {"a.3ds", "7z\xBC\xAF\x27\x1C" + zeros, "is a 7z archive"},
      {"a.fbx", "; FBX 6.1.0 project file\nFBXHeaderExtension: {\n FBXVersion: 6100\n}\n", "is FBX 6.1"},
      {"a.fbx", fbx, "is FBX 6.1"},
      {"a.obj", "\x89PNG\r\n\x1A\n" + zeros, "is a picture (PNG)"},
      {"a.dae", "\xFF\xD8\xFF\xE0" + zeros, "is a picture (JPEG)"},
      {"a.glb", zeros, "holds only zeros"},
      {"a.glb", "", "is empty"},
      {"a.blend", "BLENDER-v304RENDSECRET" + zeros, "is of Blender 3.4, and only the program blender"},
      {"a.blend", "BLENDER17-01v0500SECRET" + zeros, "is of Blender 5.0, and only the program blender"},
      {"a.wrl", "#VRML V2.0 utf8\nSECRET", "is VRML, which is not read"},
      {"a.stl", "version https://git-lfs.github.com/spec/v1\noid sha256:1\n", "is a Git LFS pointer"},
  };
  const OtherPath without_blender(path(""));
  for (const auto& [name, content, words] : cases) {
    const std::string said = failure(file(name, content));
    EXPECT_NE(said.find(words), std::string::npos) << said;
    EXPECT_EQ(said.find("SECRET"), std::string::npos) << said;
  }
}

TEST_F(Import, ModelsAreNotTakenForOtherFiles) {
  EXPECT_FALSE(foreign_kind("PK\3\4", ".3mf"));
  EXPECT_FALSE(foreign_kind("PK\3\4", ".zae"));
  EXPECT_FALSE(foreign_kind("\x1F\x8B", ".blend"));
  EXPECT_FALSE(foreign_kind("BLENDER-v279RENDH", ".blend"));
  EXPECT_FALSE(foreign_kind("BLENDER_v301RENDH", ".blend"));
  EXPECT_FALSE(foreign_kind("<?xml version='1.0'?><COLLADA>", ".dae"));
  EXPECT_FALSE(foreign_kind("<?xml version='1.0'?><!DOCTYPE X3D><X3D><head></head></X3D>", ".x3d"));
  EXPECT_FALSE(foreign_kind("# <html>\nv 0 0 0\n", ".obj"));
  EXPECT_FALSE(foreign_kind("; FBX 7.3.0\nFBXVersion: 7300", ".fbx"));
}

/// A stand-in named blender, which notes its folder for temporary files.
class Blend : public Import {
 protected:
  ExportedBlend exported(const std::string& script, std::chrono::seconds limit) {
    const std::string program =
        file("blender", "#!/bin/sh\n[ \"$1\" = --version ] && exit 0\ncd \"${0%/*}\"\n" + script);
    std::filesystem::permissions(program, std::filesystem::perms::owner_all);
    const OtherPath with_it(path("") + ":" + ::getenv("PATH"));
    return export_blend(file("a 'b\" $(c).blend", "BLENDER"), limit);
  }
};

TEST_F(Blend, NothingIsLeftOfABlenderThatDoesNotEnd) {
  const ExportedBlend blend = exported(
      "touch \"$TMPDIR/left\"\nprintf %s \"$TMPDIR\" >where\nexec >/dev/null 2>&1 sleep 30\n", std::chrono::seconds{2});
  EXPECT_EQ(blend.reason, "it did not end within 2 s");
  ASSERT_FALSE(read(path("where")).empty());
  EXPECT_FALSE(std::filesystem::exists(read(path("where"))));
}

TEST_F(Blend, AFileThatBlenderCannotReadIsSaid) {
  EXPECT_NE(exported("echo \"Error: Failed to read blend file 'a'\"\nexit 1\n", std::chrono::minutes{1})
                .reason.find("damaged"),
            std::string::npos);
}

TEST_F(Blend, ScriptsOfTheFileDoNotRunAndItsNameIsOneWord) {
  const ExportedBlend blend =
      exported("printf '%s\\n' \"$@\" >words\nfor last; do :; done\necho glb >\"$last\"\n", std::chrono::minutes{1});
  EXPECT_EQ(std::string(blend.glb.begin(), blend.glb.end()), "glb\n") << blend.reason;
  const std::string words = read(path("words"));
  EXPECT_NE(words.find("\n--disable-autoexec\n"), std::string::npos);
  EXPECT_NE(words.find("/a 'b\" $(c).blend\n"), std::string::npos) << words;
}

TEST_F(Import, ReasonsOfReadersDoNotQuoteTheFile) {
  const std::string said = failure(file("a.dae", "<COLLADA version=\"1.4.1\"><asset><SECRET"));
  EXPECT_EQ(said.find("SECRET"), std::string::npos) << said;
  EXPECT_NE(said.find("cannot be read as a model"), std::string::npos) << said;
}

}  // namespace
}  // namespace zstrip::sim::test
