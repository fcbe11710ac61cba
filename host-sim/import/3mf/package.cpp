// The parts of a 3MF package that are drawn: objects, their colours, and where they are built.
#include "import/3mf/package.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <utility>

#include "import/3mf/xml_tags.hpp"
#include "import/read_model.hpp"

namespace zstrip::sim {
namespace {

constexpr std::string_view kGaps = " \t\r\n";

/// Tags of extensions that are not drawn.
constexpr std::array<std::pair<std::string_view, const char*>, 8> kUndrawn{{{"beamlattice", "beam lattices"},
                                                                            {"slicestack", "slices"},
                                                                            {"booleanshape", "boolean shapes"},
                                                                            {"displacementmesh", "displaced meshes"},
                                                                            {"levelset", "volumes"},
                                                                            {"volumedata", "volumes"},
                                                                            {"multiproperties", "mixed properties"},
                                                                            {"compositematerials", "mixed materials"}}};

/// Removes the next number from a text; not a number (NaN) if there is none.
double take_number(std::string_view& text) {
  const std::size_t first = text.find_first_not_of(kGaps);
  text.remove_prefix(first == std::string_view::npos ? text.size() : first);
  std::string_view word = text.substr(0, text.find_first_of(kGaps));
  text.remove_prefix(word.size());
  if (word.starts_with('+')) word.remove_prefix(1);
  double number = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  const bool whole = error == std::errc() && end == word.data() + word.size();
  return whole ? number : std::numeric_limits<double>::quiet_NaN();
}

double number_of(const XmlTag& tag, std::string_view key) {
  const std::string value = tag.value(key);
  std::string_view text = value;
  return take_number(text);
}

/// Returns an integer >= 0; `otherwise` if there is none.
std::uint32_t index_of(const XmlTag& tag, std::string_view key, std::uint32_t otherwise = kNoProperty) {
  const double number = number_of(tag, key);
  return number >= 0 && number < kNoProperty ? static_cast<std::uint32_t>(number) : otherwise;
}

/// Rows of the transposed matrix: "1 0 0 0 1 0 0 0 1 0 0 0", the translation last.
Affine place_of(const XmlTag& tag) {
  Affine place;
  if (!tag.has("transform")) return place;
  const std::string value = tag.value("transform");
  std::string_view text = value;
  for (std::size_t column = 0; column < 4; ++column) {
    for (std::size_t row = 0; row < 3; ++row) place.m[row][column] = take_number(text);
  }
  return place;
}

/// "#RRGGBB" or "#RRGGBBAA"; white if it is neither.
std::array<std::uint8_t, 4> colour_of(const XmlTag& tag, std::string_view key) {
  const std::string text = tag.value(key);
  std::array<std::uint8_t, 4> colour{255, 255, 255, 255};
  if ((text.size() != 7 && text.size() != 9) || text[0] != '#') return colour;
  for (std::size_t i = 0; 2 * i + 2 < text.size(); ++i) {
    const char* const digits = text.data() + 1 + 2 * i;
    std::from_chars(digits, digits + 2, colour[i], 16);
  }
  return colour;
}

/// Fills a part, tag by tag.
class PartReader {
 public:
  void read(const XmlTag& tag) {
    if (tag.begins) begin(tag);
    if (tag.ends) end(tag.name);
  }
  /// Returns the reason why the part cannot be read; empty if there is none.
  std::string fault() const;
  PrintPart& part() { return part_; }

 private:
  void begin(const XmlTag& tag);
  void end(std::string_view name);
  /// Returns the new resource of an id, or keeps the fault that the id has one already.
  template <class Resource>
  Resource& add(std::map<std::uint32_t, Resource>& resources, const XmlTag& tag, const char* kind);
  /// True inside of a group of this kind.
  bool is_in(PrintGroupKind kind) const { return group_ != nullptr && group_->kind == kind; }
  void begin_object(const XmlTag& tag);
  void add_triangle(const XmlTag& tag);
  void add_use(const XmlTag& tag, std::vector<PrintUse>& to) const;
  void begin_group(const XmlTag& tag, PrintGroupKind kind);

  PrintPart part_;
  std::string repeated_;           ///< the fault of a repeated id
  PrintObject* object_ = nullptr;  ///< the element that is open, as for the group
  PrintGroup* group_ = nullptr;
  std::uint32_t of_object_ = kNoProperty, index_of_object_ = 0;
  std::uint64_t vertices_ = 0, triangles_ = 0;
};

std::string PartReader::fault() const {
  if (triangles_ > kMaxTriangles || vertices_ > 3 * kMaxTriangles) {
    return "it has too many triangles; simplify the model";
  }
  return repeated_;
}

template <class Resource>
Resource& PartReader::add(std::map<std::uint32_t, Resource>& resources, const XmlTag& tag, const char* kind) {
  const std::uint32_t id = index_of(tag, "id");
  const auto [at, is_new] = resources.try_emplace(id);
  if (!is_new) {
    repeated_ = fmt::format("two of its {} have {}", kind, id == kNoProperty ? "no id" : fmt::format("the id {}", id));
  }
  return at->second;
}

void PartReader::begin_object(const XmlTag& tag) {
  object_ = &add(part_.objects, tag, "objects");
  of_object_ = index_of(tag, "pid");
  index_of_object_ = index_of(tag, "pindex", 0);
}

void PartReader::add_triangle(const XmlTag& tag) {
  PrintTriangle& triangle = object_->triangles.emplace_back();
  triangle.corners = {index_of(tag, "v1"), index_of(tag, "v2"), index_of(tag, "v3")};
  const bool has_own = tag.has("p1") || tag.has("pid");
  triangle.group = index_of(tag, "pid", of_object_);
  const std::uint32_t first = index_of(tag, "p1", has_own ? 0 : index_of_object_);
  triangle.properties = {first, index_of(tag, "p2", first), index_of(tag, "p3", first)};
  ++triangles_;
  if (tag.has("paint_color") || tag.has("mmu_segmentation")) {
    part_.undrawn.emplace("colours painted in a slicer, which are not part of 3MF");
  }
}

void PartReader::add_use(const XmlTag& tag, std::vector<PrintUse>& to) const {
  to.push_back({tag.value("path"), index_of(tag, "objectid"), place_of(tag)});
}

void PartReader::begin_group(const XmlTag& tag, PrintGroupKind kind) {
  group_ = nullptr;
  if (index_of(tag, "id") == kNoProperty) return;  // triangles without a group would find it
  group_ = &add(part_.groups, tag, "property groups");
  group_->kind = kind;
  group_->texture = index_of(tag, "texid");
}

void PartReader::end(std::string_view name) {
  if (name == "object") object_ = nullptr;
  if (name == "basematerials" || name == "colorgroup" || name == "texture2dgroup") group_ = nullptr;
}

void PartReader::begin(const XmlTag& tag) {
  if (tag.name == "object") {
    begin_object(tag);
  } else if (tag.name == "vertex" && object_ != nullptr) {
    object_->vertices.push_back({number_of(tag, "x"), number_of(tag, "y"), number_of(tag, "z")});
    ++vertices_;
  } else if (tag.name == "triangle" && object_ != nullptr) {
    add_triangle(tag);
  } else if (tag.name == "component" && object_ != nullptr) {
    add_use(tag, object_->components);
  } else if (tag.name == "item") {
    add_use(tag, part_.built);
  } else if (tag.name == "basematerials") {
    begin_group(tag, PrintGroupKind::materials);
  } else if (tag.name == "colorgroup") {
    begin_group(tag, PrintGroupKind::colours);
  } else if (tag.name == "texture2dgroup") {
    begin_group(tag, PrintGroupKind::texture);
  } else if (tag.name == "base" && is_in(PrintGroupKind::materials)) {
    group_->names.push_back(tag.value("name"));
    group_->colours.push_back(colour_of(tag, "displaycolor"));
  } else if (tag.name == "color" && is_in(PrintGroupKind::colours)) {
    group_->colours.push_back(colour_of(tag, "color"));
  } else if (tag.name == "tex2coord" && is_in(PrintGroupKind::texture)) {
    group_->texcoords.push_back({number_of(tag, "u"), number_of(tag, "v")});
  } else if (tag.name == "texture2d") {
    if (index_of(tag, "id") != kNoProperty) add(part_.textures, tag, "textures") = tag.value("path");
  } else if (const auto* const found = std::ranges::find(kUndrawn, tag.name, &decltype(kUndrawn)::value_type::first);
             found != kUndrawn.end()) {
    part_.undrawn.emplace(found->second);
  }
}

}  // namespace

Result<PrintPart> read_print_part(std::string_view xml) {
  XmlTags tags(xml);
  PartReader reader;
  bool is_model = false;
  while (const std::optional<XmlTag> tag = tags.next()) {
    if (tag->name == "model") is_model = true;
    reader.read(*tag);
    if (std::string fault = reader.fault(); !fault.empty()) return Failure{ExitStatus::input, std::move(fault)};
  }
  if (!is_model) return Failure{ExitStatus::input, "a part of it is not a 3MF model"};
  return std::move(reader.part());
}

}  // namespace zstrip::sim
