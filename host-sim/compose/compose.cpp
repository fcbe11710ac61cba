// Composes: models once each, meshes once for each size that they are wanted in, materials once for each override.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <tuple>

#include "compose/composed_scene.hpp"
#include "compose/placed_model.hpp"
#include "image/decode.hpp"
#include "image/resample.hpp"
#include "import/meshlets.hpp"
#include "import/quantise.hpp"
#include "import/read_file.hpp"
#include "render/model_animation.hpp"
#include "zstrip/scene/validate.hpp"
#include "zstrip_scenes/presentation.hpp"

namespace zstrip::sim {
namespace {

constexpr double kTurntableSeconds = 4;  // of a scene that has nothing else to say how long it takes
constexpr std::size_t kMostInstances = 65535;

/// One instance of the scene, to be.
struct Placed {
  const FileInstance* file = nullptr;
  const PlacedModel* model = nullptr;
  const ModelPart* part = nullptr;
  std::size_t model_index = 0, part_index = 0;

  bool moves() const { return file->moves() || model->moves(*part); }
};

/// Where the scene file puts an instance at a time.
Affine placement_at(const FileInstance& instance, double seconds, double duration) {
  Placement placement = instance.placement;
  if (!instance.translation.times.empty()) placement.translation = sample(instance.translation, seconds);
  if (!instance.rotation.times.empty()) placement.rotation = sample(instance.rotation, seconds);
  if (!instance.scale.times.empty()) placement.scale = sample(instance.scale, seconds);
  const Affine turned = rotation(placement.rotation) * scaling(placement.scale);
  if (!instance.turntable) return translation(placement.translation) * turned;
  const double degrees = 360 * instance.turntable->turns * seconds / duration;
  return translation(placement.translation) * rotation(about_axis(instance.turntable->axis, degrees)) * turned;
}

bool even(const Vector& scale) { return scale[0] == scale[1] && scale[1] == scale[2]; }

/// Rounded to nearest; false if it leaves the renderer's range.
bool to_transform(const Affine& from, Transform& to) {
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 4; ++column) {
      const double limit = column == 3 ? 32767 : 255;
      if (!(std::abs(from.m[row][column]) <= limit)) return false;
      to.m[row][column] = to_fixed(from.m[row][column]);
    }
  }
  return true;
}

bool is_diagonal(const Affine& a) {
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      if (row != column && a.m[row][column] != 0) return false;
    }
  }
  return true;
}

/// Normals of a surface that is scaled: by the inverse, and as long as before.
std::vector<Normal> scaled_normals(std::span<const Normal> normals, const Vector& scale) {
  std::vector<Normal> result;
  for (const Normal& n : normals) {
    const Vector v{n.x / scale[0], n.y / scale[1], n.z / scale[2]};
    const double length = std::hypot(v[0], v[1], v[2]);
    const auto component = [&](std::size_t axis) {
      return static_cast<std::int8_t>(length > 0 ? std::lround(127 * v[axis] / length) : 0);  // 1.7
    };
    result.push_back({component(0), component(1), component(2), 0});
  }
  return result;
}

class Composer {
 public:
  explicit Composer(const SceneFile& file) : file_(file), composed_(std::make_unique<ComposedScene>()) {}

  Result<std::unique_ptr<const ComposedScene>> run() {
    for (const Result<Done>& done : {read_models(), place()}) {
      if (!done) return done.failure();
    }
    set_duration();
    if (const Result<Done> done = set_scale(); !done) return done.failure();
    for (const Placed& placed : placed_) {
      if (const Result<Done> done = add(placed); !done) return done.failure();
    }
    for (const FileEllipsoid& ellipsoid : file_.ellipsoids) {
      if (const Result<Done> done = add(ellipsoid); !done) return done.failure();
    }
    if (const Result<Done> done = add_lights(); !done) return done.failure();
    if (const Result<Done> done = add_fog(); !done) return done.failure();
    if (const Result<Done> done = animate(); !done) return done.failure();
    if (const Result<Done> done = check(); !done) return done.failure();
    return std::unique_ptr<const ComposedScene>(std::move(composed_));
  }

 private:
  std::filesystem::path beside(const std::filesystem::path& name) const { return file_.path.parent_path() / name; }

  Result<Done> read_models() {
    for (const FileModel& entry : file_.models) {
      if (!entry.built_in.empty()) {
        Result<PlacedModel> placed = place_built_in(entry, file_.path);
        if (!placed) return placed.failure();
        models_.push_back(std::move(*placed));
        continue;
      }
      Result<Model> model = import_model(beside(entry.file), entry.up);
      if (!model) return at_line(file_.path, entry.line, model.failure().message);
      composed_->models.push_back(std::move(*model));
      for (const std::string& warning : composed_->models.back().warnings) {
        composed_->warnings.push_back(fmt::format("model '{}': {}", entry.name, warning));
      }
      Result<PlacedModel> placed = place_model(entry, composed_->models.back(), file_.path);
      if (!placed) return placed.failure();
      models_.push_back(std::move(*placed));
    }
    return Done{};
  }

  /// Lists what will be instances, those of the static layer first.
  Result<Done> place() {
    for (const bool is_static : {true, false}) {
      for (const FileInstance& instance : file_.instances) {
        if (instance.is_static != is_static) continue;
        const auto entry = std::ranges::find(file_.models, instance.model, &FileModel::name);
        const auto index = static_cast<std::size_t>(entry - file_.models.begin());
        const PlacedModel& model = models_[index];
        for (std::size_t i = 0; i < model.parts.size(); ++i) {
          placed_.push_back({&instance, &model, &model.parts[i], index, i});
          if (Result<Done> checked = check_placed(placed_.back()); !checked) return checked;
        }
      }
      if (is_static) composed_->static_instances = placed_.size();
    }
    if (placed_.size() > kMostInstances) return at_line(file_.path, 1, "the scene has more than 65,535 instances");
    return Done{};
  }

  Result<Done> check_placed(const Placed& placed) const {
    const FileInstance& instance = *placed.file;
    const auto wrong = [&](const char* what) { return at_line(file_.path, instance.line, what); };
    if (instance.is_static && placed.model->moves(*placed.part)) {
      return wrong("what lies in the static layer cannot have an animation; its model has one");
    }
    if (even(instance.placement.scale)) return Done{};
    if (placed.model->moves(*placed.part)) return wrong("a model that has an animation can only be scaled evenly");
    if (!is_diagonal(placed.part->to_file)) return wrong("this built-in scene can only be scaled evenly");
    return Done{};
  }

  void set_duration() {
    double longest = 0;
    for (const FileInstance& instance : file_.instances) {
      for (const std::vector<double>& times :
           {instance.translation.times, instance.rotation.times, instance.scale.times}) {
        if (!times.empty()) longest = std::max(longest, times.back());
      }
    }
    for (const Placed& placed : placed_) {
      if (placed.model->moves(*placed.part)) longest = std::max(longest, placed.model->animation->duration);
    }
    duration_ = file_.duration.value_or(longest > 0 ? longest : kTurntableSeconds);
  }

  /// From object space to the scene file's coordinates.
  Affine placed_at(const Placed& placed, double seconds) const {
    return placement_at(*placed.file, seconds, duration_) * placed.model->placed(*placed.part, seconds);
  }

  /// The scene's units: everything within kComposedRadius, whenever it is looked at.
  Result<Done> set_scale() {
    constexpr int kLooks = 64;
    double radius = 0;
    for (const Placed& placed : placed_) {
      const std::vector<Vector> corners = corners_of(placed.part->mesh);
      for (int look = 0; look < (placed.moves() ? kLooks : 1); ++look) {
        const Affine at = placed_at(placed, duration_ * look / kLooks);
        for (const Vector& corner : corners) {
          const Vector p = at * corner;
          radius = std::max(radius, std::hypot(p[0], p[1], p[2]));
        }
      }
    }
    for (const FileEllipsoid& ellipsoid : file_.ellipsoids) {
      const Vector& at = ellipsoid.placement.translation;
      const Vector& radii = ellipsoid.placement.scale;
      radius = std::max(radius, std::hypot(at[0], at[1], at[2]) + std::max({radii[0], radii[1], radii[2]}));
    }
    if (!(radius > 0) || !std::isfinite(radius)) return at_line(file_.path, 1, "the scene is a single point");
    composed_->units.scale = kComposedRadius / radius;
    return Done{};
  }

  /// The size of a part in the scene, which goes into its mesh, so that what turns it has all its bits.
  Vector mesh_scale(const Placed& placed) {
    const Affine& to_file = placed.part->to_file;
    Vector scale = placed.file->placement.scale;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double own = is_diagonal(to_file) ? std::abs(to_file.m[axis][axis]) : 1;
      scale[axis] *= composed_->units.scale * own;
    }
    // A mesh that is there already and has nearly this size will do.
    const auto known = first_scales_.try_emplace({placed.model_index, placed.part_index}, scale).first->second;
    const double ratio = scale[0] / known[0];
    const bool similar = even(placed.file->placement.scale) && ratio > 1.0 / 16 && ratio < 16 &&
                         std::abs(scale[1] / known[1] - ratio) < 1e-9 * ratio &&
                         std::abs(scale[2] / known[2] - ratio) < 1e-9 * ratio;
    return similar ? known : scale;
  }

  std::uint16_t mesh_for(const Placed& placed, const Vector& scale) {
    const auto key = std::tuple(placed.model_index, placed.part_index, scale);
    const auto [at, is_new] = meshes_.try_emplace(key, static_cast<std::uint16_t>(composed_->meshes.size()));
    if (!is_new) return at->second;
    Mesh mesh = placed.part->mesh;
    std::size_t axis = 0;
    for (Fixed Vec3::*const member : {&Vec3::x, &Vec3::y, &Vec3::z}) {
      mesh.centre.*member = to_fixed(from_fixed(mesh.centre.*member) * scale[axis]);
      mesh.half_extent.*member = to_fixed(from_fixed(mesh.half_extent.*member) * scale[axis]);
      ++axis;
    }
    if (!even(placed.file->placement.scale)) {
      MeshData& own = composed_->scaled.emplace_back();
      own.normals = scaled_normals(mesh.normals, placed.file->placement.scale);
      own.meshlets.assign(mesh.meshlets.begin(), mesh.meshlets.end());
      for (Meshlet& meshlet : own.meshlets) {
        set_bounds(meshlet, mesh.positions.subspan(meshlet.first_vertex, meshlet.vertex_count), mesh.half_extent);
      }
      mesh.normals = own.normals;
      mesh.meshlets = own.meshlets;
    }
    composed_->meshes.push_back(mesh);
    return at->second;
  }

  /// What replaces the part's material; null if nothing does.
  const FileMaterial* override_of(const Placed& placed) const {
    std::string name = placed.file->material;
    const std::string& own = placed.model->material_names[placed.part->material];
    for (const auto& [replaced, by] : placed.file->materials) {
      if (replaced == own) name = by;
    }
    const auto at = std::ranges::find(file_.materials, name, &FileMaterial::name);
    return name.empty() ? nullptr : &*at;
  }

  Result<std::uint16_t> own_texture(const FileMaterial& material) {
    const std::filesystem::path path = beside(*material.texture);
    const auto [at, is_new] = own_textures_.try_emplace(path, static_cast<std::uint16_t>(composed_->textures.size()));
    if (!is_new) return at->second;
    const auto wrong = [&](const std::string& what) {
      return at_line(file_.path, material.texture_line, fmt::format("texture '{}' {}", path.string(), what));
    };
    const Result<std::vector<std::uint8_t>> bytes = read_file(path);
    if (!bytes) return wrong(bytes.failure().message);
    Result<RgbImage> image = decode_image(*bytes);
    if (!image) return wrong(image.failure().message);
    const RgbImage fitted = resample_to_power_of_two(std::move(*image));
    composed_->texels.push_back(to_rgb565(fitted));
    composed_->textures.push_back({.texels = composed_->texels.back(),
                                   .log2_width = static_cast<std::uint8_t>(log2_of(fitted.width)),
                                   .log2_height = static_cast<std::uint8_t>(log2_of(fitted.height))});
    return at->second;
  }

  std::uint16_t model_texture(const Placed& placed, std::uint16_t texture) {
    const auto key = std::pair(placed.model_index, texture);
    const auto [at, is_new] = textures_.try_emplace(key, static_cast<std::uint16_t>(composed_->textures.size()));
    if (is_new) composed_->textures.push_back(placed.model->textures[texture]);
    return at->second;
  }

  static Material replaced(Material material, const FileMaterial& by) {
    material.colour = by.colour.value_or(material.colour);
    material.colour.a = by.alpha.value_or(material.colour.a);
    material.lit = by.lit.value_or(material.lit);
    material.smooth = by.smooth.value_or(material.smooth);
    material.double_sided = by.double_sided.value_or(material.double_sided);
    material.depth_test = by.depth_test.value_or(material.depth_test);
    material.depth_write = by.depth_write.value_or(material.depth_write);
    material.depth_bias = by.depth_bias.value_or(material.depth_bias);
    return material;
  }

  Failure too_many_finishes(const FileMaterial& material) const {
    return at_line(file_.path, material.line, "the scene has more than 255 finishes of materials");
  }

  /// Gives the material what few have, if it has any of it: its model's own, with what `by` replaces. False if the
  /// table is full.
  bool set_finish(Material& material, const Finish& own, const FileMaterial& by) {
    const bool has_own = material.finish != kNoFinish;
    const bool given = by.emissive || by.specular || by.shininess || by.alpha_mode || by.alpha_cutoff || by.filter;
    if (!has_own && !given) return true;
    if (composed_->finishes.size() >= kNoFinish) return false;
    material.finish = static_cast<std::uint8_t>(composed_->finishes.size());
    composed_->finishes.push_back({.emissive = by.emissive.value_or(own.emissive),
                                   .specular = by.specular.value_or(own.specular),
                                   .shininess = by.shininess.value_or(own.shininess),
                                   .alpha_mode = by.alpha_mode.value_or(own.alpha_mode),
                                   .alpha_cutoff = by.alpha_cutoff.value_or(own.alpha_cutoff),
                                   .filter = by.filter.value_or(own.filter)});
    return true;
  }

  std::string line_of(int line) const { return fmt::format("{} line {}", file_.path.filename().string(), line); }

  /// Of an ellipsoid, which has no model's material to begin with.
  Result<std::uint16_t> material_for(const FileMaterial& own) {
    constexpr auto kNoModel = static_cast<std::size_t>(-1);
    const auto key = std::tuple(kNoModel, std::uint16_t{0}, &own);
    const auto [at, is_new] = materials_.try_emplace(key, static_cast<std::uint16_t>(composed_->materials.size()));
    if (!is_new) return at->second;
    Material material = replaced({}, own);
    if (!set_finish(material, Finish{}, own)) return too_many_finishes(own);
    if (own.texture) {
      const Result<std::uint16_t> texture = own_texture(own);
      if (!texture) return texture.failure();
      material.texture = *texture;
    }
    composed_->materials.push_back(material);
    composed_->material_names.push_back(own.name);
    composed_->material_origins.push_back(line_of(own.line));
    return at->second;
  }

  Result<Done> add(const FileEllipsoid& ellipsoid) {
    const auto own = std::ranges::find(file_.materials, ellipsoid.material, &FileMaterial::name);
    const Result<std::uint16_t> material = material_for(*own);
    if (!material) return material.failure();
    const double units = composed_->units.scale;
    Quadric quadric{.material = *material};
    if (!to_transform(scaling({units, units, units}) * to_affine(ellipsoid.placement), quadric.transform)) {
      return at_line(file_.path, ellipsoid.line, "is too far away, or too large or small beside the others");
    }
    composed_->quadrics.push_back(quadric);
    return Done{};
  }

  Result<Done> add_fog() {
    if (!file_.fog) return Done{};
    const FileFog& from = *file_.fog;
    Fog fog{.colour = from.colour, .mode = from.mode};
    constexpr double kMost = 32767;
    const double start = from.start * composed_->units.scale, end = from.end * composed_->units.scale;
    const double density = from.density / composed_->units.scale;
    if (!(end <= kMost && density <= kMost)) {
      return at_line(file_.path, from.line, "[fog]: the lengths are too great for this scene");
    }
    if (from.mode == FogMode::linear) {
      fog.start = to_fixed(start);
      fog.end = std::max(to_fixed(end), fog.start + 1);
    } else {
      fog.density = to_fixed(density);
    }
    composed_->fog = fog;
    composed_->fog_origin = line_of(from.line);
    return Done{};
  }

  Result<std::uint16_t> material_for(const Placed& placed) {
    const FileMaterial* const other = override_of(placed);
    const auto key = std::tuple(placed.model_index, placed.part->material, other);
    const auto [at, is_new] = materials_.try_emplace(key, static_cast<std::uint16_t>(composed_->materials.size()));
    if (!is_new) return at->second;
    Material material = placed.model->materials[placed.part->material];
    std::string name = placed.model->material_names[placed.part->material];
    std::string origin = fmt::format("model '{}'", placed.file->model);
    const Finish finish =
        material.finish < placed.model->finishes.size() ? placed.model->finishes[material.finish] : Finish{};
    if (material.finish != kNoFinish && other == nullptr && !set_finish(material, finish, FileMaterial{})) {
      return at_line(file_.path, placed.file->line, "the scene has more than 255 finishes of materials");
    }
    if (other != nullptr && other->texture) {
      const Result<std::uint16_t> texture = own_texture(*other);
      if (!texture) return texture.failure();
      material.texture = *texture;
    } else if (material.texture != kNoTexture) {
      material.texture = model_texture(placed, material.texture);
    }
    if (other != nullptr) {
      material = replaced(material, *other);
      if (!set_finish(material, finish, *other)) return too_many_finishes(*other);
      name = other->name;
      origin = line_of(other->line);
    }
    composed_->materials.push_back(material);
    composed_->material_names.push_back(name);
    composed_->material_origins.push_back(origin);
    return at->second;
  }

  Result<Done> add(const Placed& placed) {
    const FileMaterial* const other = override_of(placed);
    if (other != nullptr && other->texture && placed.part->mesh.texcoords.empty()) {
      return at_line(file_.path, other->texture_line,
                     fmt::format("material '{}' has a texture, but the model '{}' has no texture coordinates for it",
                                 other->name, placed.file->model));
    }
    const Vector scale = mesh_scale(placed);
    const Affine unscaled = scaling({1 / scale[0], 1 / scale[1], 1 / scale[2]});
    const Result<std::uint16_t> material = material_for(placed);
    if (!material) return material.failure();
    Instance instance{.mesh = mesh_for(placed, scale), .material = *material};
    const double units = composed_->units.scale;
    const auto at = [this, placed, unscaled, units](double seconds) {
      return scaling({units, units, units}) * placed_at(placed, seconds) * unscaled;
    };
    if (!to_transform(at(0), instance.transform)) {
      return at_line(file_.path, placed.file->line, "is too far away, or too large or small beside the others");
    }
    if (placed.moves()) {
      motions_.push_back({.instance = static_cast<std::uint16_t>(composed_->instances.size()),
                          .at = at,
                          .corners = corners_of(composed_->meshes[instance.mesh])});
    }
    composed_->instances.push_back(instance);
    return Done{};
  }

  Result<Done> add_lights() {
    for (const FileLight& light : file_.lights) {
      const double length = std::hypot(light.direction[0], light.direction[1], light.direction[2]);
      const auto component = [&](std::size_t axis, double unit) {
        return static_cast<std::int16_t>(std::lround(unit * light.direction[axis] / length));  // 1.15
      };
      if (!light.punctual) {  // towards it
        composed_->lights.push_back({component(0, -32767), component(1, -32767), component(2, -32767), light.colour});
        continue;
      }
      const double units = composed_->units.scale;
      PunctualLight to{.type = *light.punctual, .colour = light.colour};
      const auto set = [](double value, Fixed& fixed) {
        const bool fits = std::abs(value) <= 32767;
        if (fits) fixed = to_fixed(value);
        return fits;
      };
      if (!set(light.position[0] * units, to.position.x) || !set(light.position[1] * units, to.position.y) ||
          !set(light.position[2] * units, to.position.z) || !set(light.intensity * units * units, to.intensity) ||
          !set(light.range * units, to.range)) {
        return at_line(file_.path, light.line, "[[light]] is too far away or too strong for this scene");
      }
      const auto cosine = [](double degrees) {
        return static_cast<std::int16_t>(std::lround(32767 * std::cos(degrees * std::numbers::pi / 180)));  // 1.15
      };
      to.x = component(0, 32767), to.y = component(1, 32767), to.z = component(2, 32767);
      to.cosine_inner = cosine(light.inner), to.cosine_outer = cosine(light.outer);
      if (to.cosine_inner <= to.cosine_outer) to.cosine_inner = static_cast<std::int16_t>(to.cosine_outer + 1);
      composed_->punctual_lights.push_back(to);
    }
    if (file_.lights.empty()) composed_->lights.assign(std::begin(scenes::kKeyLight), std::end(scenes::kKeyLight));
    composed_->ambient = file_.ambient.value_or(scenes::kAmbient);
    composed_->background = file_.background.value_or(Colour{0, 0, 0, 255});
    return Done{};
  }

  std::set<double> all_key_times() const {
    constexpr std::size_t kMost = 10000;
    std::set<double> times;
    for (const FileInstance& instance : file_.instances) {
      for (const std::vector<double>& own :
           {instance.translation.times, instance.rotation.times, instance.scale.times}) {
        times.insert(own.begin(), own.end());
      }
    }
    for (const PlacedModel& model : models_) {
      if (model.animation == nullptr) continue;
      const std::set<double> own = key_times(*model.animation);
      for (double begin = 0; begin < duration_ && times.size() < kMost; begin += model.animation->duration) {
        for (const double time : own) times.insert(begin + time);
      }
    }
    return times;
  }

  Result<Done> animate() {
    if (motions_.empty()) return Done{};
    Result<FittedAnimation> fitted =
        fit_animation(motions_, duration_, all_key_times(), kAnimationTolerance * kComposedRadius);
    if (!fitted) return at_line(file_.path, 1, "the animation " + fitted.failure().message);
    composed_->animation = std::move(*fitted);
    return Done{};
  }

  Result<Done> check() const {
    const Status status = validate(composed_->scene());
    if (status) return Done{};
    if (status.error == Error::instance && status.needed < placed_.size()) {
      const FileMaterial* const other = override_of(placed_[status.needed]);
      if (other != nullptr && other->texture) {
        return at_line(file_.path, other->texture_line,
                       "the model repeats this texture too often for its size; make the texture smaller");
      }
    }
    return Failure{ExitStatus::internal, fmt::format("'{}' became a scene that the renderer refuses: {} (number {})",
                                                     file_.path.string(), message(status.error), status.needed)};
  }

  const SceneFile& file_;
  std::unique_ptr<ComposedScene> composed_;
  std::vector<PlacedModel> models_;  ///< of file_.models
  std::vector<Placed> placed_;
  std::vector<InstanceMotion> motions_;
  double duration_ = 0;
  std::map<std::pair<std::size_t, std::size_t>, Vector> first_scales_;
  std::map<std::tuple<std::size_t, std::size_t, Vector>, std::uint16_t> meshes_;
  std::map<std::pair<std::size_t, std::uint16_t>, std::uint16_t> textures_;
  std::map<std::filesystem::path, std::uint16_t> own_textures_;
  std::map<std::tuple<std::size_t, std::uint16_t, const FileMaterial*>, std::uint16_t> materials_;
};

}  // namespace

Result<std::unique_ptr<const ComposedScene>> compose(const SceneFile& file) { return Composer(file).run(); }

}  // namespace zstrip::sim
