// PLY files as programs write them: elements, types and colours; and damaged ones, which are refused at once.
#include <bit>
#include <string>
#include <vector>

#include "import/ply/read_ply.hpp"
#include "import_fixture.hpp"

namespace zstrip::sim::test {
namespace {

const std::string kPlace = "property float x\nproperty float y\nproperty float z\n";
const std::string kRgb = "property uchar red\nproperty uchar green\nproperty uchar blue\n";
const std::string kFace = "property list uchar int vertex_indices\n";
const std::string kSquare = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

std::string text_of(const std::string& elements, const std::string& values) {
  return "ply\nformat ascii 1.0\n" + elements + "end_header\n" + values;
}

/// Bytes of numbers, the lowest first, or the highest.
class Bytes {
 public:
  explicit Bytes(bool swapped) : swapped_(swapped) {}
  Bytes& add(std::uint64_t bits, std::size_t size) {
    for (std::size_t i = 0; i < size; ++i) {
      bytes_ += static_cast<char>(bits >> 8 * (swapped_ ? size - 1 - i : i) & 0xFF);
    }
    return *this;
  }
  Bytes& add(float value) { return add(std::bit_cast<std::uint32_t>(value), 4); }
  Bytes& add(double value) { return add(std::bit_cast<std::uint64_t>(value), 8); }
  const std::string& bytes() const { return bytes_; }

 private:
  bool swapped_;
  std::string bytes_;
};

class Ply : public Import {
 protected:
  Model ply(const std::string& elements, const std::string& values) const {
    return model(file("m.ply", text_of(elements, values)));
  }
};

std::size_t triangle_count(const Model& model) {
  std::size_t count = 0;
  for (const Mesh& mesh : model.meshes) count += mesh.triangles.size();
  return count;
}

TEST_F(Ply, FacesHaveColoursOfTheirOwnAtSharedCorners) {
  const Model two = ply("element vertex 4\n" + kPlace + "element face 2\n" + kFace + kRgb,
                        kSquare + "3 0 1 2 255 0 0\n3 0 2 3 0 0 255\n");
  std::set<std::array<int, 3>> colours;
  std::size_t vertices = 0;
  for (const Mesh& mesh : two.meshes) {
    for (const Colour& c : mesh.colours) colours.insert({c.r, c.g, c.b});
    vertices += mesh.positions.size();
  }
  EXPECT_EQ(colours, (std::set<std::array<int, 3>>{{255, 0, 0}, {0, 0, 255}}));
  EXPECT_EQ(vertices, 6U);
}

TEST_F(Ply, ColoursMayBeFloatsOrOfSixteenBits) {
  for (const auto& [type, values] : {std::pair{"float", "1 0 0.2"},
                                     {"float", "255 0 51"},
                                     {"ushort", "65535 0 13107"},
                                     {"double", "1 0 0.2"},
                                     {"uint8", "255 0 51"}}) {
    const std::string property = std::string("property ") + type;
    const Model one = ply("element vertex 3\n" + kPlace + "element face 1\n" + kFace + property + " red\n" + property +
                              " green\n" + property + " blue\n",
                          std::string("0 0 0\n1 0 0\n0 1 0\n3 0 1 2 ") + values + "\n");
    EXPECT_EQ(one.meshes[0].colours[0], (Colour{255, 0, 51, 255})) << type << ' ' << values;
  }
}

TEST_F(Ply, StripsAreTrianglesOfOneWinding) {
  const Model strip = ply("element vertex 5\n" + kPlace + "element tristrips 1\nproperty list int int vertex_indices\n",
                          "0 0 0\n1 0 0\n0 1 0\n1 1 0\n2 2 0\n8 0 1 2 3 -1 1 4 3\n");
  EXPECT_EQ(triangle_count(strip), 3U);
  for (const Mesh& mesh : strip.meshes) {
    for (const Triangle& t : mesh.triangles) {
      const auto at = [&](std::uint16_t i) { return mesh.positions[i]; };
      const int area =
          (at(t.b).x - at(t.a).x) * (at(t.c).y - at(t.a).y) - (at(t.b).y - at(t.a).y) * (at(t.c).x - at(t.a).x);
      EXPECT_GT(area, 0);
    }
  }
}

TEST_F(Ply, ConcaveFacesAreCutInside) {
  // An arrow: its diagonal from 0 to 2 lies outside.
  const Model arrow =
      ply("element vertex 4\n" + kPlace + "element face 1\n" + kFace, "-1 0 0\n0 0.5 0\n1 0 0\n0 2 0\n4 0 1 2 3\n");
  const auto found = triangles(arrow);
  ASSERT_EQ(found.size(), 2U);
  double area = 0;
  for (const auto& [a, b, c] : found) {
    area += (double(b[0]) - a[0]) * (double(c[1]) - a[1]) - (double(b[1]) - a[1]) * (double(c[0]) - a[0]);
  }
  EXPECT_NEAR(area / 2 / (32767.0 * 32767.0), 1.5 * arrow.units.scale * arrow.units.scale, 0.001);
}

TEST_F(Ply, BytesInEitherOrderAreTheTextsModel) {
  const std::string elements =
      "element vertex 4\nproperty double x\nproperty double y\nproperty float z\nelement face 2\n"
      "property list ushort uint vertex_indices\nproperty uchar flags\nelement other 1\nproperty list char short l\n";
  const Model expected = ply(elements, kSquare + "3 0 1 2 7\n3 0 2 3 7\n2 5 6\n");
  for (const bool swapped : {false, true}) {
    Bytes bytes(swapped);
    for (const auto& [x, y] : {std::pair{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}}) bytes.add(x).add(y).add(0.0F);
    for (const auto& [b, c] : {std::pair{1, 2}, {2, 3}}) {
      bytes.add(3, 2).add(0, 4).add(static_cast<std::uint64_t>(b), 4).add(static_cast<std::uint64_t>(c), 4).add(7, 1);
    }
    bytes.add(2, 1).add(5, 2).add(6, 2);
    const std::string format = swapped ? "binary_big_endian" : "binary_little_endian";
    for (const char* end : {"\n", "\r\n"}) {
      std::string header = "ply\nformat " + format + " 1.0\ncomment made by hand\n" + elements + "end_header\n";
      for (std::size_t at = header.find('\n'); at != std::string::npos; at = header.find('\n', at + 2)) {
        header.replace(at, 1, end);
        if (end[1] == '\0') --at;
      }
      EXPECT_EQ(triangles(model(file("b.ply", header + bytes.bytes()))), triangles(expected)) << format;
    }
  }
}

TEST_F(Ply, PlacesFarAwayKeepDoubles) {
  const std::string elements =
      "element vertex 4\nproperty double x\nproperty double y\nproperty double z\nelement face 1\n" + kFace;
  const Model near = ply(elements, "0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n");
  const Model far = ply(elements,
                        "40000000.25 5000000.5 100\n40000001.25 5000000.5 100\n40000001.25 5000001.5 100\n"
                        "40000000.25 5000001.5 100\n4 0 1 2 3\n");
  EXPECT_EQ(triangles(far), triangles(near));
  EXPECT_EQ(far.units.origin, (std::array<double, 3>{40000000.75, 5000001, 100}));
}

TEST_F(Ply, TexturesAreNamedInAComment) {
  png("a b.png", 4, 4, 0x07E0);
  const std::string elements = "comment TextureFile a b.png\nelement vertex 3\n" + kPlace + "element face 1\n" + kFace +
                               "property list uchar float texcoord\n";
  const Model textured = ply(elements, "0 0 0\n1 0 0\n0 1 0\n3 0 1 2 6 0 0 1 0 0 1\n");
  ASSERT_EQ(textured.textures.size(), 1U);
  EXPECT_EQ(textured.texels[0][0], 0x07E0);
  EXPECT_EQ(textured.meshes[0].texcoords.size(), 3U);
}

TEST_F(Ply, EdgesAreLinesAndVerticesAlonePoints) {
  const Model edges =
      ply("element vertex 3\n" + kPlace + kRgb + "element edge 2\nproperty int vertex1\nproperty int vertex2\n",
          "0 0 0 255 0 0\n1 0 0 255 0 0\n0 1 0 255 0 0\n0 1\n1 2\n");
  ASSERT_EQ(edges.segments.size(), 1U);
  EXPECT_EQ(edges.segments[0].size(), 2U);
  EXPECT_TRUE(edges.warnings.empty());
  const Model points = ply("element vertex 3\n" + kPlace + "element face 0\n" + kFace, "0 0 0\n1 0 0\n0 1 0\n");
  ASSERT_EQ(points.segments.size(), 1U);
  EXPECT_EQ(points.segments[0].size(), 3U);
}

/// Faces with colours of their own copy vertices: the number of a missing vertex was that of the first copy.
TEST_F(Ply, MissingVerticesWereCopiesOfOthers) {
  const std::string faces = "element vertex 3\n" + kPlace + "element face 2\n" + kFace + kRgb;
  const std::string three = "0 0 0\n1 0 0\n0 1 0\n", left_out = "1 triangle left out: with vertices that do not exist";
  const std::string colours = three + "3 2 1 0 255 0 0\n", last = "3 0 1 99 0 255 0\n";
  const Model one = ply(faces, colours + last);
  EXPECT_EQ(triangle_count(one), 1U);
  EXPECT_EQ(one.warnings, std::vector{left_out});

  const Model rest = ply(faces, colours + "4 0 1 2 99 0 0 255\n");
  EXPECT_EQ(triangle_count(rest), 2U);
  EXPECT_EQ(rest.warnings, std::vector{left_out});
  std::set<std::array<int, 3>> seen;
  for (const Mesh& mesh : rest.meshes) {
    for (const Colour& c : mesh.colours) seen.insert({c.r, c.g, c.b});
  }
  EXPECT_EQ(seen, (std::set<std::array<int, 3>>{{255, 0, 0}, {0, 0, 255}})) << "what is left of a face has its colour";

  const Model strip = ply(faces + "element tristrips 1\nproperty list int int vertex_indices\n",
                          colours + "3 2 1 0 255 0 0\n3 0 1 99\n");
  EXPECT_EQ(triangle_count(strip), 2U);
  EXPECT_EQ(strip.warnings, std::vector{left_out});

  const Model edge = ply(faces + "element edge 2\nproperty int vertex1\nproperty int vertex2\n",
                         colours + "3 2 1 0 255 0 0\n0 1\n0 99\n");
  ASSERT_EQ(edge.segments.size(), 1U);
  EXPECT_EQ(edge.segments[0].size(), 1U);
  EXPECT_EQ(edge.warnings.size(), 1U);
}

TEST_F(Ply, ElementsBeforeTheVerticesWereLost) {
  const std::string vertices = "element vertex 4\n" + kPlace, faces = "element face 2\n" + kFace + kRgb;
  const std::string edges = "element edge 1\nproperty int vertex1\nproperty int vertex2\n";
  const std::string coloured = "3 0 1 2 255 0 0\n3 0 2 3 0 0 255\n", edge = "1 3\n";
  const Model expected = ply(vertices + faces + edges, kSquare + coloured + edge);
  const std::string other = "element other 1\nproperty list char short l\n";
  for (const auto& [elements, values] : std::vector<std::pair<std::string, std::string>>{
           {faces + vertices + edges, coloured + kSquare + edge},
           {edges + vertices + faces, edge + kSquare + coloured},
           {faces + other + edges + vertices, coloured + "2 5 6\n" + edge + kSquare}}) {
    const Model read = ply(elements, values);
    EXPECT_EQ(triangles(read), triangles(expected)) << elements;
    ASSERT_EQ(read.segments.size(), 1U) << elements;
    ASSERT_EQ(read.segments[0].size(), 1U) << elements;
    EXPECT_EQ(read.segments[0][0].a, expected.segments[0][0].a) << elements;
    EXPECT_EQ(read.segments[0][0].b, expected.segments[0][0].b) << elements;
    EXPECT_TRUE(read.warnings.empty()) << elements;
  }
  EXPECT_NE(failure(file("bad.ply", text_of(faces + vertices, coloured + "0 0 0\n1 0 0\n1 1 0\n0 100")))
                .find("ends in its elements 'vertex'"),
            std::string::npos);
  EXPECT_NE(failure(file("bad.ply", text_of(faces, coloured))).find("has no vertices"), std::string::npos);
}

/// They were taken for the next element, as MeshLab wrote them: triangles lay anywhere, or the file was refused.
TEST_F(Ply, ValuesThatTheHeaderDoesNotStateAreLeftOut) {
  const std::string elements = "element vertex 4\n" + kPlace + "element face 2\n" + kFace;
  const Model expected = ply(elements, kSquare + "3 0 1 2\n3 0 2 3\n");
  for (const std::string& values :
       {kSquare + "3 0 1 2 9 1 1 1 1 1 1 1 1 1 \n3 0 2 3 9 1 1 1 1 1 1 1 1 1 \n",
        std::string("0 0 0 7\r\n1 0 0 7\r\n1 1 0 7\r\n\r\n0 1 0 7\r\n3 0 1 2\r\n3 0 2 3 0")}) {
    const Model read = ply(elements, values);
    EXPECT_EQ(triangles(read), triangles(expected)) << values;
    ASSERT_EQ(read.warnings.size(), 1U) << values;
    EXPECT_EQ(read.warnings[0], "values at the ends of lines left out: the header does not state them");
  }
  for (const std::string& values :
       {std::string("0 0 0 1 0 0\n1 1\n0 0 1 0 3 0 1 2 3\n0 2 3\n"), kSquare + "3 0 1 2\n3 0 2 3\nend\n"}) {
    const Model read = ply(elements, values);
    EXPECT_EQ(triangles(read), triangles(expected)) << "elements that begin anywhere, and words after them: " << values;
  }
}

/// Damaged headers took 20 seconds of processor each, until the guard stopped them.
TEST_F(Ply, DamageIsRefusedForWhatItIs) {
  const std::string vertices = "element vertex 3\n" + kPlace, faces = "element face 1\n" + kFace;
  const struct {
    std::string content, words;
  } cases[] = {
      {"ply\nformat ascii 1.0\ncomment x\nelement vertex 3\npropert", "the file ends in its header"},
      {text_of("element vertex 4000000000\n" + kPlace + faces, "0 0 0\n"), "less bytes than its 4,000,000,000"},
      {text_of(vertices + faces, "0 0 0\n1 0 0\n0 1 0\n4000000000 0 1 2\n"), "ends in its elements 'face'"},
      {text_of(vertices + faces, "0 0 0\n1 0 0\n0 1 0\n-1 0 1 2\n"), "ends in its elements 'face'"},
      {text_of(vertices + faces, "0 0 0\n1 0 0\n0 1 0\nnan 0 1 2\n"), "ends in its elements 'face'"},
      {text_of("element vertex -1\n" + kPlace, ""), "an element without a count"},
      {text_of("element vertex 3\nproperty float x\nproperty quad y\n", ""), "a property of an unknown type"},
      {text_of("element vertex 3\nproperty float x\n", "0 0 0 0"), "no x, y and z"},
      {"ply\nformat packed 1.0\n" + vertices + "end_header\n", "a format that PLY does not have"},
      {text_of(vertices + "element face 999999999999\nproperty list uchar int vertex_indices\n",
               "0 0 0\n1 0 0\n0 1 0\n"),
       "less bytes than its 999,999,999,999"},
      {"ply", "the file ends in its header"},
  };
  for (const auto& [content, words] : cases) {
    EXPECT_NE(failure(file("bad.ply", content)).find(words), std::string::npos) << failure(path("bad.ply"));
  }
  const Model most = ply(vertices + "element face 2\n" + kFace, "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 1 9\n");
  ASSERT_EQ(most.warnings.size(), 1U);
  EXPECT_EQ(most.warnings[0], "1 triangle left out: with vertices that do not exist");
  EXPECT_EQ(triangle_count(ply(vertices + "element nothing 999999999999\n" + faces, "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")),
            1U);
}

}  // namespace
}  // namespace zstrip::sim::test
