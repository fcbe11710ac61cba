// 3MF packages as slicers and CAD programs write them: parts, components, colours; and damaged ones.
#include <zlib.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "import/3mf/xml_tags.hpp"
#include "import/3mf/zip_archive.hpp"
#include "import_fixture.hpp"

namespace zstrip::sim::test {
namespace {

std::string number(std::size_t value, std::size_t bytes) {
  std::string text;
  for (std::size_t i = 0; i < bytes; ++i) text += static_cast<char>(value >> 8 * i & 0xFF);
  return text;
}

std::string deflated(const std::string& bytes) {
  std::string packed(bytes.size() + 100, '\0');
  z_stream stream{};
  EXPECT_EQ(deflateInit2(&stream, 9, Z_DEFLATED, -MAX_WBITS, 8, Z_DEFAULT_STRATEGY), Z_OK);
  std::string from = bytes;
  stream.next_in = reinterpret_cast<Bytef*>(from.data());
  stream.avail_in = static_cast<uInt>(from.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  EXPECT_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return packed;
}

/// A zip archive of these files. `wide`: as zip64 has them, which lib3mf always writes.
std::string zip_of(const std::vector<std::pair<std::string, std::string>>& files, bool packs, bool wide = false) {
  std::string local, listed;
  for (const auto& [name, content] : files) {
    const std::string data = packs ? deflated(content) : content;
    const std::string packing = number(packs ? 8 : 0, 2) + number(0, 8);
    const auto sizes = [&, size = content.size()](std::size_t bytes) {
      return number(data.size(), bytes) + number(size, bytes);
    };
    const std::string hidden = number(0xFFFFFFFF, 4);
    const std::string fields = wide ? number(9, 2) + number(1, 2) + "x" + number(1, 2) + number(24, 2) +
                                          number(content.size(), 8) + number(data.size(), 8) + number(local.size(), 8)
                                    : "";
    listed += "PK\1\2" + number(20, 4) + number(0, 2) + packing + (wide ? hidden + hidden : sizes(4)) +
              number(name.size(), 2) + number(fields.size(), 2) + number(0, 8) + number(0, 2) +
              (wide ? hidden : number(local.size(), 4)) + name + fields;
    local += "PK\3\4" + number(20, 2) + number(0, 2) + packing + sizes(4) + number(name.size(), 2) + number(0, 2) +
             name + data;
  }
  const std::string count = number(files.size(), 2) + number(files.size(), 2);
  if (!wide) {
    return local + listed + "PK\5\6" + number(0, 4) + count + number(listed.size(), 4) + number(local.size(), 4) +
           number(0, 2);
  }
  return local + listed + "PK\6\6" + number(44, 8) + number(0, 8) + number(0, 4) + number(files.size(), 8) +
         number(files.size(), 8) + number(listed.size(), 8) + number(local.size(), 8) + "PK\6\7" + number(0, 4) +
         number(local.size() + listed.size(), 8) + number(1, 4) + "PK\5\6" + number(0, 4) + count +
         number(0xFFFFFFFF, 4) + number(0xFFFFFFFF, 4) + number(0, 2);
}

const std::string kModel =
    "<model unit=\"millimeter\" xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\" "
    "xmlns:m=\"http://schemas.microsoft.com/3dmanufacturing/material/2015/02\" "
    "xmlns:p=\"http://schemas.microsoft.com/3dmanufacturing/production/2015/06\">";
const std::string kVertices =
    "<vertices><vertex x='0' y='0' z='0'/><vertex x='1' y='0' z='0'/><vertex x='0' y='1' z='0'/></vertices>";

std::string mesh_of(const std::string& triangle = "<triangle v1='0' v2='1' v3='2'/>") {
  return "<mesh>" + kVertices + "<triangles>" + triangle + "</triangles></mesh>";
}

std::string part_of(const std::string& resources, const std::string& built) {
  return "<?xml version=\"1.0\"?>\n<!-- > -->" + kModel + "<resources>" + resources + "</resources><build>" + built +
         "</build></model>";
}

class PrintPackage : public Import {
 protected:
  Model package(const std::vector<std::pair<std::string, std::string>>& files, bool packs = true) const {
    return model(file("m.3mf", zip_of(files, packs)), UpAxis::plus_y);
  }
  Model one_part(const std::string& resources, const std::string& built) const {
    return package({{"3D/3dmodel.model", part_of(resources, built)}});
  }
};

TEST_F(PrintPackage, ComponentsOfOtherPartsArePlaced) {
  const std::string relations =
      "<Relationships><Relationship Target=\"/3D/Root.model\" Id=\"r\" "
      "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>";
  const std::vector<std::pair<std::string, std::string>> files{
      {"_rels/.rels", relations},
      {"3D/Root.model",
       part_of("<object id='9'><components>"
               "<component p:path='/3D/Objects/a.model' objectid='1'/>"
               "<component p:path='/3D/Objects/a.model' objectid='1' transform='1 0 0 0 1 0 0 0 1 3 0 0'/>"
               "</components></object>",
               "<item objectid='9'/>")},
      {"3D/Objects/a.model", part_of("<object id='1'>" + mesh_of() + "</object>", "")}};
  for (const bool packs : {false, true}) {
    const Model built = package(files, packs);
    EXPECT_EQ(triangles(built), triangles(model(file("two.obj",
                                                     "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 3 0 0\nv 4 0 0\nv 3 1 0\n"
                                                     "f 1 2 3\nf 4 5 6\n"))));
    EXPECT_TRUE(built.warnings.empty());
  }
}

TEST_F(PrintPackage, ItemsMayBeBuiltFromOtherParts) {
  const Model built =
      package({{"3D/3dmodel.model",
                part_of("", "<item objectid='1' p:path='/3D/a.model' transform='1 0 0 0 1 0 0 0 1 0 0 5'/>")},
               {"3D/a.model", part_of("<object id='1'>" + mesh_of() + "</object>", "")}});
  EXPECT_EQ(built.units.origin, (std::array<double, 3>{0.5, 0.5, 5}));
}

TEST_F(PrintPackage, OnlyWhatIsBuiltIsDrawn) {
  const std::string objects = "<object id='1'>" + mesh_of() + "</object><object id='2'>" + mesh_of() + "</object>";
  EXPECT_EQ(triangles(one_part(objects, "<item objectid='2'/>")).size(), 1U);
  const Model lost = one_part(objects, "<item objectid='2'/><item objectid='7'/>");
  EXPECT_EQ(lost.warnings, std::vector<std::string>{"1 object left out: not in the file"});
}

TEST_F(PrintPackage, ColourGroupsColourCorners) {
  const Model coloured = one_part(
      "<m:colorgroup id='5'><m:color color='#FF0000'/><m:color color='#00FF0080'/><m:color color='#0000FF'/>"
      "</m:colorgroup><object id='1' pid='5' pindex='2'>" +
          mesh_of("<triangle v1='0' v2='1' v3='2' pid='5' p1='0' p2='1' p3='2'/>") + "</object>",
      "<item objectid='1'/>");
  std::set<std::array<int, 3>> colours;
  for (const Colour& c : coloured.meshes[0].colours) colours.insert({c.r, c.g, c.b});
  EXPECT_EQ(colours, (std::set<std::array<int, 3>>{{255, 0, 0}, {0, 255, 0}, {0, 0, 255}}));
  const Model whole = one_part(
      "<m:colorgroup id='5'><m:color color='#FF0000'/><m:color color='#00FF00'/></m:colorgroup>"
      "<object id='1' pid='5' pindex='1'>" +
          mesh_of() + "</object>",
      "<item objectid='1'/>");
  for (const Colour& c : whole.meshes[0].colours) EXPECT_EQ(c, (Colour{0, 255, 0, 255}));
}

TEST_F(PrintPackage, BaseMaterialsColourTrianglesAndObjects) {
  const std::string materials =
      "<basematerials id='3'><base name='a &amp; b' displaycolor='#112233FF'/><base name='c' displaycolor='#445566'/>"
      "</basematerials>";
  const Model both = one_part(materials + "<object id='1' pid='3' pindex='0'><mesh>" + kVertices +
                                  "<triangles><triangle v1='0' v2='1' v3='2'/><triangle v1='0' v2='2' v3='1' p1='1'/>"
                                  "</triangles></mesh></object>",
                              "<item objectid='1'/>");
  std::map<std::string, Colour> colours;
  for (std::size_t i = 0; i < both.materials.size(); ++i) colours[both.material_names[i]] = both.materials[i].colour;
  EXPECT_EQ(colours["a & b"], (Colour{0x11, 0x22, 0x33, 255}));
  EXPECT_EQ(colours["c"], (Colour{0x44, 0x55, 0x66, 255}));
}

/// A colour among materials has no name: one was read beyond the end of the names.
TEST_F(PrintPackage, ColoursAmongMaterialsHadNamesBeyondTheEnd) {
  const auto second_of = [&](const std::string& group, const std::string& added) {
    return one_part(group + added + "<object id='2' pid='1' pindex='1'>" + mesh_of() + "</object>",
                    "<item objectid='2'/>");
  };
  const std::string material = "<basematerials id='1'><base name='a' displaycolor='#FF0000'/>";
  const std::string colour = "<m:colorgroup id='1'><m:color color='#FF0000'/>";
  const Model mixed = second_of(material, "<m:color color='#00FF00'/></basematerials>");
  EXPECT_EQ(mixed.materials[0].colour, (Colour{255, 255, 255, 255})) << "the group has one material";
  EXPECT_EQ(mixed.material_names[0], "");
  for (const char* other : {"<base name='b' displaycolor='#00FF00'/></m:colorgroup>",
                            "<m:tex2coord u='0' v='0'/></m:colorgroup>", "</m:colorgroup><m:color color='#00FF00'/>"}) {
    const Model coloured = second_of(colour, other);
    for (const Colour& c : coloured.meshes[0].colours) EXPECT_EQ(c, (Colour{255, 255, 255, 255})) << other;
  }
  const Model closed = second_of("<m:colorgroup id='1'/>", "<m:color color='#FF0000'/><m:color color='#00FF00'/>");
  for (const Colour& c : closed.meshes[0].colours) EXPECT_EQ(c, (Colour{255, 255, 255, 255}));
}

/// The second object's corners were those of the first one.
TEST_F(PrintPackage, ResourcesOfOneIdWereMixed) {
  const std::string object = "<object id='2'>" + mesh_of() + "</object>", built = "<item objectid='2'/>";
  const std::string group = "<m:colorgroup id='1'><m:color color='#FF0000'/></m:colorgroup>";
  const std::string texture = "<m:texture2d id='1' path='/t.png'/>";
  for (const auto& [resources, words] : std::vector<std::pair<std::string, std::string>>{
           {object + object, "two of its objects have the id 2"},
           {"<object>" + mesh_of() + "</object><object>" + mesh_of() + "</object>", "two of its objects have no id"},
           {group + group + object, "two of its property groups have the id 1"},
           {group + "<basematerials id='1'/>" + object, "two of its property groups have the id 1"},
           {texture + texture + object, "two of its textures have the id 1"}}) {
    const std::string said = failure(file("bad.3mf", zip_of({{"3D/3dmodel.model", part_of(resources, built)}}, true)));
    EXPECT_NE(said.find(words), std::string::npos) << said;
  }
  EXPECT_TRUE(
      one_part(group + texture + "<object id='1'>" + mesh_of() + "</object>", "<item objectid='1'/>").warnings.empty())
      << "resources of different kinds are told apart";
}

TEST_F(PrintPackage, GroupsWithoutAnIdColouredAllTriangles) {
  const std::string object = "<object id='2'>" + mesh_of() + "</object>", built = "<item objectid='2'/>";
  const Model plain = one_part(object, built);
  const Model with_group =
      one_part("<basematerials><base name='a' displaycolor='#FF0000'/></basematerials>" + object, built);
  EXPECT_EQ(with_group.materials[0].colour, plain.materials[0].colour);
  EXPECT_EQ(with_group.material_names, plain.material_names);
}

TEST_F(PrintPackage, TexturesLieInThePackage) {
  png("t.png", 4, 4, 0xF800);
  const Model textured =
      package({{"3D/3dmodel.model",
                part_of("<m:texture2d id='1' path='/3D/Textures/t.png' contenttype='image/png'/>"
                        "<m:texture2dgroup id='2' texid='1'><m:tex2coord u='0' v='0'/><m:tex2coord u='1' v='0'/>"
                        "<m:tex2coord u='0' v='1'/></m:texture2dgroup><object id='3'>" +
                            mesh_of("<triangle v1='0' v2='1' v3='2' pid='2' p1='0' p2='1' p3='2'/>") + "</object>",
                        "<item objectid='3'/>")},
               {"3D/Textures/t.png", read(path("t.png"))}});
  ASSERT_EQ(textured.textures.size(), 1U);
  EXPECT_EQ(textured.texels[0][0], 0xF800);
  EXPECT_EQ(textured.meshes[0].texcoords.size(), 3U);
}

TEST_F(PrintPackage, SizesOfZip64AreRead) {
  const std::string part = part_of("<object id='1'>" + mesh_of() + "</object>", "<item objectid='1'/>");
  const std::string zip = zip_of({{"3D/3dmodel.model", part}}, true, true);
  EXPECT_EQ(triangles(model(file("m.3mf", zip), UpAxis::plus_y)).size(), 1U);
  for (std::size_t length = 0; length + 22 < zip.size(); length += 5) failure(file("bad.3mf", zip.substr(0, length)));
}

/// Places near 2^64 were an internal error.
TEST_F(PrintPackage, PlacesOfZip64BeyondTheFileAreDamage) {
  const std::string part = part_of("<object id='1'>" + mesh_of() + "</object>", "<item objectid='1'/>");
  const std::string zip = zip_of({{"3D/3dmodel.model", part}}, true, true);
  const std::size_t listed = zip.find("PK\1\2"), end = zip.find("PK\6\6"), place = zip.find("PK\6\7");
  for (const std::size_t at : {end - 8, end + 48, place + 8}) {
    for (const std::size_t before : {1U, 10U, 30U, 46U}) {
      failure(file("bad.3mf", std::string(zip).replace(at, 8, number(0 - before, 8))));
    }
  }
  // More than 65,534 files: only their number has 64 bits.
  std::string many = zip;
  many.replace(many.size() - 14, 4, number(0xFFFFFFFF, 4)).replace(many.size() - 6, 4, number(listed, 4));
  EXPECT_EQ(triangles(model(file("m.3mf", many), UpAxis::plus_y)).size(), 1U);
}

TEST_F(PrintPackage, ExtensionsThatAreNotDrawnAreNamed) {
  const std::string lattice = "<mesh>" + kVertices + "<b:beamlattice><b:beams/></b:beamlattice></mesh>";
  EXPECT_EQ(one_part("<object id='1'>" + mesh_of() + "</object><object id='2'>" + lattice + "</object>",
                     "<item objectid='1'/>")
                .warnings,
            std::vector<std::string>{"drawn without: beam lattices"});
  const std::string alone = part_of("<object id='1'>" + lattice + "</object>", "<item objectid='1'/>");
  const std::string said = failure(file("bad.3mf", zip_of({{"3D/3dmodel.model", alone}}, true)));
  EXPECT_NE(said.find("has no triangles, but beam lattices"), std::string::npos) << said;
}

TEST_F(PrintPackage, DamageIsRefusedForWhatItIs) {
  const std::string good = zip_of(
      {{"3D/3dmodel.model", part_of("<object id='1'>" + mesh_of() + "</object>", "<item objectid='1'/>")}}, true);
  const struct {
    std::string content, words;
  } cases[] = {
      {"no zip", "is not a zip archive"},
      {zip_of({{"other.txt", "x"}}, true), "lacks '3D/3dmodel.model'"},
      {zip_of({{"3D/3dmodel.model", "text"}}, true), "is not a 3MF model"},
      {zip_of(
           {{"3D/3dmodel.model", part_of("<object id='1'><components><component objectid='1'/></components></object>",
                                         "<item objectid='1'/>")}},
           true),
       "nested too deeply"},
      {zip_of({{"3D/3dmodel.model", part_of("", "")}}, true), "has no triangles, lines or points"},
      {zip_of({{"3D/3dmodel.model", part_of("", "<item objectid='1' p:path='/gone.model'/>")}}, true),
       "lacks '/gone.model'"},
  };
  for (const auto& [content, words] : cases) {
    EXPECT_NE(failure(file("bad.3mf", content)).find(words), std::string::npos) << failure(path("bad.3mf"));
  }
  for (std::size_t length = 0; length < good.size(); length += 7) failure(file("bad.3mf", good.substr(0, length)));
}

TEST(ZipArchives, DoNotUnpackMoreThanTheirSizeMay) {
  std::string bomb = zip_of({{"a", "aaaa"}}, true);
  const std::size_t listed = bomb.find("PK\1\2");
  bomb.replace(listed + 24, 4, number(0xFFFFFFF0, 4));
  Result<ZipArchive> archive = ZipArchive::open(bomb);
  ASSERT_TRUE(archive);
  EXPECT_EQ(archive->read("a").failure().message, "it unpacks to more than a file of its size may");
}

/// Files that the list calls empty were unpacked as often as it named them.
TEST(ZipArchives, StoredFilesWereOutsideOfTheBudget) {
  std::string archived = zip_of({{"a", "aaaa"}}, false);
  archived.replace(archived.find("PK\1\2") + 24, 4, number(0, 4));
  Result<ZipArchive> archive = ZipArchive::open(archived);
  ASSERT_TRUE(archive);
  const Result<std::string> read = archive->read("a");
  ASSERT_FALSE(read);
  EXPECT_EQ(read.failure().message, "a file in it that is not packed has two sizes");
}

TEST(XmlTagsOfAText, EndWhereItIsNoXml) {
  XmlTags tags("<a x='1' n:y=\"2 &lt;\"><!-- <b/> --><![CDATA[<c/>]]><d/></a><e f");
  std::vector<std::string> names;
  while (const std::optional<XmlTag> tag = tags.next()) {
    names.push_back((tag->begins ? "" : "/") + std::string(tag->name) + (tag->begins && tag->ends ? "/" : ""));
    if (tag->name == "a" && tag->begins) {
      EXPECT_EQ(tag->value("x"), "1");
      EXPECT_EQ(tag->value("y"), "2 <");
    }
  }
  EXPECT_EQ(names, (std::vector<std::string>{"a", "d/", "/a"}));
}

}  // namespace
}  // namespace zstrip::sim::test
