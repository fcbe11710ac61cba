// What the tests of the import share: models that are read and checked, and their triangles.
#pragma once

#include <algorithm>
#include <array>
#include <set>
#include <string>

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

/// A Collada file of one triangle of material m, whose effect has these elements besides its diffuse colour.
inline std::string collada_triangle(const std::string& maps, const std::string& picture = "gone.png") {
  return R"(<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">)"
         R"(<library_images><image id="i"><init_from>)" +
         picture +
         R"(</init_from></image></library_images>)"
         R"(<library_effects><effect id="e"><profile_COMMON><newparam sid="s"><surface type="2D"><init_from>i</init_from>)"
         R"(</surface></newparam><newparam sid="t"><sampler2D><source>s</source></sampler2D></newparam>)"
         R"(<technique sid="common"><lambert>)" +
         maps +
         R"(<diffuse><color>1 0 0 1</color></diffuse></lambert></technique></profile_COMMON></effect></library_effects>)"
         R"(<library_materials><material id="m"><instance_effect url="#e"/></material></library_materials>)"
         R"(<library_geometries><geometry id="g"><mesh><source id="p"><float_array id="a" count="9">0 0 0 1 0 0 0 1 0)"
         R"(</float_array><technique_common><accessor source="#a" count="3" stride="3"><param name="X" type="float"/>)"
         R"(<param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>)"
         R"(<source id="q"><float_array id="b" count="6">0 0 1 0 0 1</float_array><technique_common><accessor source="#b" count="3")"
         R"( stride="2"><param name="S" type="float"/><param name="T" type="float"/></accessor></technique_common></source>)"
         R"(<vertices id="v"><input semantic="POSITION" source="#p"/></vertices><triangles material="m" count="1">)"
         R"(<input semantic="VERTEX" source="#v" offset="0"/>)"
         R"(<input semantic="TEXCOORD" source="#q" offset="0" set="0"/><p>0 1 2</p></triangles></mesh>)"
         R"(</geometry></library_geometries>)"
         R"(<library_visual_scenes><visual_scene id="w"><node><instance_geometry url="#g"><bind_material><technique_common>)"
         R"(<instance_material symbol="m" target="#m"/></technique_common></bind_material></instance_geometry></node>)"
         R"(</visual_scene></library_visual_scenes><scene><instance_visual_scene url="#w"/></scene></COLLADA>)";
}

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
