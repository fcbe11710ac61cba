// Reads a PLY file: vertices, faces and strips with their colours, edges, and clouds of points.
#include "import/ply/read_ply.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "import/mesh_groups.hpp"
#include "import/ply/header.hpp"
#include "import/ply/values.hpp"
#include "import/read_model.hpp"
#include "import/screen_channel.hpp"
#include "import/triangulate.hpp"
#include "import/unreadable.hpp"
#include "text/number.hpp"
#include "text/text.hpp"

namespace zstrip::sim {
namespace {

/// The values of an element: of each property one, or a list.
using Row = std::vector<std::vector<double>>;

bool read_row(PlyValues& values, const PlyElement& element, Row& row) {
  row.resize(element.properties.size());
  for (std::size_t i = 0; i < row.size(); ++i) {
    const PlyProperty& property = element.properties[i];
    double count = 1;
    if (property.is_list) {
      const std::optional<double> read = values.next(property.count_type);
      if (!read || !(*read >= 0)) return false;
      count = *read;
    }
    row[i].clear();
    for (double k = 0; k < count; ++k) {
      const std::optional<double> value = values.next(property.type);
      if (!value) return false;
      row[i].push_back(*value);
    }
  }
  return true;
}

/// The properties of red, green and blue.
struct ColourPlace {
  std::array<std::size_t, 3> properties{};
  std::array<double, 3> whole{1, 1, 1};  ///< the largest value of each

  static std::optional<ColourPlace> find(const PlyElement& element) {
    ColourPlace place{{element.find({"red", "r", "diffuse_red"}), element.find({"green", "g", "diffuse_green"}),
                       element.find({"blue", "b", "diffuse_blue"})},
                      {}};
    for (std::size_t c = 0; c < 3; ++c) {
      if (place.properties[c] >= element.properties.size()) return std::nullopt;
      const PlyProperty& property = element.properties[place.properties[c]];
      if (property.is_list) return std::nullopt;
      const bool is_float = property.type == PlyType::float32 || property.type == PlyType::float64;
      place.whole[c] = is_float ? 1 : std::ldexp(1.0, static_cast<int>(8 * bytes_of(property.type))) - 1;
    }
    return place;
  }

  std::array<std::uint8_t, 4> of(const Row& row) const {
    std::array<std::uint8_t, 4> colour{0, 0, 0, 255};
    for (std::size_t c = 0; c < 3; ++c) {
      const double value = row[properties[c]][0];
      // Some writers give floats of 0 to 255.
      colour[c] = to_screen_channel(value / (whole[c] == 1 && value > 1 ? 255 : whole[c]), false);
    }
    return colour;
  }
};

/// Stands for a vertex that does not exist; never the number of a vertex, nor of a copy.
constexpr std::uint32_t kNoVertex = 0xFFFFFFFF;
static_assert(3 * kMaxTriangles < kNoVertex);

/// Elements of a text follow each other on any lines, or each begins a line, whose further values are skipped.
enum class Rows { follow_each_other, begin_lines };

/// The elements of a file as parts of a model.
class PlyReader {
 public:
  PlyReader(std::string_view data, const PlyHeader& header, const Affine& turn, Rows rows)
      : values_(data, header.format), header_(header), turn_(turn), rows_(rows) {}

  Result<Done> read_all();
  /// True if all values of a text are read.
  bool is_at_end() const { return values_.is_at_end(); }
  Result<SourceModel> model(const ReadPicture& read_picture, Texcoords texcoords) &&;

 private:
  /// Calls visit(row) for each element; the visit fails with a failure.
  template <class Visit>
  Result<Done> for_each(const PlyElement& element, const Visit& visit);
  /// Reads past rows that are not drawn.
  Result<Done> skip(const PlyElement& element);
  Result<Done> read_vertices(const PlyElement& element);
  Result<Done> read_faces(const PlyElement& element);
  Result<Done> read_strips(const PlyElement& element);
  Result<Done> read_edges(const PlyElement& element);
  Result<Done> add_face(std::span<const double> corners, std::span<const double> texcoords,
                        const std::optional<std::array<std::uint8_t, 4>>& colour);
  void add_triangle(const std::array<double, 3>& corners);
  /// Returns the vertex of a number; kNoVertex if there is none.
  std::uint32_t to_vertex(double number) const {
    const bool exists = number >= 0 && number < static_cast<double>(vertices_);
    return exists ? static_cast<std::uint32_t>(number) : kNoVertex;
  }
  /// Returns a copy of the vertex, with these values of its own.
  std::uint32_t copy_of(std::uint32_t vertex, const std::optional<std::array<std::uint8_t, 4>>& colour,
                        const std::optional<std::array<float, 2>>& texcoord);

  PlyValues values_;
  const PlyHeader& header_;
  Affine turn_;
  Rows rows_;
  SourcePrimitive part_;
  std::size_t vertices_ = 0;  ///< of the element `vertex`; copies with colours of faces follow them
  std::size_t faces_ = 0, too_large_ = 0;
  bool has_texcoords_ = false;
};

template <class Visit>
Result<Done> PlyReader::for_each(const PlyElement& element, const Visit& visit) {
  if (element.properties.empty()) return Done{};
  if (element.count > values_.room_for(element)) {
    return unreadable_model(
        fmt::format("it has less bytes than its {} of '{}' take", grouped(element.count), printable(element.name)));
  }
  Row row;
  for (std::uint64_t i = 0; i < element.count; ++i) {
    if (!read_row(values_, element, row)) {
      return unreadable_model(fmt::format("it ends in its elements '{}'", printable(element.name)));
    }
    if (rows_ == Rows::begin_lines) values_.skip_line();
    if (const Result<Done> done = visit(row); !done) return done.failure();
  }
  return Done{};
}

Result<Done> PlyReader::skip(const PlyElement& element) {
  return for_each(element, [](const Row&) -> Result<Done> { return Done{}; });
}

Result<Done> PlyReader::read_vertices(const PlyElement& element) {
  const std::array<std::size_t, 3> place{element.find({"x"}), element.find({"y"}), element.find({"z"})};
  const std::array<std::size_t, 3> normal{element.find({"nx"}), element.find({"ny"}), element.find({"nz"})};
  const std::array<std::size_t, 2> texcoord{element.find({"u", "s", "texture_u"}),
                                            element.find({"v", "t", "texture_v"})};
  const auto has = [&](std::span<const std::size_t> properties) {
    return std::ranges::all_of(
        properties, [&](std::size_t at) { return at < element.properties.size() && !element.properties[at].is_list; });
  };
  if (!has(place)) return unreadable_model("its vertices have no x, y and z");
  if (element.count > 3 * kMaxTriangles && element.count <= values_.room_for(element)) {
    return Failure{ExitStatus::input, fmt::format("has more than {} vertices; simplify the model", 3 * kMaxTriangles)};
  }
  const std::optional<ColourPlace> colour = ColourPlace::find(element);
  const bool has_normals = has(normal);
  has_texcoords_ = has(texcoord);
  part_.has_colours = colour.has_value();
  Affine linear = turn_;
  for (auto& row : linear.m) row[3] = 0;
  Result<Done> done = for_each(element, [&](const Row& row) -> Result<Done> {
    part_.positions.push_back(turn_ * Vector{row[place[0]][0], row[place[1]][0], row[place[2]][0]});
    SourceVertex& vertex = part_.vertices.emplace_back();
    if (has_normals) {
      const Vector n = linear * Vector{row[normal[0]][0], row[normal[1]][0], row[normal[2]][0]};
      const double length = std::hypot(n[0], n[1], n[2]);
      for (std::size_t axis = 0; std::isfinite(length) && length > 1e-20 && axis < 3; ++axis) {
        vertex.normal[axis] = static_cast<float>(n[axis] / length) + 0.0F;
      }
    }
    if (colour) vertex.colour = colour->of(row);
    if (has_texcoords_) {
      const double u = row[texcoord[0]][0], v = 1 - row[texcoord[1]][0];
      if (std::isfinite(u) && std::isfinite(v)) {
        vertex.texcoord = {static_cast<float>(u) + 0.0F, static_cast<float>(v) + 0.0F};
      } else {
        ++part_.bad_texcoords;
      }
    }
    return Done{};
  });
  vertices_ = part_.vertices.size();
  return done;
}

std::uint32_t PlyReader::copy_of(std::uint32_t vertex, const std::optional<std::array<std::uint8_t, 4>>& colour,
                                 const std::optional<std::array<float, 2>>& texcoord) {
  SourceVertex copy = part_.vertices[vertex];
  if (colour) copy.colour = *colour;
  if (texcoord) copy.texcoord = *texcoord;
  part_.vertices.push_back(copy);
  const Vector place = part_.positions[vertex];
  part_.positions.push_back(place);
  return static_cast<std::uint32_t>(part_.vertices.size() - 1);
}

Result<Done> PlyReader::add_face(std::span<const double> corners, std::span<const double> texcoords,
                                 const std::optional<std::array<std::uint8_t, 4>>& colour) {
  if (corners.size() > kMaxCorners) {
    ++too_large_;
    return Done{};
  }
  std::vector<std::uint32_t> face;
  for (const double corner : corners) face.push_back(to_vertex(corner));
  const bool exist = std::ranges::find(face, kNoVertex) == face.end();
  const bool has_own = texcoords.size() >= 2 * corners.size() && !corners.empty();
  if (colour || has_own) {
    for (std::size_t i = 0; i < face.size(); ++i) {
      if (face[i] == kNoVertex) continue;
      std::optional<std::array<float, 2>> own;
      if (has_own && std::isfinite(texcoords[2 * i]) && std::isfinite(texcoords[2 * i + 1])) {
        own = {static_cast<float>(texcoords[2 * i]) + 0.0F, static_cast<float>(1 - texcoords[2 * i + 1]) + 0.0F};
      }
      face[i] = copy_of(face[i], colour, own);
    }
  }
  if (part_.vertices.size() > 3 * kMaxTriangles) {
    return Failure{ExitStatus::input, fmt::format("has more than {} corners; simplify the model", 3 * kMaxTriangles)};
  }
  if (face.size() <= 3 || !exist) {
    for (std::size_t i = 2; i < face.size(); ++i) {
      part_.indices.insert(part_.indices.end(), {face[0], face[i - 1], face[i]});
    }
    return Done{};
  }
  std::vector<Vector> places;
  for (const std::uint32_t vertex : face) places.push_back(part_.positions[vertex]);
  for (const auto& triangle : triangulate(places)) {
    for (const std::uint32_t corner : triangle) part_.indices.push_back(face[corner]);
  }
  return Done{};
}

Result<Done> PlyReader::read_faces(const PlyElement& element) {
  const std::size_t corners = element.find({"vertex_indices", "vertex_index"});
  if (corners >= element.properties.size() || !element.properties[corners].is_list) {
    return unreadable_model("its faces have no list of vertices");
  }
  const std::size_t texcoords = element.find({"texcoord"});
  const bool has_own = texcoords < element.properties.size() && element.properties[texcoords].is_list;
  // Colours of vertices, where a file has both, are finer.
  const std::optional<ColourPlace> place = part_.has_colours ? std::nullopt : ColourPlace::find(element);
  if (place) part_.has_colours = true;
  if (has_own) has_texcoords_ = true;
  faces_ += element.count;
  return for_each(element, [&](const Row& row) {
    std::optional<std::array<std::uint8_t, 4>> colour;
    if (place) colour = place->of(row);
    return add_face(row[corners], has_own ? std::span<const double>(row[texcoords]) : std::span<const double>(),
                    colour);
  });
}

void PlyReader::add_triangle(const std::array<double, 3>& corners) {
  for (const double corner : corners) part_.indices.push_back(to_vertex(corner));
}

Result<Done> PlyReader::read_strips(const PlyElement& element) {
  const std::size_t corners = element.find({"vertex_indices", "vertex_index"});
  if (corners >= element.properties.size() || !element.properties[corners].is_list) {
    return unreadable_model("its strips have no list of vertices");
  }
  faces_ += element.count;
  return for_each(element, [&](const Row& row) -> Result<Done> {
    std::size_t first = 0;  // of the strip; a number below 0 ends one
    const std::vector<double>& strip = row[corners];
    for (std::size_t i = 0; i < strip.size(); ++i) {
      if (strip[i] < 0) first = i + 1;
      if (i < first + 2) continue;
      const bool is_turned = (i - first) % 2 == 1;
      add_triangle({strip[i - 2], strip[is_turned ? i : i - 1], strip[is_turned ? i - 1 : i]});
    }
    return Done{};
  });
}

Result<Done> PlyReader::read_edges(const PlyElement& element) {
  const std::size_t from = element.find({"vertex1"}), to = element.find({"vertex2"});
  const std::size_t count = element.properties.size();
  const bool has_ends =
      from < count && to < count && !element.properties[from].is_list && !element.properties[to].is_list;
  return for_each(element, [&](const Row& row) -> Result<Done> {
    if (!has_ends) return Done{};
    part_.segments.push_back(to_vertex(row[from][0]));
    part_.segments.push_back(to_vertex(row[to][0]));
    return Done{};
  });
}

Result<Done> PlyReader::read_all() {
  const auto vertices = std::ranges::find(header_.elements, "vertex", &PlyElement::name);
  if (vertices == header_.elements.end()) return unreadable_model("it has no vertices");
  // Faces refer to vertices: elements in front of these are read after them, from the file's begin.
  const PlyValues begin = values_;
  for (auto before = header_.elements.begin(); before != vertices; ++before) {
    if (const Result<Done> skipped = skip(*before); !skipped) return skipped.failure();
  }
  if (const Result<Done> read = read_vertices(*vertices); !read) return read.failure();
  const PlyValues behind_vertices = std::exchange(values_, begin);
  for (auto at = header_.elements.begin(); at != header_.elements.end(); ++at) {
    const PlyElement& element = *at;
    Result<Done> done = Done{};
    if (at == vertices) {
      values_ = behind_vertices;
    } else if (element.name == "face") {
      done = read_faces(element);
    } else if (element.name == "tristrips") {
      done = read_strips(element);
    } else if (element.name == "edge") {
      done = read_edges(element);
    } else {
      done = skip(element);
    }
    if (!done) return done.failure();
  }
  // A scanner's cloud of points.
  const bool is_cloud = faces_ == 0 && part_.segments.empty();
  for (std::uint32_t i = 0; is_cloud && i < vertices_; ++i) {
    part_.segments.insert(part_.segments.end(), {i, i});
  }
  if (too_large_ > 0 && part_.indices.empty()) {
    return Failure{ExitStatus::input,
                   fmt::format("has a face of more than {} corners: cut it into smaller ones", grouped(kMaxCorners))};
  }
  return Done{};
}

Result<SourceModel> PlyReader::model(const ReadPicture& read_picture, Texcoords texcoords) && {
  SourceModel model;
  SourceMaterial& material = model.materials.emplace_back();
  material.double_sided = true;  // the order of corners has no meaning in this format
  if (has_texcoords_ && !header_.texture.empty()) {
    Result<RgbImage> picture = read_picture(header_.texture);
    if (picture) {
      material.texture = 0;
      model.textures.push_back(std::move(*picture));
      model.texture_names.push_back(header_.texture);
    } else {
      model.warnings.push_back(fmt::format("texture '{}' {}; its surfaces are drawn without it",
                                           printable(header_.texture), picture.failure().message));
    }
  }
  part_.has_texcoords = has_texcoords_ && (texcoords == Texcoords::all || material.texture != kNoSourceTexture);
  MeshGroups groups(model);
  if (const Result<Done> added = groups.add(std::move(part_)); !added) return added.failure();
  if (const Result<Done> finished = groups.finish(); !finished) return finished.failure();
  if (too_large_ > 0) {
    model.warnings.push_back(
        fmt::format("{} of more than {} corners left out", counted(too_large_, "face"), grouped(kMaxCorners)));
  }
  return model;
}

}  // namespace

Result<SourceModel> read_ply(std::string_view file, const ReadPicture& read_picture, const Affine& turn,
                             Texcoords texcoords) {
  const Result<PlyHeader> header = read_ply_header(file);
  if (!header) return unreadable_model(header.failure().message);
  const std::string_view data = file.substr(header->bytes);
  PlyReader reader(data, *header, turn, Rows::follow_each_other);
  const Result<Done> read = reader.read_all();
  if (header->format == PlyFormat::text && !(read && reader.is_at_end())) {
    // Versions of MeshLab wrote more values behind a face than the header states.
    PlyReader of_lines(data, *header, turn, Rows::begin_lines);
    if (of_lines.read_all() && of_lines.is_at_end()) {
      Result<SourceModel> model = std::move(of_lines).model(read_picture, texcoords);
      if (model) model->warnings.emplace_back("values at the ends of lines left out: the header does not state them");
      return model;
    }
  }
  if (!read) return read.failure();
  return std::move(reader).model(read_picture, texcoords);
}

}  // namespace zstrip::sim
