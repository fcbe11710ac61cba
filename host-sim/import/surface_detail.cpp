// Lighting and shade of normal and occlusion maps, painted into texels.
#include "import/surface_detail.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "image/resample.hpp"
#include "motion/affine.hpp"

namespace zstrip::sim {
namespace {

/// Returns a * x + b * y + c * z.
Vector sum(const Vector& a, double x, const Vector& b, double y, const Vector& c, double z) {
  Vector s;
  for (std::size_t i = 0; i < 3; ++i) s[i] = a[i] * x + b[i] * y + c[i] * z;
  return s;
}

struct Beam {
  Vector towards;
  double strength;
};

/// The light of a model without colours: all of it together is at most 1.
struct Lighting {
  double ambient;
  std::vector<Beam> beams;

  /// Returns the light on a surface. `seen`: the share of light from all sides that reaches it.
  double on(const Vector& normal, double seen) const {
    double light = ambient * seen;
    for (const Beam& beam : beams) light += beam.strength * std::max(scalar_product(normal, beam.towards), 0.0);
    return light;
  }
};

/// This light is the one by which look_for_people() shows a model without lights.
constexpr double kAmbient = 104.0 / 255;
const Beam kKeyLight{{0.1 / 1.005, 0.8 / 1.005, 0.6 / 1.005}, 1 - kAmbient};

Lighting light_of(const SourceModel& model) {
  Lighting light{kAmbient, {}};
  for (const SourceLight& each : model.lights) {
    const double strength = *std::ranges::max_element(each.colour);
    if (each.type == SourceLightType::directional && strength > 0) light.beams.push_back({each.towards, strength});
  }
  std::ranges::stable_sort(light.beams, std::greater{}, &Beam::strength);
  if (light.beams.size() > kMaxLights) light.beams.resize(kMaxLights);
  if (light.beams.empty()) light.beams.push_back(kKeyLight);
  const double brightest = light.beams.front().strength;
  for (Beam& beam : light.beams) beam.strength *= (1 - kAmbient) / brightest;
  return light;
}

/// Returns the mean of the texels of a map, 0..255, that lie on the texel (x, y) of a picture of `width` * `height`.
Vector mean_at(const RgbImage& map, std::uint32_t x, std::uint32_t y, std::uint32_t width, std::uint32_t height) {
  const auto first = [](std::uint32_t i, std::uint32_t to, std::uint32_t from) {
    return static_cast<std::uint32_t>(std::uint64_t{i} * to / from);
  };
  const std::uint32_t left = first(x, map.width, width), top = first(y, map.height, height);
  const std::uint32_t right = std::max(first(x + 1, map.width, width), left + 1);
  const std::uint32_t bottom = std::max(first(y + 1, map.height, height), top + 1);
  Vector mean{};
  for (std::uint32_t v = top; v < bottom; ++v) {
    for (std::uint32_t u = left; u < right; ++u) {
      for (std::size_t c = 0; c < 3; ++c) mean[c] += map.pixel(u, v)[c];
    }
  }
  for (double& channel : mean) channel /= static_cast<double>(right - left) * (bottom - top);
  return mean;
}

/// The maps of a material at one texel of its base texture.
struct Detail {
  Vector normal{0, 0, 1};  ///< along the texture's u, against its v, and away from the surface
  double seen = 1;         ///< the share of light from all sides
};

/// The maps of a material, in texels of its base texture.
std::vector<Detail> details_of(const SourceModel& model, const SourceMaterial& material) {
  const RgbImage& base = model.textures[material.texture];
  std::vector<Detail> details(std::size_t{base.width} * base.height);
  for (std::uint32_t y = 0; y < base.height; ++y) {
    for (std::uint32_t x = 0; x < base.width; ++x) {
      Detail& detail = details[std::size_t{y} * base.width + x];
      if (material.normal_texture != kNoSourceTexture) {
        const Vector c = mean_at(model.textures[material.normal_texture], x, y, base.width, base.height);
        const auto component = [&](std::size_t i) { return c[i] / 127.5 - 1; };
        const double scale = material.normal_scale;
        detail.normal = unit(Vector{component(0) * scale, component(1) * scale, component(2)});
      }
      if (material.occlusion_texture != kNoSourceTexture) {
        const Vector c = mean_at(model.textures[material.occlusion_texture], x, y, base.width, base.height);
        detail.seen = 1 - material.occlusion_strength * (1 - c[0] / 255);
      }
    }
  }
  return details;
}

/// A place of a texture, in texels.
struct TexelPlace {
  double u, v;
};

/// A triangle with a place for each corner.
struct LaidTriangle {
  std::array<TexelPlace, 3> at;
  std::array<Vector, 3> normals;
  Vector along_u, against_v;  ///< unit vectors along the surface
};

std::optional<LaidTriangle> lay(const SourceMesh& mesh, const std::uint32_t* corners, const RgbImage& base) {
  LaidTriangle laid{};
  std::array<Vector, 3> positions;
  for (std::size_t i = 0; i < 3; ++i) {
    const SourceVertex& vertex = mesh.vertices[corners[i]];
    laid.at[i] = {double{vertex.texcoord[0]} * base.width, double{vertex.texcoord[1]} * base.height};
    positions[i] = {vertex.position[0], vertex.position[1], vertex.position[2]};
  }
  const Vector p = sum(positions[1], 1, positions[0], -1, {}, 0);
  const Vector q = sum(positions[2], 1, positions[0], -1, {}, 0);
  const double u1 = laid.at[1].u - laid.at[0].u, v1 = laid.at[1].v - laid.at[0].v;
  const double u2 = laid.at[2].u - laid.at[0].u, v2 = laid.at[2].v - laid.at[0].v;
  const double area = u1 * v2 - u2 * v1;
  const Vector face = unit(vector_product(p, q));
  if (!(std::abs(area) > 1e-9) || !std::isfinite(area)) return std::nullopt;
  laid.along_u = unit(sum(p, v2 / area, q, -v1 / area, {}, 0));
  laid.against_v = unit(sum(p, u2 / area, q, -u1 / area, {}, 0));
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& n = mesh.vertices[corners[i]].normal;
    laid.normals[i] = n == std::array<float, 3>{} ? face : Vector{n[0], n[1], n[2]};
  }
  return laid;
}

/// The sums for one texture. Triangles are added one by one.
class Painting {
 public:
  Painting(const RgbImage& base, const Lighting& light)
      : light_(light), width_(base.width), height_(base.height), sums_(std::size_t{width_} * height_) {}

  /// Adds what a triangle shows of the texture. `details`: empty for a material without maps, else one a texel.
  /// `visits` decreases by the texels that were looked at; with too few left nothing is added.
  void add(const LaidTriangle& laid, std::span<const Detail> details, std::int64_t& visits) {
    const auto [left, right] = std::minmax({laid.at[0].u, laid.at[1].u, laid.at[2].u});
    const auto [top, bottom] = std::minmax({laid.at[0].v, laid.at[1].v, laid.at[2].v});
    if (!(std::abs(left) < kFar && std::abs(right) < kFar && std::abs(top) < kFar && std::abs(bottom) < kFar)) return;
    // A triangle that repeats the texture shows every texel of it, each at several places.
    const bool all = right - left > width_ || bottom - top > height_;
    const auto whole = [](double value) { return static_cast<std::int64_t>(std::floor(value)); };
    const std::int64_t first_x = all ? 0 : whole(left), end_x = all ? width_ : whole(right) + 1;
    const std::int64_t first_y = all ? 0 : whole(top), end_y = all ? height_ : whole(bottom) + 1;
    visits -= (end_x - first_x) * (end_y - first_y);
    if (visits < 0) return;
    for (std::int64_t y = first_y; y < end_y; ++y) {
      for (std::int64_t x = first_x; x < end_x; ++x) {
        std::array<double, 3> weights{1.0 / 3, 1.0 / 3, 1.0 / 3};
        if (!all && !weights_at(laid.at, {static_cast<double>(x) + 0.5, static_cast<double>(y) + 0.5}, weights))
          continue;
        add_texel(laid, weights, index(x, y), details);
      }
    }
  }

  /// Multiplies the texels. Returns true if one of them changes.
  bool paint(RgbImage& base) const {
    bool changed = false;
    for (std::size_t i = 0; i < sums_.size(); ++i) {
      const RatioSum sum = sums_[i].count > 0 ? sums_[i] : around(i);
      if (sum.count == 0) continue;
      const double ratio = std::clamp(sum.ratios / sum.count, kMinRatio, kMaxRatio);
      for (std::size_t c = 0; c < 3; ++c) {
        std::uint8_t& channel = base.rgb[3 * i + c];
        const auto painted = static_cast<std::uint8_t>(std::min(std::lround(channel * ratio), 255L));
        changed = changed || painted != channel;
        channel = painted;
      }
    }
    return changed;
  }

 private:
  struct RatioSum {
    double ratios = 0;
    std::uint32_t count = 0;
  };
  static constexpr double kFar = 1e9;                        // texels, which whole numbers hold
  static constexpr double kMinRatio = 0.5, kMaxRatio = 1.5;  // of a texel: beyond these a light that moves looks wrong

  /// Repeats the texture.
  std::size_t index(std::int64_t x, std::int64_t y) const {
    const auto within = [](std::int64_t i, std::int64_t side) {
      return static_cast<std::size_t>((i % side + side) % side);
    };
    return within(y, height_) * width_ + within(x, width_);
  }

  /// Sets the weights of the corners at a place. Returns false if it lies outside of the triangle.
  static bool weights_at(const std::array<TexelPlace, 3>& at, const TexelPlace& place, std::array<double, 3>& weights) {
    const auto area = [](const TexelPlace& a, const TexelPlace& b, const TexelPlace& c) {
      return (b.u - a.u) * (c.v - a.v) - (c.u - a.u) * (b.v - a.v);
    };
    const double whole = area(at[0], at[1], at[2]);
    weights = {area(place, at[1], at[2]) / whole, area(at[0], place, at[2]) / whole, area(at[0], at[1], place) / whole};
    return std::ranges::all_of(weights, [](double weight) { return weight >= 0; });
  }

  void add_texel(const LaidTriangle& laid, const std::array<double, 3>& weights, std::size_t texel,
                 std::span<const Detail> details) {
    RatioSum& sum_here = sums_[texel];
    ++sum_here.count;
    sum_here.ratios += 1;
    if (details.empty()) return;
    const Vector normal =
        unit(sum(laid.normals[0], weights[0], laid.normals[1], weights[1], laid.normals[2], weights[2]));
    const Detail& detail = details[texel];
    const Vector bent = sum(laid.along_u, detail.normal[0], laid.against_v, detail.normal[1], normal, detail.normal[2]);
    sum_here.ratios += light_.on(unit(bent), detail.seen) / light_.on(normal, 1) - 1;
  }

  /// Returns the sum over the texel's neighbours. Triangles show texels whose centre lies outside of them.
  RatioSum around(std::size_t texel) const {
    RatioSum sum_around;
    const auto x = static_cast<std::int64_t>(texel % width_), y = static_cast<std::int64_t>(texel / width_);
    for (std::int64_t dy = -1; dy <= 1; ++dy) {
      for (std::int64_t dx = -1; dx <= 1; ++dx) {
        const RatioSum& neighbour = sums_[index(x + dx, y + dy)];
        sum_around.ratios += neighbour.ratios;
        sum_around.count += neighbour.count;
      }
    }
    return sum_around;
  }

  const Lighting& light_;
  std::uint32_t width_, height_;
  std::vector<RatioSum> sums_;
};

bool has_detail(const SourceMaterial& material) {
  return material.lit && material.texture != kNoSourceTexture &&
         (material.normal_texture != kNoSourceTexture || material.occlusion_texture != kNoSourceTexture);
}

/// Empties the maps that are nothing else: later steps look at every texture.
void remove_maps(SourceModel& model) {
  std::vector<bool> shown(model.textures.size());
  for (const SourceMaterial& material : model.materials) {
    if (material.texture != kNoSourceTexture) shown[material.texture] = true;
    if (material.emissive_texture != kNoSourceTexture) shown[material.emissive_texture] = true;
  }
  for (SourceMaterial& material : model.materials) {
    for (std::uint32_t* const map : {&material.normal_texture, &material.occlusion_texture}) {
      const std::uint32_t texture = std::exchange(*map, kNoSourceTexture);
      if (texture != kNoSourceTexture && !shown[texture]) model.textures[texture] = {1, 1, {0, 0, 0}};
    }
  }
}

}  // namespace

std::size_t paint_surface_detail(SourceModel& model) {
  const Lighting light = light_of(model);
  std::set<std::uint32_t> textures;
  for (const SourceMaterial& material : model.materials) {
    if (has_detail(material)) textures.insert(material.texture);
  }
  std::int64_t visits = std::int64_t{1} << 26;  // texels of triangles: some seconds
  std::size_t changed = 0;
  // One texture and one material at a time, in the size that the texture will have: a texel takes 48 bytes.
  for (const std::uint32_t texture : textures) {
    RgbImage& base = model.textures[texture];
    base = resample_to_power_of_two(std::move(base));
    Painting painting(base, light);
    for (std::size_t i = 0; i < model.materials.size(); ++i) {
      const SourceMaterial& material = model.materials[i];
      if (material.texture != texture) continue;
      const std::vector<Detail> details = has_detail(material) ? details_of(model, material) : std::vector<Detail>();
      for (const SourceMesh& mesh : model.meshes) {
        if (mesh.material != i || !mesh.has_texcoords) continue;
        for (std::size_t corner = 0; corner + 2 < mesh.indices.size(); corner += 3) {
          const auto laid = lay(mesh, &mesh.indices[corner], base);
          if (laid) painting.add(*laid, details, visits);
        }
      }
    }
    changed += painting.paint(base) ? 1U : 0U;
  }
  remove_maps(model);
  return changed;
}

}  // namespace zstrip::sim
