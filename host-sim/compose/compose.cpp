// Composes a scene from the parts that a scene file names: the order of the steps, instances, ellipsoids and lines.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <iterator>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "compose/bent_model.hpp"
#include "compose/composed_csg.hpp"
#include "compose/composed_lights.hpp"
#include "compose/composed_lines.hpp"
#include "compose/composed_materials.hpp"
#include "compose/composed_meshes.hpp"
#include "compose/composed_overlay.hpp"
#include "compose/composed_scene.hpp"
#include "compose/placed_part.hpp"
#include "compose/timeline.hpp"
#include "import/quantise.hpp"
#include "render/model_animation.hpp"
#include "zstrip/scene/validate.hpp"

namespace zstrip::sim {
namespace {

constexpr std::size_t kMaxSceneInstances = 65535, kMaxOutlines = 255;

/// Returns the corners of the box that holds a mesh that bends in every pose.
std::vector<Vector> corners_of_poses(const Mesh& mesh) {
  const Vector centre{from_fixed(mesh.centre.x), from_fixed(mesh.centre.y), from_fixed(mesh.centre.z)};
  const Vector half{from_fixed(mesh.half_extent.x), from_fixed(mesh.half_extent.y), from_fixed(mesh.half_extent.z)};
  return corners_of_box({centre[0] - half[0], centre[1] - half[1], centre[2] - half[2]},
                        {centre[0] + half[0], centre[1] + half[1], centre[2] + half[2]});
}

/// Rounds to nearest; returns false if the result is out of the renderer's range.
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

/// Returns the largest distance from the scene's origin that a billboard can reach in any orientation.
double radius_of_billboard(const Affine& at, std::span<const Vector> corners) {
  const Vector middle = at * Vector{0, 0, 0};
  double reach = 0;
  for (const Vector& corner : corners) {
    const Vector p = at * corner;
    reach = std::max(reach, std::hypot(p[0] - middle[0], p[1] - middle[1], p[2] - middle[2]));
  }
  return std::hypot(middle[0], middle[1], middle[2]) + reach;
}

class Composer {
 public:
  explicit Composer(const SceneFile& file)
      : file_(file), composed_(std::make_unique<ComposedScene>()), meshes_(*composed_), materials_(file, *composed_) {}

  Result<std::unique_ptr<const ComposedScene>> run() {
    if (const Result<Done> done = read_models(); !done) return done.failure();
    if (const Result<Done> done = place(); !done) return done.failure();
    duration_ = duration_of(file_, placed_);
    if (const Result<Done> done = set_scale(); !done) return done.failure();
    for (const PlacedPart& placed : placed_) {
      if (const Result<Done> done = add(placed); !done) return done.failure();
    }
    for (const FileEllipsoid& ellipsoid : file_.ellipsoids) {
      if (const Result<Done> done = add(ellipsoid); !done) return done.failure();
    }
    for (const auto& [segments, placed] : model_lines_) {
      if (const Result<Done> done = add(segments, placed); !done) return done.failure();
    }
    for (const FileLines& lines : file_.lines) {
      if (const Result<Done> done = add(lines); !done) return done.failure();
    }
    if (const Result<Done> done = add_lights(file_, *composed_); !done) return done.failure();
    if (const Result<Done> done = add_fog(file_, *composed_); !done) return done.failure();
    if (const Result<Done> done = add_products(file_, placed_, *composed_); !done) return done.failure();
    if (const Result<Done> done = add_overlay(file_, *composed_); !done) return done.failure();
    leave_out_unread_normals(*composed_);
    if (const Result<Done> done = animate(); !done) return done.failure();
    if (bent_) {
      const Result<Done> done = bend(file_, file_.models[*bent_], models_[*bent_], placed_, duration_, *composed_);
      if (!done) return done.failure();
    }
    if (const Result<Done> done = check(); !done) return done.failure();
    return std::unique_ptr<const ComposedScene>(std::move(composed_));
  }

 private:
  Result<Done> read_models() {
    for (const FileModel& entry : file_.models) {
      if (!entry.built_in.empty()) {
        Result<PlacedModel> placed = place_built_in(entry, file_.path);
        if (!placed) return placed.failure();
        models_.push_back(std::move(*placed));
        continue;
      }
      const Texcoords texcoords = materials_.may_texture(entry.name) ? Texcoords::all : Texcoords::of_textures;
      Result<Model> model =
          import_model(file_.beside(entry.file), entry.up, texcoords, BackFaces::as_front, {}, entry.reduction);
      if (!model) return at_line(file_.path, entry.file_line, model.failure().message);
      composed_->models.push_back(std::move(*model));
      for (const std::string& warning : composed_->models.back().warnings) {
        composed_->warnings.push_back(fmt::format("model '{}': {}", entry.name, warning));
      }
      if (const Result<Done> joined = join_clips(entry, composed_->models.back(), file_.path); !joined) {
        return joined.failure();
      }
      Result<PlacedModel> placed = place_model(entry, composed_->models.back(), file_.path);
      if (!placed) return placed.failure();
      models_.push_back(std::move(*placed));
      choose_bent(entry);
    }
    return Done{};
  }

  /// The first model that is placed and bends keeps its skins and morph targets; a scene has those of one model.
  void choose_bent(const FileModel& entry) {
    PlacedModel& placed = models_.back();
    if (!placed.bends() ||
        std::ranges::find(file_.instances, entry.name, &FileInstance::model) == file_.instances.end())
      return;
    if (!bent_) {
      bent_ = models_.size() - 1;
      return;
    }
    for (ModelPart& part : placed.parts) part.skin = nullptr, part.morph = nullptr;
    composed_->warnings.push_back(
        fmt::format("model '{}': it does not bend, because a scene bends only one model, '{}'", entry.name,
                    file_.models[*bent_].name));
  }

  /// Lists the instances to be, those of the static layer first.
  Result<Done> place() {
    for (const bool is_static : {true, false}) {
      for (const FileInstance& instance : file_.instances) {
        if (instance.is_static != is_static) continue;
        const auto entry = std::ranges::find(file_.models, instance.model, &FileModel::name);
        const auto index = static_cast<std::size_t>(entry - file_.models.begin());
        const PlacedModel& model = models_[index];
        if (Result<Done> checked = check_materials(instance, model); !checked) return checked;
        for (std::size_t i = 0; i < model.parts.size(); ++i) {
          placed_.push_back({&instance, &model, &model.parts[i], index, i});
          if (Result<Done> checked = check_placed(placed_.back(), file_.path); !checked) return checked;
          if (instance.billboard != Billboard::none) {
            placed_.back().part = &billboard_parts_.emplace_back(around_origin(model.parts[i]));
          }
        }
        if (Result<Done> done = place_lines(instance, model, index); !done) return done;
      }
      if (is_static) composed_->static_instances = placed_.size();
    }
    for (const FileLines& lines : file_.lines) {
      if (lines.model.empty()) continue;
      if (const Result<Done> done = place(lines); !done) return done.failure();
    }
    const auto outlines =
        std::ranges::count_if(placed_, [](const PlacedPart& p) { return p.file->outline.has_value(); });
    if (placed_.size() + static_cast<std::size_t>(outlines) + placed_lines_.size() + model_lines_.size() +
            file_.lines.size() >
        kMaxSceneInstances) {
      return at_line(file_.path, 1, "the scene has more than 65,535 instances, outlines, lines and points");
    }
    return Done{};
  }

  Result<Done> check_materials(const FileInstance& instance, const PlacedModel& model) const {
    for (const auto& [own, other] : instance.materials) {
      if (std::ranges::find(model.material_names, own) != model.material_names.end()) continue;
      std::vector<std::string> names;
      std::ranges::copy_if(model.material_names, std::back_inserter(names),
                           [](const auto& name) { return !name.empty(); });
      const std::string near = nearest(own, names);
      return at_line(
          file_.path, instance.line,
          fmt::format("[[instance]]: 'materials' names no material '{}' of the model '{}'; {}", own, instance.model,
                      !near.empty()   ? fmt::format("did you mean '{}'?", near)
                      : names.empty() ? std::string("none of its materials has a name")
                                      : fmt::format("there are {}", fmt::join(names, ", "))));
    }
    return Done{};
  }

  /// Adds the parts of the model that these lines belong to, as if an instance placed them.
  Result<Done> place(const FileLines& lines) {
    FileInstance& instance = line_instances_.emplace_back();
    instance.line = lines.line;
    instance.placement = lines.placement;
    const auto entry = std::ranges::find(file_.models, lines.model, &FileModel::name);
    const auto index = static_cast<std::size_t>(entry - file_.models.begin());
    const PlacedModel& model = models_[index];
    for (std::size_t i = 0; i < model.parts.size(); ++i) {
      const PlacedPart part{&instance, &model, &model.parts[i], index, i};
      if (part.moves()) {
        return at_line(file_.path, lines.line,
                       fmt::format("{} stand still, and the model '{}' has an animation", lines.title(), lines.model));
      }
      if (Result<Done> checked = check_placed(part, file_.path); !checked) return checked;
      placed_lines_.emplace_back(&lines, part);
    }
    return Done{};
  }

  /// Adds a model's own lines and points, in its own colours.
  Result<Done> place_lines(const FileInstance& file, const PlacedModel& model, std::size_t index) {
    if (model.lines.empty()) return Done{};
    if (file.moves() || file.is_static || file.billboard != Billboard::none) {
      composed_->warnings.push_back(fmt::format(
          "model '{}': its lines and points are left out where an instance of it moves, turns to the camera "
          "or is static",
          file.model));
      return Done{};
    }
    FileInstance& instance = line_instances_.emplace_back();
    instance.line = file.line;
    instance.placement = file.placement;
    for (std::size_t i = 0; i < model.lines.size(); ++i) {
      // A mesh is identified by its model and number.
      const PlacedPart part{&instance, &model, &model.lines[i].part, index, model.parts.size() + i};
      if (Result<Done> checked = check_placed(part, file_.path); !checked) return checked;
      model_lines_.emplace_back(model.lines[i].segments, part);
    }
    return Done{};
  }

  /// Sets the scene's units: the whole scene is within kComposedRadius, at any time.
  Result<Done> set_scale() {
    constexpr int kLooks = 64;
    double radius = 0;
    const auto include = [&radius](const Vector& p) { radius = std::max(radius, std::hypot(p[0], p[1], p[2])); };
    const auto include_part = [&](const PlacedPart& placed) {
      const std::vector<Vector> corners =
          placed.bends() ? corners_of_poses(placed.part->mesh) : corners_of(placed.part->mesh);
      for (int look = 0; look < (placed.moves() ? kLooks : 1); ++look) {
        const Affine at = placed.at(duration_ * look / kLooks, duration_);
        if (placed.file->billboard != Billboard::none) {
          radius = std::max(radius, radius_of_billboard(at, corners));
          continue;
        }
        for (const Vector& corner : corners) include(at * corner);
      }
    };
    for (const PlacedPart& placed : placed_) include_part(placed);
    for (const auto& [lines, placed] : placed_lines_) include_part(placed);
    for (const auto& [segments, placed] : model_lines_) include_part(placed);
    for (const FileLines& lines : file_.lines) {
      const Affine at = to_affine(lines.placement);
      for (const Vector& vertex : lines.vertices) include(at * vertex);
    }
    for (const FileEllipsoid& ellipsoid : file_.ellipsoids) {
      const Vector& at = ellipsoid.placement.translation;
      const Vector& radii = ellipsoid.placement.scale;
      radius = std::max(radius, std::hypot(at[0], at[1], at[2]) + std::max({radii[0], radii[1], radii[2]}));
    }
    if (radius == 0) {
      if (const Result<Done> done = check_has_triangles(); !done) return done.failure();
    }
    if (!(radius > 0) || !std::isfinite(radius)) return at_line(file_.path, 1, "the scene is a single point");
    composed_->units.scale = kComposedRadius / radius;
    return Done{};
  }

  /// Refuses [[lines]] of a model that has only its own lines: it has no vertices to connect.
  Result<Done> check_has_triangles() const {
    for (std::size_t i = 0; i < models_.size(); ++i) {
      if (!models_[i].parts.empty()) continue;
      return at_line(
          file_.path, file_.models[i].file_line,
          fmt::format("model '{}' has only lines and points, which an [[instance]] of it draws; nothing else "
                      "is in the scene",
                      file_.models[i].name));
    }
    return Done{};
  }

  Result<Done> add(const PlacedPart& placed) {
    const Vector scale = meshes_.scale_of(placed);
    const Affine unscaled = scaling({1 / scale[0], 1 / scale[1], 1 / scale[2]});
    const Result<std::uint16_t> material = materials_.index_of(placed);
    if (!material) return material.failure();
    Instance instance{.mesh = meshes_.index_of(placed, scale), .material = *material};
    if (placed.file->outline && composed_->meshes[instance.mesh].outline == 0) warn_of_lost_outline(*placed.file);
    if (const Result<Done> fits = check_outline(placed, instance); !fits) return fits.failure();
    const double units = composed_->units.scale;
    const auto at = [this, placed, unscaled, units](double seconds) {
      return scaling({units, units, units}) * placed.at(seconds, duration_) * unscaled;
    };
    if (!to_transform(at(0), instance.transform)) {
      return at_line(file_.path, placed.file->line,
                     "[[instance]] is too far away, or too large or small compared with the others");
    }
    if (placed.moves()) {
      motions_.push_back({.instance = static_cast<std::uint16_t>(composed_->instances.size()),
                          .at = at,
                          .corners = corners_of(composed_->meshes[instance.mesh])});
    }
    composed_->instances.push_back(instance);
    std::string name = placed.file->name.empty() ? placed.file->model : placed.file->name;
    const std::int32_t node = placed.part->node;
    if (node != kNoNode) name += "/" + placed.model->model->tree.nodes[static_cast<std::size_t>(node)].name;
    composed_->instance_names.push_back(std::move(name));
    return Done{};
  }

  /// Warns once for an instance of many parts.
  void warn_of_lost_outline(const FileInstance& file) {
    std::string warning =
        at_line(file_.path, file.outline->line, "[instance.outline] is left out: the model is too small for this scene")
            .message;
    if (std::ranges::find(composed_->warnings, warning) == composed_->warnings.end()) {
      composed_->warnings.push_back(std::move(warning));
    }
  }

  Result<Done> check_outline(const PlacedPart& placed, const Instance& instance) const {
    if (!placed.file->outline) return Done{};
    const auto wrong = [&](const char* what) { return at_line(file_.path, placed.file->outline->line, what); };
    if (composed_->outlines.size() > kMaxOutlines) return wrong("[instance.outline] is one of more than 255 outlines");
    const std::uint8_t outline = composed_->meshes[instance.mesh].outline;
    if (outline > 0 && composed_->outlines[outline - 1U].hull == kNoHull) {
      return wrong("[instance.outline]: the model has too many vertices for the hull of an outline; simplify it");
    }
    const Material& material = composed_->materials[instance.material];
    if (material.finish < composed_->finishes.size() &&
        composed_->finishes[material.finish].alpha_mode != AlphaMode::opaque) {
      return wrong("[instance.outline] needs an opaque material: this one has a mask or blends");
    }
    return Done{};
  }

  Result<Done> add(const FileEllipsoid& ellipsoid) {
    const auto own = std::ranges::find(file_.materials, ellipsoid.material, &FileMaterial::name);
    const Result<std::uint16_t> material = materials_.index_of(*own);
    if (!material) return material.failure();
    const double units = composed_->units.scale;
    Quadric quadric{.material = *material};
    // A length of less than a few codes of 16.16 becomes 0 when it is rounded, or has no inverse.
    const bool is_thin = std::ranges::min(ellipsoid.placement.scale) * units < 4.0 / kFixedOne;
    if (is_thin || !to_transform(scaling({units, units, units}) * to_affine(ellipsoid.placement), quadric.transform)) {
      return at_line(file_.path, ellipsoid.line,
                     "[[ellipsoid]] is too far away, or too large, small or flat compared with the others");
    }
    composed_->quadrics.push_back(quadric);
    return Done{};
  }

  /// Returns the map to the scene of a part that does not move, whose mesh has the part's size.
  Affine still(const PlacedPart& placed, const Vector& scale) const {
    const double units = composed_->units.scale;
    return scaling({units, units, units}) * placed.at(0, duration_) *
           scaling({1 / scale[0], 1 / scale[1], 1 / scale[2]});
  }

  Result<Done> add(std::span<const Segment> segments, const PlacedPart& placed) {
    const Result<std::uint16_t> material = materials_.index_of(placed);
    if (!material) return material.failure();
    const Vector scale = meshes_.scale_of(placed);
    LineSet set{.segments = segments, .mesh = meshes_.index_of(placed, scale), .material = *material};
    if (!to_transform(still(placed, scale), set.transform)) {
      return at_line(file_.path, placed.file->line,
                     "[[instance]] has lines that are too far away, or too large or small compared with the others");
    }
    composed_->lines.push_back(set);
    return Done{};
  }

  Result<Done> add(const FileLines& lines) {
    const auto own = std::ranges::find(file_.materials, lines.material, &FileMaterial::name);
    const Result<std::uint16_t> material = materials_.index_of(*own);
    if (!material) return material.failure();
    const double units = composed_->units.scale;
    const auto add_set = [&](std::uint16_t mesh, const std::vector<Segment>& segments, const Transform& transform) {
      composed_->lines.push_back({.segments = composed_->segments.emplace_back(segments),
                                  .mesh = mesh,
                                  .material = *material,
                                  .transform = transform,
                                  .width = lines.width});
    };
    if (lines.model.empty()) {
      const Affine at = scaling({units, units, units}) * to_affine(lines.placement);
      std::vector<Vector> vertices;
      for (const Vector& vertex : lines.vertices) vertices.push_back(at * vertex);
      const auto mesh = static_cast<std::uint16_t>(composed_->meshes.size());
      composed_->meshes.push_back(mesh_of(vertices, composed_->line_vertices.emplace_back()));
      add_set(mesh, lines.segments, Transform::identity());
      return Done{};
    }
    for (const auto& [file, placed] : placed_lines_) {
      if (file != &lines) continue;
      const Vector scale = meshes_.scale_of(placed);
      Transform transform;
      if (!to_transform(still(placed, scale), transform)) {
        return at_line(
            file_.path, lines.line,
            fmt::format("{} are too far away, or too large or small compared with the others", lines.title()));
      }
      const std::uint16_t mesh = meshes_.index_of(placed, scale);
      add_set(mesh, lines.are_points ? points_of(composed_->meshes[mesh]) : edges_of(composed_->meshes[mesh]),
              transform);
    }
    return Done{};
  }

  Result<Done> animate() {
    if (motions_.empty() && !bent_) return Done{};  // models that bend last as long as those that move
    Result<FittedAnimation> fitted = fit_animation(motions_, duration_, all_key_times(file_, models_, duration_),
                                                   kAnimationTolerance * kComposedRadius);
    if (!fitted) return at_line(file_.path, 1, "the animation " + fitted.failure().message);
    composed_->animation = std::move(*fitted);
    return Done{};
  }

  Result<Done> check() const {
    const Status status = validate(composed_->scene());
    if (status) return Done{};
    if (status.error == Error::instance && status.needed < placed_.size()) {
      const FileMaterial* const other = materials_.override_of(placed_[status.needed]);
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
  ComposedMeshes meshes_;
  ComposedMaterials materials_;
  std::vector<PlacedModel> models_;  ///< in the order of file_.models
  std::optional<std::size_t> bent_;  ///< index into models_ of the one that bends
  std::vector<PlacedPart> placed_;
  std::deque<ModelPart> billboard_parts_;
  std::deque<FileInstance> line_instances_;  ///< instances that would place the models of lines
  std::vector<std::pair<const FileLines*, PlacedPart>> placed_lines_;
  std::vector<std::pair<std::span<const Segment>, PlacedPart>> model_lines_;
  std::vector<InstanceMotion> motions_;
  double duration_ = 0;
};

}  // namespace

Result<std::unique_ptr<const ComposedScene>> compose(const SceneFile& file) { return Composer(file).run(); }

}  // namespace zstrip::sim
