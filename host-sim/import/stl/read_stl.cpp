// Reads an STL file, in text or bytes, with the colours of Magics and VisCAM.
#include "import/stl/read_stl.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "import/mesh_groups.hpp"
#include "import/unreadable.hpp"
#include "text/number.hpp"
#include "text/text.hpp"

namespace zstrip::sim {
namespace {

constexpr std::size_t kHeaderBytes = 84, kFacetBytes = 50;  // the header ends with the number of triangles

using Rgb = std::array<std::uint8_t, 3>;

std::uint32_t word_at(std::string_view bytes, std::size_t at, std::size_t size) {
  std::uint32_t word = 0;
  for (std::size_t i = 0; i < size; ++i) word |= std::uint32_t{static_cast<std::uint8_t>(bytes[at + i])} << 8 * i;
  return word;
}

Vector vector_at(std::string_view bytes, std::size_t at) {
  const auto number = [&](std::size_t i) { return double{std::bit_cast<float>(word_at(bytes, at + 4 * i, 4))}; };
  return {number(0), number(1), number(2)};
}

/// Collects facets as triangles.
class Facets {
 public:
  explicit Facets(const Affine& turn) : turn_(turn), linear_(turn) {
    for (auto& row : linear_.m) row[3] = 0;
  }

  /// A normal without length, or with NaN, counts as missing.
  void add(const Vector& normal, const std::array<Vector, 3>& corners, const std::optional<Rgb>& colour) {
    const Vector turned = linear_ * normal;
    const double length = std::hypot(turned[0], turned[1], turned[2]);
    SourceVertex vertex;
    for (std::size_t axis = 0; std::isfinite(length) && length > 1e-20 && axis < 3; ++axis) {
      vertex.normal[axis] = static_cast<float>(turned[axis] / length) + 0.0F;
    }
    if (colour) part_.has_colours = true;
    const Rgb shown = colour.value_or(kDefaultColour);
    vertex.colour = {shown[0], shown[1], shown[2], 255};
    for (const Vector& corner : corners) {
      part_.indices.push_back(static_cast<std::uint32_t>(part_.vertices.size()));
      part_.vertices.push_back(vertex);
      part_.positions.push_back(turn_ * corner);
    }
  }

  bool is_empty() const { return part_.indices.empty(); }
  Result<SourceModel> model(std::vector<std::string> warnings) && {
    SourceModel model;
    model.warnings = std::move(warnings);
    SourceMaterial& material = model.materials.emplace_back();
    if (!part_.has_colours) material.colour = kDefaultColour;
    MeshGroups groups(model);
    if (const Result<Done> added = groups.add(std::move(part_)); !added) return added.failure();
    if (const Result<Done> finished = groups.finish(); !finished) return finished.failure();
    return model;
  }

 private:
  Affine turn_, linear_;
  SourcePrimitive part_;
};

/// Each channel has five bits, the first one the lowest.
Rgb colour_of_bits(std::uint32_t bits, bool red_is_lowest) {
  const auto channel = [bits](unsigned shift) {
    return static_cast<std::uint8_t>(((bits >> shift & 31) * 255 + 15) / 31);
  };
  return {channel(red_is_lowest ? 0 : 10), channel(5), channel(red_is_lowest ? 10 : 0)};
}

/// The colour of the whole from the header of Magics.
std::optional<Rgb> colour_in_header(std::string_view file) {
  constexpr std::string_view kColour = "COLOR=";  // red, green, blue, alpha
  const std::string_view header = file.substr(0, kHeaderBytes - 4);
  const std::size_t name = header.find(kColour);
  if (name == header.npos || name + kColour.size() + 3 > header.size()) return std::nullopt;
  const auto channel = [&](std::size_t i) { return static_cast<std::uint8_t>(header[name + kColour.size() + i]); };
  return Rgb{channel(0), channel(1), channel(2)};
}

Result<SourceModel> read_bytes(std::string_view file, const Affine& turn) {
  const std::size_t there = (file.size() - kHeaderBytes) / kFacetBytes, said = word_at(file, 80, 4);
  std::vector<std::string> warnings;
  if (said > there) {
    warnings.push_back(fmt::format("{} left out: the file ends before {}", counted(said - there, "triangle"),
                                   said - there == 1 ? "it" : "them"));
  }
  const std::size_t count = said == 0 ? there : std::min(said, there);
  const std::optional<Rgb> whole = colour_in_header(file);
  Facets facets(turn);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t at = kHeaderBytes + i * kFacetBytes;
    const std::uint32_t bits = word_at(file, at + 48, 2);
    const bool is_marked = (bits & 0x8000) != 0;
    std::optional<Rgb> colour = whole;
    if (whole && bits != 0 && !is_marked) colour = colour_of_bits(bits, true);
    if (!whole && is_marked) colour = colour_of_bits(bits, false);
    facets.add(vector_at(file, at), {vector_at(file, at + 12), vector_at(file, at + 24), vector_at(file, at + 36)},
               colour);
  }
  return std::move(facets).model(std::move(warnings));
}

/// The words of a text, in small letters.
class Words {
 public:
  explicit Words(std::string_view text) : rest_(text) {}
  /// Returns the next word; empty at the end.
  std::string next() {
    constexpr std::string_view kSpaces = " \t\r\n\v\f";
    rest_.remove_prefix(std::min(rest_.find_first_not_of(kSpaces), rest_.size()));
    const std::string_view word = rest_.substr(0, rest_.find_first_of(kSpaces));
    rest_.remove_prefix(word.size());
    return lower(std::string(word));
  }
  void skip_line() { rest_.remove_prefix(std::min(rest_.find_first_of("\r\n"), rest_.size())); }
  /// Returns the next three words as numbers; words that stand for a number (nan, -1.#IND) become NaN.
  Vector take_vector() {
    Vector numbers{};
    for (double& number : numbers) {
      const std::string_view before = rest_;
      const std::string word = next();
      if (word == "outer" || word == "vertex" || word == "endloop" || word == "endfacet") {
        rest_ = before;
        number = std::numeric_limits<double>::quiet_NaN();
        continue;
      }
      number = number_of(word);
    }
    return numbers;
  }

 private:
  /// Some writers have a decimal comma.
  static double number_of(std::string word) {
    std::ranges::replace(word, ',', '.');
    const char* first = word.data();
    const char* const last = first + word.size();
    if (word.starts_with('+')) ++first;
    double number = 0;
    const auto [end, error] = std::from_chars(first, last, number);
    return error == std::errc() && end == last ? number : std::numeric_limits<double>::quiet_NaN();
  }

  std::string_view rest_;
};

Result<SourceModel> read_text(std::string_view file, const Affine& turn) {
  Words words(file);
  Facets facets(turn);
  Vector normal{};
  std::vector<Vector> corners;
  for (std::string word = words.next(); !word.empty(); word = words.next()) {
    if (word == "solid" || word == "endsolid") words.skip_line();  // a name may hold any word
    if (word == "normal") normal = words.take_vector();
    if (word == "facet") normal = {};
    if (word == "loop") corners.clear();
    if (word != "vertex") continue;
    corners.push_back(words.take_vector());
    const std::size_t count = corners.size();
    if (count >= 3) facets.add(normal, {corners[0], corners[count - 2], corners[count - 1]}, std::nullopt);
  }
  return std::move(facets).model({});
}

/// True for text: it has the words of a facet, and no zero byte. Headers of bytes begin with 'solid', too.
bool is_text(std::string_view file) {
  if (file.find('\0') != file.npos) return false;
  Words words(file);
  const std::string first = words.next();
  return first == "solid" || first == "facet";
}

}  // namespace

Result<SourceModel> read_stl(std::string_view file, const Affine& turn) {
  if (is_text(file)) return read_text(file, turn);
  if (file.size() < kHeaderBytes) return unreadable_model("it is neither STL text nor as long as a binary header");
  const std::size_t there = (file.size() - kHeaderBytes) / kFacetBytes, said = word_at(file, 80, 4);
  // A file in text, or of another format, has any number there.
  if (there == 0 || said / 2 > there)
    return unreadable_model("it has less than half of the triangles that its header states");
  return read_bytes(file, turn);
}

}  // namespace zstrip::sim
