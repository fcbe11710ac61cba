// `zstrip bake`: writes a scene as constants for firmware, or as a blob that is used in place.
#include "cli/bake_command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bake/baked_light.hpp"
#include "bake/blob_characters.hpp"
#include "bake/clipping.hpp"
#include "bake/effects_found.hpp"
#include "bake/flash_bytes.hpp"
#include "bake/mipmaps.hpp"
#include "bake/palettes.hpp"
#include "bake/pico_scene.hpp"
#include "bake/program_text.hpp"
#include "bake/project_files.hpp"
#include "bake/scene_blob.hpp"
#include "bake/shown_edges.hpp"
#include "bake/stage_skins.hpp"
#include "bake/unmoved_scene.hpp"
#include "cli/bake_kind.hpp"
#include "cli/baked_method.hpp"
#include "cli/camera_arguments.hpp"
#include "cli/one_of.hpp"
#include "cli/output_names.hpp"
#include "cli/output_skins.hpp"
#include "cli/pico_arguments.hpp"
#include "cli/picture_arguments.hpp"
#include "cli/plan_arguments.hpp"
#include "cli/print.hpp"
#include "cli/project_arguments.hpp"
#include "image/inputs.hpp"
#include "image/write_file.hpp"
#include "import/quantise.hpp"
#include "render/edged_stage.hpp"
#include "render/levelled_stage.hpp"
#include "render/shadow_pool.hpp"
#include "render/stage.hpp"
#include "report/bake_report.hpp"
#include "text/step_report.hpp"
#include "text/text.hpp"
#include "visibility/methods.hpp"
#include "visibility/prepared_scene.hpp"
#include "visibility/tree_stage.hpp"
#include "visibility/visible_set_bake.hpp"

namespace zstrip::sim {
namespace {

/// The value is one of the words that the option accepts.
TextureChoice texture_choice(const std::string& word) {
  if (word == "auto") return TextureChoice::automatic;
  if (word == "palette8") return TextureChoice::palette8;
  return word == "palette4" ? TextureChoice::palette4 : TextureChoice::rgb565;
}

MipmapChoice mipmap_choice(const std::string& word) {
  if (word == "on") return MipmapChoice::on;
  return word == "off" ? MipmapChoice::off : MipmapChoice::automatic;
}

std::span<const std::uint8_t> bytes_of(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

/// Returns the effects that the picture's settings choose in addition to the view.
Effects picture_effects(const PlanRequest& request) { return request.perspective | depth_effect(request.depth_format); }

/// True if both cameras show the same picture of the same scene.
bool same(const Camera& a, const Camera& b) {
  return a.right == b.right && a.up == b.up && a.back == b.back && a.eye == b.eye && a.focal == b.focal &&
         a.near_plane == b.near_plane && a.far_plane == b.far_plane && a.projection == b.projection &&
         a.fixed_depth_range == b.fixed_depth_range;
}

/// Returns the pixels of a length of 1 at the scene's centre, the origin.
double pixels_of_unit(const Camera& camera, const View& view) {
  const double half_height = from_fixed(camera.focal) * view.height / 2;
  if (camera.projection == Projection::orthographic) return half_height;
  const Vec3 &eye = camera.eye, &back = camera.back;
  constexpr double kAxis = 16384;  // of a unit vector in 2.30 that is read as 16.16
  const double distance = (from_fixed(eye.x) * from_fixed(back.x) + from_fixed(eye.y) * from_fixed(back.y) +
                           from_fixed(eye.z) * from_fixed(back.z)) /
                          kAxis;
  return half_height / std::max(distance, from_fixed(camera.near_plane));
}

/// Plans the scene at rest.
Result<BakedScene> plan_baked(const std::string& scene, const Staging& staging, const Animation& animation,
                              const Turn& turn, const BakedSkins& skins, const PlanRequest& request) {
  const Result<Plan> plan = best_plan(staging, request);
  if (!plan) return plan.failure();
  BakedScene baked{.source = std::filesystem::path(scene).filename().string(),
                   .scene = staging.scene,
                   .camera = staging.camera,
                   .animation = animation,
                   .view = request.view,
                   .effects = effects_of(staging.scene, staging.camera) | effects_of(request.view) | request.method |
                              picture_effects(request),
                   .budget = request.budget,
                   .plan = *plan,
                   .tree = staging.tree,
                   .turn = turn,
                   .skins = skins,
                   .levels = staging.levels};
  const bool binned = plan->mode == Mode::binned;
  if (binned) baked.effects = baked.effects | effect::bins;
  baked.budget.modes = binned ? Modes::binned : Modes::streamed;
  baked.budget.strip_rows = plan->strip_rows;
  baked.budget.strip_columns = plan->strip_columns;
  return baked;
}

/// For a header: leaves out clipping if the option allows it and the motion does not need it.
ClippingRecord choose_clipping(const BakeArguments& arguments, bool turntable, BakedScene& baked) {
  if (arguments.clipping == "on") return {.where = {}, .why = "--clipping on"};
  ClippingRecord clipping = find_clipping(baked, turntable);
  if (clipping.left_out) {
    baked.effects = baked.effects | effect::unclipped;
    baked.unclipped_where = clipping.where;
  }
  return clipping;
}

/// Returns the edges that the motion shows, for a header; nothing if all edges stay.
std::unique_ptr<ShownEdges> choose_edges(BakeKind kind, const BakeArguments& arguments, bool turntable,
                                         const Staging& at_rest, const Animation& animation, const Turn& turn,
                                         const BakedSkins& skins, const View& view) {
  const bool moves_as_baked = !animation.tracks.empty() || (turntable && turn.what != Turning::nothing);
  if (!is_source(kind) || arguments.clipping == "on" || !moves_as_baked || at_rest.scene.edges.empty()) return nullptr;
  std::vector<std::size_t> bent;
  for (const ModelSkin& skin : skins.meshes) bent.push_back(skin.mesh);
  for (const ModelMorph& morph : skins.morphs) bent.push_back(morph.mesh);
  for (const DetailLevel& level : at_rest.levels) bent.insert(bent.end(), {level.mesh, level.coarser});
  return std::make_unique<ShownEdges>(scenes::AtRest{at_rest.scene, at_rest.camera, animation, turn}, view, bent);
}

BakeRecord describe(const BakeArguments& arguments, const Stage& stage, const BakedScene& baked) {
  const Model* model = stage.model();
  // Split triangles have their own material.
  const Origins origins = baked.effects.any(method::orders) ? Origins{} : stage.origins();
  BakeRecord record{.scene = arguments.scene,
                    .output = arguments.output,
                    .view = baked.view,
                    .materials = baked.scene.materials.size(),
                    .counts = count(baked.scene),
                    .flash = flash_bytes(baked.scene, baked.animation, baked.tree, baked.skins, baked.levels),
                    .accuracy = {},
                    .effects = find_effects(baked.scene, baked.camera, baked.effects, origins),
                    .plan = baked.plan,
                    .strip_buffers = baked.budget.strip_buffers,
                    .lent_bytes = {},
                    .warnings = stage.warnings(),
                    .skin_ram = baked.characters != nullptr ? baked.characters->ram() : skin_ram(baked.skins),
                    .edges_left_out = baked.edges_left_out};
  if (arguments.camera.reduction.lod || !baked.levels.empty()) record.levels = levels_record(baked.scene, baked.levels);
  if (model != nullptr) record.accuracy = model->accuracy;
  if (model != nullptr) record.shrunk = model->shrunk;
  if (model != nullptr && model->reduced) {
    const double length = model->reduced->error * model->units.scale;
    record.reduced = ReducedTriangles{*model->reduced, length * pixels_of_unit(baked.camera, baked.view)};
  }
  return record;
}

/// `turning_camera`: for several frames.
Result<std::vector<std::uint8_t>> make_blob(const BakedScene& baked, const Camera& turning_camera, BakeRecord& record) {
  const Effects picture = baked.effects & (effect::perspective_runs | effect::depth_formats);
  const bool has_other_camera = !same(turning_camera, baked.camera);
  const BlobCharacters* const characters = baked.characters;
  Result<std::vector<std::uint8_t>> blob =
      to_scene_blob({.scene = baked.scene,
                     .camera = baked.camera,
                     .view = baked.view,
                     .tree = baked.tree,
                     .animation = baked.animation,
                     .turn = baked.turn,
                     .turning_camera = has_other_camera ? &turning_camera : nullptr,
                     .effects = picture,
                     .clips = characters != nullptr ? characters->clips() : std::span<const Clip>(),
                     .skins = characters != nullptr ? characters->skins() : std::span<const Skin>(),
                     .morphs = {characters != nullptr ? characters->morphs() : std::span<const MovedMorph>(), {}},
                     .events = baked.events,
                     .levels = baked.levels});
  if (!blob) return Failure{blob.failure().status, fmt::format("'{}' {}", record.scene, blob.failure().message)};
  if (characters != nullptr) record.flash.keyframes = characters->keyframe_bytes();
  record.flash.tables = blob->size() - record.flash.arrays();
  record.lent_bytes = table_bytes(baked.scene) + (characters != nullptr ? characters->table_bytes() : 0);
  return blob;
}

/// `pico_file`: the board and program of a file for a Pico.
Result<std::vector<std::uint8_t>> make_output(const BakeArguments& arguments, BakeKind kind, const BakedScene& baked,
                                              const Camera& turning_camera, const PicoFile& pico_file,
                                              BakeRecord& record) {
  if (is_source(kind)) {
    const std::string file_name = std::filesystem::path(arguments.output).filename().string();
    const std::string text = kind == BakeKind::sketch    ? to_sketch(baked, arguments.name_space)
                             : kind == BakeKind::program ? to_program(baked, arguments.name_space, file_name)
                                                         : to_scene_header(baked, arguments.name_space);
    return std::vector<std::uint8_t>(text.begin(), text.end());
  }
  Result<std::vector<std::uint8_t>> blob = make_blob(baked, turning_camera, record);
  if (!blob || kind == BakeKind::blob) return blob;
  Result<std::vector<std::uint8_t>> file = to_pico_file(*blob, pico_file.program, pico_file.board);
  if (!file) return Failure{file.failure().status, fmt::format("'{}' {}", record.scene, file.failure().message)};
  return file;
}

Result<VisibleSetRecord> write_sets(const std::string& output, const Staging& staging, const Animation& animation,
                                    const CellCounts& cells) {
  const Result<BakedVisibleSets> baked = bake_visible_sets(staging.scene, staging.camera, animation, cells);
  if (!baked) return baked.failure();
  const auto bytes = baked->bytes();
  const Result<Done> written =
      write_file(output, {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}, "--visible-sets");
  if (!written) return written.failure();
  return VisibleSetRecord{output, baked->cells, baked->sets, baked->meshlets, bytes.size(), baked->hidden};
}

Result<Done> report(const BakeRecord& record, const BakeArguments& arguments) {
  const bool json_on_stdout = arguments.json && (*arguments.json == "-" || is_standard_output(*arguments.json));
  if (json_on_stdout) write_text(stdout, bake_json(record));  // main checks the stream's state
  if (arguments.json && !json_on_stdout) {
    const Result<Done> written = write_file(*arguments.json, bytes_of(bake_json(record)), "--json");
    if (!written) return written.failure();
  }
  if (arguments.quiet) return Done{};
  if (!write_text(json_on_stdout ? stderr : stdout, bake_summary(record)) && json_on_stdout) {
    return Failure{ExitStatus::output, "cannot write the summary to standard error; is it closed, or the disk full?"};
  }
  return Done{};
}

}  // namespace

Result<Done> bake(const BakeArguments& arguments, const BakeTrial* trial) {
  const Result<BakeKind> kind = bake_kind(arguments.output);
  if (!kind) return kind.failure();
  if (!is_namespace(arguments.name_space)) {
    return Failure{ExitStatus::usage,
                   fmt::format("--namespace '{}' must be lower case letters, digits and single underscores between "
                               "them, neither std nor zstrip, and no word of C++",
                               arguments.name_space)};
  }
  if (arguments.cells && !arguments.visible_sets) {
    return Failure{ExitStatus::usage, "--cells is the grid of --visible-sets, which is not given"};
  }
  const Result<CellCounts> cells = parse_cells(arguments.cells.value_or("8x2x8"), "--cells");
  if (!cells) return cells.failure();
  const bool for_pico = *kind == BakeKind::pico;
  if (!for_pico) {
    const Result<Done> not_given = check_not_for_pico(arguments.pico);
    if (!not_given) return not_given.failure();
  }
  std::optional<Project> project;
  if (*kind == BakeKind::project) {
    Result<Project> parsed = parse_project(arguments.project, arguments.output);
    if (!parsed) return parsed.failure();
    project = std::move(*parsed);
  } else if (const Result<Done> not_given = check_no_project(arguments.project); !not_given) {
    return not_given.failure();
  }
  Result<PlanRequest> request = parse_plan(for_pico  ? plan_arguments_for_pico(arguments.plan)
                                           : project ? plan_arguments_for_project(arguments.plan, *project)
                                                     : arguments.plan,
                                           arguments.scene);
  if (!request) return request.failure();
  if (for_pico) {
    if (const Result<Done> shown = check_view_for_pico(request->view); !shown) return shown.failure();
  }
  if (const Result<Done> settled =
          settle_method(*kind, arguments.scene, arguments.plan.visibility.has_value(), request->method);
      !settled)
    return settled.failure();
  if (arguments.camera.reduction.lod && (request->method != Effects{} || arguments.visible_sets)) {
    return Failure{ExitStatus::usage, fmt::format("--lod changes meshes from frame to frame, which {} does not know",
                                                  arguments.visible_sets ? "--visible-sets" : "--visibility")};
  }
  if (const Result<Done> checked = check_visibility(
          request->method | picture_effects(*request) | edge_effects(request->edges), depth_option(std::nullopt));
      !checked) {
    return checked.failure();
  }
  const Result<ModelOptions> model = parse_model(arguments.camera, arguments.scene, request->view.format);
  if (!model) return model.failure();
  const Result<CameraOptions> camera = parse_camera(arguments.camera, arguments.scene);
  if (!camera) return camera.failure();
  OutputNames outputs;
  outputs.path = arguments.output;
  if (project) outputs.path /= "scene.hpp";
  const Result<Done> distinct = check_distinct(outputs, arguments.json, arguments.visible_sets);
  if (!distinct) return distinct.failure();
  const Result<PicoFile> pico_file =
      parse_pico(arguments.pico, for_pico ? arguments.plan.memory.board : std::nullopt, arguments.output);
  if (!pico_file) return pico_file.failure();

  // A folder's model turns, unless it has an animation.
  const bool turntable = arguments.turntable || project;
  const std::uint32_t angles = turntable ? 2 : 1;  // 2 frames: the camera must show every angle
  std::optional<StepReport> steps(std::in_place, !arguments.quiet);
  const bool is_open = trial != nullptr && *trial->stage != nullptr;
  Result<std::unique_ptr<Stage>> stage =
      is_open ? (*trial->stage)->copy() : open_stage(arguments.scene, *model, *camera, request->view, angles);
  if (!stage) return stage.failure();
  if (trial != nullptr && !is_open) *trial->stage = (*stage)->copy();
  if (stage && arguments.camera.reduction.lod) stage = with_levels(std::move(*stage), request->view);
  if (stage) stage = with_edges(std::move(*stage), request->edges, request->view);
  if (!stage) return stage.failure();
  if (trial == nullptr) {
    for (const std::string& warning : (*stage)->warnings()) print_warning(warning);
  }
  if (const Result<Done> fits = check_shadow_pool(**stage, request->view); !fits) return fits.failure();
  const Result<Staging> staging = (*stage)->place(0, angles);
  if (!staging) return staging.failure();
  if (const Result<Done> checked =
          check_visibility(effects_of(staging->scene, staging->camera) | request->method | picture_effects(*request),
                           depth_option(std::nullopt));
      !checked) {
    return checked.failure();
  }
  if (for_pico) {
    const Result<Done> drawn = check_for_pico(effects_of(staging->scene, staging->camera) | picture_effects(*request));
    if (!drawn) return drawn.failure();
  }
  const Result<OutputSkins> output_skins =
      skins_of(*kind, arguments, request->method, **stage, staging->scene, trial == nullptr);
  if (!output_skins) return output_skins.failure();
  const BakedSkins& skins = output_skins->skins;
  const Result<PreparedScene> prepared =
      prepare_for(request->method, arguments.visible_sets.has_value(), *staging, (*stage)->animation(), skins);
  if (!prepared) return prepared.failure();
  Staging at_rest = prepared->staging();
  const UnmovedScene unmoved(at_rest.scene);
  if (unmoved.moved() && trial == nullptr) {
    print_warning("vertices that a skin moves while they are drawn stand still, as they were modelled");
  }
  const MipmappedScene mipmapped(unmoved.scene(), mipmap_choice(arguments.mipmaps));
  const PalettedScene paletted(mipmapped.scene(), texture_choice(arguments.textures));
  at_rest.scene = paletted.scene();
  const bool has_clips = !output_skins->clips.empty();
  Result<Turn> turn =
      has_clips ? Result<Turn>(Turn{.what = Turning::nothing}) : turn_of(**stage, request->method, turntable, *staging);
  if (!turn) return turn.failure();
  std::optional<LightBakedScene> lit;
  if (arguments.lighting == "baked") {
    lit.emplace(at_rest.scene, meshes_in_motion(at_rest, (*stage)->animation(), *turn, *output_skins));
    at_rest.scene = lit->scene();
    const bool all_turn = turn->what != Turning::nothing && turn->still_instances == 0;
    if (lit->baked() > 0 && all_turn) turn = Turn{.what = Turning::camera};
  }
  std::optional<BlobCharacters> characters;  // whose skins refer to meshes by their address, so that it comes last
  if (has_clips) {
    characters.emplace(at_rest.scene, skins, output_skins->clips);
    if (const Result<Done> posed = characters->pose_all(); !posed) {
      return Failure{posed.failure().status, fmt::format("'{}': {}", arguments.scene, posed.failure().message)};
    }
    at_rest.scene = characters->scene();
  }
  if (for_pico) {
    request = request_for_pico(*request, at_rest, (*stage)->animation(), *turn, characters ? &*characters : nullptr,
                               *pico_file);
    if (!request) {
      return Failure{request.failure().status, fmt::format("'{}' {}", arguments.scene, request.failure().message)};
    }
  }
  const std::unique_ptr<ShownEdges> shown =
      choose_edges(*kind, arguments, turntable, at_rest, (*stage)->animation(), *turn, skins, request->view);
  if (shown) at_rest.scene.edges = shown->sets();
  *request = with_enough_ram(at_rest, *request);
  Result<BakedScene> baked = plan_baked(arguments.scene, at_rest, (*stage)->animation(), *turn, skins, *request);
  if (!baked) return baked.failure();
  if (shown) baked->edges_left_out = shown->left_out();
  if (characters) baked->characters = &*characters;
  const std::vector<ClipEvent> events = events_of(output_skins->clips, **stage);
  if (characters || !baked->animation.tracks.empty() || skins.move()) baked->events = events;
  if (project) {
    if (const Result<Done> shown_by = check_for_project(*baked, arguments.name_space, *project); !shown_by) {
      return shown_by.failure();
    }
  }
  if (*kind == BakeKind::sketch || *kind == BakeKind::program) {
    const Result<Done> drawn = *kind == BakeKind::sketch ? check_for_sketch(*baked, arguments.name_space)
                                                         : check_for_program(*baked, arguments.name_space);
    if (!drawn) return drawn.failure();
  }
  std::optional<ClippingRecord> clipping;
  if (is_source(*kind)) clipping = choose_clipping(arguments, turntable, *baked);
  BakeRecord record = describe(arguments, **stage, *baked);
  record.clipping = std::move(clipping);
  record.palettes = paletted.records();
  if (lit) record.light_baked = lit->baked();
  record.mipmaps = mipmap_records(at_rest.scene);
  if (arguments.textures == "rgb565") {
    record.palettes_would_save = PalettedScene(at_rest.scene, TextureChoice::automatic).saved_bytes();
  }
  if (request->method != Effects{}) {
    record.method = BakedMethodRecord{request->method, prepared->splits(), baked->tree.nodes.size()};
  }
  const Result<Camera> turning_camera = (*stage)->camera(2);
  if (!turning_camera) return turning_camera.failure();
  const Result<std::vector<std::uint8_t>> output =
      make_output(arguments, *kind, *baked, *turning_camera, *pico_file, record);
  if (!output) return output.failure();
  if (trial != nullptr) return trial->see(*baked, record);
  // Before anything is written.
  if (const Result<Done> checked = check_no_input(arguments.visible_sets.value_or(""), "--visible-sets"); !checked)
    return checked.failure();
  if (const Result<Done> checked = check_no_input(arguments.json.value_or(""), "--json"); !checked)
    return checked.failure();
  const Result<Done> written =
      project ? write_project(arguments.output, *output, project_files(*baked, arguments.name_space, *project))
              : write_file(arguments.output, *output, "-o");
  if (!written) return written.failure();
  if (arguments.visible_sets) {
    Result<VisibleSetRecord> sets = write_sets(*arguments.visible_sets, *staging, (*stage)->animation(), *cells);
    if (!sets) return sets.failure();
    record.visible_sets = std::move(*sets);
  }
  steps.reset();
  return report(record, arguments);
}

void add_bake_command(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("bake", "Write a model for firmware: as C++ constants, or a blob for flash");
  const auto arguments = std::make_shared<BakeArguments>();
  BakeArguments& a = *arguments;
  command
      ->add_option("scene", a.scene,
                   "A model (.obj .gltf .glb .stl .ply .3ds .dae ...), a scene file (.toml), a built-in or baked scene")
      ->required()
      ->type_name("SCENE");
  command
      ->add_option(
          "-o,--output", a.output,
          "The file to write: .hpp for C++ constants, .ino for a sketch for Arduino that shows them on an ST7789, .cpp "
          "for a program that draws them, .zsc for a blob, .uf2 for a blob for a Raspberry Pi Pico "
          "with zstrip_pico_player.uf2, or for a Pico 2 with zstrip_pico2_player.uf2. FOLDER/: a whole program, see "
          "--project, --display and --cores")
      ->required()
      ->type_name("FILE");
  add_plan_options(*command, a.plan, kPicoBoardHelp);
  command->get_option("--visibility")
      ->description(fmt::format("The visibility method: {} (default: zbuffer). Headers keep it, .zsc only "
                                "painter-newell and painter-bsp, .uf2, .ino and .cpp none",
                                visibility_names()));
  add_camera_options(*command, a.camera);
  add_reduction_options(*command, a.camera.reduction);
  command->add_flag("--turntable", a.turntable, "Place the camera so that the model can rotate");
  command
      ->add_option("--namespace", a.name_space,
                   "Namespace of a header's constants, so that one program can have several headers")
      ->type_name("NAME")
      ->capture_default_str();
  command
      ->add_option("--visible-sets", a.visible_sets,
                   "Also write which meshlets cannot be seen from the cells of a grid, for zstrip render")
      ->type_name("FILE");
  command->add_option("--cells", a.cells, "Cells of that grid along x, y and z (default: 8x2x8)")
      ->transform(lower_case())
      ->type_name("NxNxN");
  command
      ->add_option(
          "--textures", a.textures,
          "Palettes make textures smaller and drawing slower: auto, where no colour is lost; palette8, with 256 "
          "colours; palette4, with 16; rgb565, no palettes (default)")
      ->option_text("FORMAT")
      ->transform(one_of({"rgb565", "auto", "palette8", "palette4"}));
  command
      ->add_option(
          "--mipmaps", a.mipmaps,
          "Mipmaps, for textures that are seen from far away: auto, where the scene has them (default); on, for "
          "all textures of instances, which take a third more bytes and are drawn slower; off, none")
      ->option_text("CHOICE")
      ->transform(one_of({"auto", "on", "off"}));
  command
      ->add_option(
          "--clipping", a.clipping,
          "Code that clips triangles, and edges for --edges: auto, left out of a header if its own motion never "
          "needs them (default); on, for programs that move camera or instances themselves")
      ->option_text("CHOICE")
      ->transform(one_of({"auto", "on"}));
  command
      ->add_option("--lighting", a.lighting,
                   "Light of instances that do not move: drawn, computed in each frame (default); baked, as colours of "
                   "vertices without textures. The camera then goes around a scene that would turn")
      ->option_text("CHOICE")
      ->transform(one_of({"drawn", "baked"}));
  add_pico_options(*command, a.pico);
  add_project_options(*command, a.project);
  command->add_option("--json", a.json, "Write the report as JSON; - is standard output")->type_name("FILE|-");
  command->add_flag("--quiet", a.quiet, "No report in words; warnings and errors remain");
  command->footer(
      "Examples:\n"
      "  zstrip bake model.glb -o scene.hpp --size 128x64 --format gray4 --ram 40K\n"
      "  zstrip bake model.glb -o scene.hpp --size 240x240 --format rgb565_swapped --ram 14K --split-columns "
      "--turntable\n"
      "  zstrip bake model.glb -o model.ino --size 240x240 --format rgb565_swapped --ram 14K --split-columns "
      "--turntable\n"
      "  zstrip bake model.glb -o sketch/ --display tft_espi\n"
      "  zstrip bake model.glb -o sketch/ --project platformio --display lovyangfx\n"
      "  zstrip bake model.glb -o pico/ --project pico --cores 2\n"
      "  zstrip bake model.obj -o scene.zsc --size 320x240\n"
      "  zstrip bake model.glb -o model.uf2\n"
      "  zstrip bake model.glb -o pico.uf2 --with zstrip_pico_player.uf2\n"
      "  zstrip bake model.glb -o scene.hpp --size 240x240 --board bluepill\n"
      "  zstrip bake model.glb -o pico2.uf2 --board pico2 --with zstrip_pico2_player.uf2\n"
      "  zstrip bake house.obj -o house.zsc --visibility painter-bsp\n"
      "  zstrip bake house.glb -o house.hpp --textures auto\n"
      "  zstrip bake house.glb -o house.zsc --mipmaps on\n"
      "  zstrip bake truck.glb -o truck.zsc --texture-size 128 --textures palette8 --triangles 25%\n"
      "  zstrip render scene.zsc --size 320x240");
  command->callback([arguments, &exit_code] {
    const Result<Done> done = bake(*arguments);
    exit_code = done ? static_cast<int>(ExitStatus::ok) : print_failure(done.failure());
  });
}

}  // namespace zstrip::sim
