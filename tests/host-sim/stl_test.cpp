// STL files as programs write them: text of any shape, bytes with any count, colours; and damaged ones.
#include <algorithm>
#include <bit>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "import_fixture.hpp"

namespace zstrip::sim::test {
namespace {

const std::string kText =
    "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid "
    "s\n";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
  return text;
}

std::string number(std::uint32_t value, std::size_t size) {
  std::string bytes;
  for (std::size_t i = 0; i < size; ++i) bytes += static_cast<char>(value >> 8 * i & 0xFF);
  return bytes;
}

/// Bytes with a triangle for each of these colours.
std::string bytes_of(std::string header, const std::vector<std::uint32_t>& colours,
                     std::optional<std::uint32_t> count = {}) {
  header.resize(80, ' ');
  std::string bytes = header + number(count.value_or(static_cast<std::uint32_t>(colours.size())), 4);
  float x = 0;
  for (const std::uint32_t colour : colours) {
    for (const float c : {0.0F, 0.0F, 1.0F, x, 0.0F, 0.0F, x + 1, 0.0F, 0.0F, x, 1.0F, 0.0F}) {
      bytes += number(std::bit_cast<std::uint32_t>(c), 4);
    }
    bytes += number(colour, 2);
    x += 2;
  }
  return bytes;
}

class Stl : public Import {
 protected:
  Model stl(const std::string& content) const { return model(file("m.stl", content)); }
  /// The colours of triangles, from left to right.
  std::vector<Colour> colours(const std::string& content) const {
    const Model read = stl(content);
    std::map<int, Colour> by_place;
    for (const Mesh& mesh : read.meshes) {
      for (const Triangle& t : mesh.triangles) {
        const int left = std::min({mesh.positions[t.a].x, mesh.positions[t.b].x, mesh.positions[t.c].x});
        by_place[left] = mesh.colours.empty() ? Colour{} : mesh.colours[t.a];
      }
    }
    std::vector<Colour> found;
    for (const auto& [left, colour] : by_place) found.push_back(colour);
    return found;
  }
};

TEST_F(Stl, TextIsReadInAnyShape) {
  const auto expected = triangles(stl(kText));
  ASSERT_EQ(expected.size(), 1U);
  std::string capitals = kText;
  for (char& c : capitals) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  for (const std::string& text :
       {capitals, "\n \n" + kText, replaced(kText, "\n", "\r\n"), replaced(kText, "\n", "\r"),
        replaced(kText, " ", "\t "), replaced(kText, " normal 0 0 1", ""),
        replaced(kText, "0 0 1", "-1.#IND 1.#QNAN inf"), replaced(kText, "endsolid s\n", ""),
        replaced(kText, "1 0 0", "+1.0E+000 .0 -0.e0"), replaced(kText, "1 0 0", "1,0 0,0 0,0"),
        replaced(kText, "solid s\nf", "f"), replaced(kText, "solid s", "solid outer loop vertex 1 2 3")}) {
    EXPECT_EQ(triangles(stl(text)), expected) << text;
  }
  EXPECT_EQ(triangles(stl(kText + replaced(kText, "0 1 0", "0 2 0"))).size(), 2U) << "two solids";
  EXPECT_EQ(triangles(stl(replaced(kText, "endloop", "vertex -1 0 0\nendloop"))).size(), 2U) << "four corners";
}

TEST_F(Stl, PlacesFarAwayKeepTheirDigits) {
  const Model far = stl(replaced(replaced(kText, "vertex 0", "vertex 40000000.5"), "vertex 1", "vertex 40000001.5"));
  EXPECT_EQ(triangles(far), triangles(stl(kText)));
}

TEST_F(Stl, WhatIsThereCountsWhateverTheHeaderSays) {
  const auto expected = triangles(stl(bytes_of("made by hand", {0, 0})));
  ASSERT_EQ(expected.size(), 2U);
  EXPECT_EQ(triangles(stl(bytes_of("solid bytes", {0, 0}))), expected);
  EXPECT_EQ(triangles(stl(bytes_of("a stream", {0, 0}, 0))), expected) << "no count";
  EXPECT_EQ(triangles(stl(bytes_of("a tail", {0, 0}) + std::string(7, '\0'))), expected);
  EXPECT_EQ(triangles(stl(bytes_of("a tail", {0, 0, 0}, 2))), expected) << "a tail as long as a triangle";
  const Model cut = stl(bytes_of("cut", {0, 0}, 3) + std::string(40, '\0'));
  EXPECT_EQ(triangles(cut), expected);
  EXPECT_EQ(cut.warnings, std::vector<std::string>{"1 triangle left out: the file ends before it"});
}

TEST_F(Stl, ColoursAreThoseOfVisCam) {
  EXPECT_EQ(colours(bytes_of("", {0x8000 | 31 << 10, 0x8000 | 31 << 5, 0x8000 | 31})),
            (std::vector<Colour>{{255, 0, 0, 255}, {0, 255, 0, 255}, {0, 0, 255, 255}}));
  EXPECT_EQ(colours(bytes_of("", {0x8000 | 31, 0}))[1], (Colour{204, 204, 204, 255})) << "without a colour";
  EXPECT_EQ(colours(bytes_of("", {31, 31})), (std::vector<Colour>(2))) << "bits that do not count";
}

TEST_F(Stl, ColoursAreThoseOfMagicsWhereTheHeaderSaysSo) {
  const std::string header = std::string("COLOR=") + '\0' + '\xFF' + '\0' + '\xFF' + ",MATERIAL=";
  EXPECT_EQ(colours(bytes_of(header, {31, 31 << 10, 0x8000, 0})),
            (std::vector<Colour>{{255, 0, 0, 255}, {0, 0, 255, 255}, {0, 255, 0, 255}, {0, 255, 0, 255}}));
}

TEST_F(Stl, DamageIsRefusedForWhatItIs) {
  const struct {
    std::string content, words;
  } cases[] = {{"x", "neither STL text nor as long as a binary header"},
               {bytes_of("", {0}, 1000), "less than half of the triangles"},
               {"solid s\nfacet normal 0 0 1\nouter loop\nvertex SECRET 0 0\n", "has no triangles"},
               {replaced(kText, "vertex 1", "vertex SECRET"), "has no drawable triangle"}};
  for (const auto& [content, words] : cases) {
    const std::string said = failure(file("bad.stl", content));
    EXPECT_NE(said.find(words), std::string::npos) << said;
    EXPECT_EQ(said.find("SECRET"), std::string::npos) << said;
  }
}

}  // namespace
}  // namespace zstrip::sim::test
