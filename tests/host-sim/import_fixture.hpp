// What the tests of the import share: models that are read and checked, and their triangles.
#pragma once

#include <algorithm>
#include <array>
#include <set>

#include "image/encode.hpp"
#include "import/model.hpp"
#include "support.hpp"
#include "zstrip/scene/validate.hpp"

namespace zstrip::sim::test {

class Import : public FolderTest {
 protected:
  Model model(const std::string& path, std::optional<UpAxis> up = {},
              Texcoords texcoords = Texcoords::of_textures) const {
    Result<Model> imported = import_model(path, up, texcoords, BackFaces::as_front);
    EXPECT_TRUE(imported) << imported.failure().message;
    const Scene scene{.meshes = imported->meshes,
                      .materials = imported->materials,
                      .textures = imported->textures,
                      .instances = imported->instances,
                      .lights = imported->lights};
    EXPECT_TRUE(validate(scene));
    return std::move(*imported);
  }
  std::string failure(const std::string& path) const {
    const Result<Model> imported = import_model(path);
    EXPECT_FALSE(imported);
    if (imported) return "";
    EXPECT_EQ(imported.failure().status, ExitStatus::input);
    EXPECT_NE(imported.failure().message.find(path), std::string::npos);
    return imported.failure().message;
  }
  /// A PNG of one colour (RGB565).
  void png(const std::string& name, std::uint16_t width, std::uint16_t height, std::uint16_t colour) const {
    std::vector<std::byte> pixels;
    for (int i = 0; i < width * height; ++i) {
      pixels.push_back(static_cast<std::byte>(colour & 0xFF));
      pixels.push_back(static_cast<std::byte>(colour >> 8));
    }
    const auto bytes = encode(ImageType::png, {width, height, PixelFormat::rgb565}, pixels);
    ASSERT_TRUE(bytes);
    file(name, std::string(bytes->begin(), bytes->end()));
  }
};

using Point = std::array<int, 3>;

inline Point point(const Position& p) { return {p.x, p.y, p.z}; }

/// The corners of all triangles of a model, each triangle rotated so that its smallest corner comes first.
inline std::multiset<std::array<Point, 3>> triangles(const Model& model) {
  std::multiset<std::array<Point, 3>> result;
  for (const Mesh& mesh : model.meshes) {
    for (const Triangle& t : mesh.triangles) {
      std::array<Point, 3> corners{point(mesh.positions[t.a]), point(mesh.positions[t.b]), point(mesh.positions[t.c])};
      std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
      result.insert(corners);
    }
  }
  return result;
}

}  // namespace zstrip::sim::test
