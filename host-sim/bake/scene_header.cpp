// Writes a scene as a C++ header of constants.
#include "bake/scene_header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <span>
#include <string>
#include <string_view>

#include "bake/effects_found.hpp"
#include "bake/header_text.hpp"
#include "bake/literals.hpp"
#include "bake/moving_meshes_text.hpp"
#include "image/to_rgb.hpp"
#include "report/frame_record.hpp"
#include "text/number.hpp"
#include "text/text.hpp"
#include "zstrip/overlay.hpp"
#include "zstrip/scene/parts.hpp"

namespace zstrip::sim {
namespace {

/// Returns the constant's name for a member of the scene: kPunctualLights for punctual_lights.
std::string constant_name(std::string_view member) {
  std::string name = "k";
  bool begins_word = true;
  for (const char letter : member) {
    if (letter != '_') name += begins_word ? static_cast<char>(std::toupper(letter)) : letter;
    begins_word = letter == '_';
  }
  return name;
}

/// Builds the text of a scene.
class Header {
 public:
  explicit Header(const BakedScene& baked) : baked_(baked), scene_(baked.scene), skins_(baked.skins) {}

  std::string text(const std::string& name_space) {
    comment(name_space);
    out_.line("#pragma once\n");
    if (bends()) out_.line("#include <algorithm>\n#include <cstdint>\n");
    for (const char* header :
         {"animation.hpp", "camera.hpp", "effects.hpp", is_fixed() ? "fixed_renderer.hpp" : nullptr, "plan.hpp",
          has_levels() ? "levels.hpp" : nullptr, bends() ? "morph.hpp" : nullptr, "scene.hpp", "scene/turn.hpp",
          bends() ? "skin.hpp" : nullptr, "status.hpp", "view.hpp"}) {
      if (header != nullptr) out_.line(fmt::format("#include \"zstrip/{}\"", header));
    }
    if (!baked_.events.empty()) out_.line("#include \"zstrip/clips.hpp\"");
    if (!baked_.tree.nodes.empty()) out_.line("#include \"zstrip/scene/bsp_tree.hpp\"");
    if (scene_.overlay != nullptr) out_.line("#include \"zstrip/overlay.hpp\"");
    if (baked_.effects.methods != 0) out_.line("#include \"zstrip/visibility.hpp\"");
    out_.line(fmt::format("\nnamespace {} {{\n", name_space));
    data();
    scene();
    tree();
    animation();
    if (bends()) add_motion(skins_, out_);
    camera();
    plan();
    out_.line(fmt::format("\n}}  // namespace {}", name_space));
    return out_.take();
  }

 private:
  bool bends() const { return skins_.move(); }
  bool has_levels() const { return !baked_.levels.empty(); }
  bool is_unclipped() const { return baked_.effects.has(effect::unclipped); }
  /// True if a FixedRenderer draws the scene.
  bool is_fixed() const {
    return baked_.effects.methods == 0 && !baked_.effects.any(effect::depth_ranges | effect::supersampled);
  }

  void comment(const std::string& name_space) {
    const SceneCounts counts = count(scene_);
    out_.line(fmt::format("// A scene for zstrip, baked from {}: {} in {}, {}.", printable(baked_.source),
                          counted(counts.triangles, "triangle"), counted(counts.meshlets, "meshlet"),
                          counted(counts.instances, "instance")));
    out_.line(
        fmt::format("// Written by `zstrip bake`: do not edit, bake again. The camera is placed for {}x{} pixels, {}.",
                    baked_.view.width, baked_.view.height, name(baked_.view.format)));
    out_.line("//");
    constexpr const char* kFixed[] = {
        "#include \"zstrip/zstrip.hpp\"", "alignas(4) std::array<std::byte, @FixedRenderer::kStripBytes> pixels;",
        "@FixedRenderer renderer;  // its arena is in it", "", "renderer.begin_frame(@kCamera);"};
    constexpr const char* kAny[] = {"#include \"zstrip/zstrip.hpp\"",
                                    "alignas(zstrip::kArenaAlignment) std::array<std::byte, @kPlan.bytes()> arena;",
                                    "alignas(4) std::array<std::byte, @kPlan.strip_pixel_bytes(@kView)> pixels;",
                                    "zstrip::Renderer<@kEffects> renderer;",
                                    "",
                                    "renderer.begin_frame(@kScene, @kCamera, @kView, @kPlan, arena);"};
    constexpr const char* kStrips[] = {
        "for (std::uint16_t strip = 0; strip < @kPlan.strips; ++strip) {", "  renderer.draw_strip(strip, pixels);",
        "  // @kPlan.strip_area(strip, @kView) of the picture is in `pixels`: send it to the display.", "}"};
    for (const std::span<const char* const> part :
         {is_fixed() ? std::span<const char* const>(kFixed) : std::span<const char* const>(kAny),
          std::span<const char* const>(kStrips)}) {
      for (std::string text : part) {
        for (std::size_t at = 0; (at = text.find('@')) != std::string::npos;) text.replace(at, 1, name_space + "::");
        if (bends() && text.starts_with("renderer.begin_frame")) {
          out_.line(fmt::format("//     {}::{}(milliseconds);", name_space, pose_function_of(skins_)));
        }
        out_.line(text.empty() ? "//" : "//     " + text);
      }
    }
    out_.line("//");
    if (baked_.effects.has(method::in_order)) {
      out_.line(
          "// begin_frame and draw_strip return a Status: check it. The triangles are sorted by painter-newell, for "
          "this");
      out_.line("// camera only: bake again for another camera, or after a change of a transform.");
      return;
    }
    if (bends()) {
      out_.line(fmt::format("// {} writes the vertices that {} move, in RAM. Before its first call they are zeros,",
                            pose_function_of(skins_), skins_.meshes.empty() ? "morph targets" : "joints"));
      out_.line("// so that nothing is drawn. It also returns a Status.");
    }
    if (is_fixed()) {
      out_.line("// begin_frame and draw_strip return a Status: check it. To move the scene, change the transforms of");
      out_.line(fmt::format(
          "// `moving.instances()`, with {}::FixedRenderer::Moving moving, and call begin_frame(kCamera, moving).",
          name_space));
    } else {
      out_.line(
          "// begin_frame and draw_strip return a Status: check it. To move the scene, copy kInstances into RAM, "
          "change");
      out_.line("// their transforms, and begin the frame with a copy of kScene whose `instances` are your copy.");
    }
    if (is_unclipped()) out_.line("// Only the baked motion is known to need no clipping: see kEffects.");
    if (baked_.edges_left_out != 0) {
      out_.line("// Edges that the baked motion never shows are not here: --clipping on keeps them.");
    }
    if (!baked_.tree.nodes.empty()) {
      out_.line(fmt::format("// Before begin_frame: renderer.set_visibility({{.tree = &{}::kTree}});", name_space));
    }
    if (has_levels()) {
      out_.line(
          "// Far instances have coarser meshes: call zstrip::choose_levels(kLevels, kScene, camera, instances) before "
          "each");
      out_.line("// frame, after everything has moved. zstrip::Player does it, if it is opened with kLevels.");
    }
    if (baked_.animation.tracks.empty()) return;
    out_.line(
        "// The scene has an animation: call zstrip::pose(kAnimation, milliseconds, instances) before each frame.");
  }

  void data() {
    for (std::size_t i = 0; i < scene_.meshes.size(); ++i) {
      const Mesh* const unmoved = skins_.unmoved(i);
      const Mesh& mesh = unmoved == nullptr ? scene_.meshes[i] : *unmoved;
      const auto name = [i](const char* what) { return fmt::format("k{}{}", what, i); };
      meshes_ += "    {.positions = " + out_.array("zstrip::Position", name("Positions"), mesh.positions);
      meshes_ += ",\n     .normals = " + out_.array("zstrip::Normal", name("Normals"), mesh.normals);
      meshes_ += ",\n     .colours = " + out_.array("zstrip::Colour", name("Colours"), mesh.colours);
      meshes_ += ",\n     .texcoords = " + out_.array("zstrip::TexCoord", name("Texcoords"), mesh.texcoords);
      meshes_ += ",\n     .triangles = " + out_.array("zstrip::Triangle", name("Triangles"), mesh.triangles);
      meshes_ += ",\n     .meshlets = " + out_.array("zstrip::Meshlet", name("Meshlets"), mesh.meshlets);
      meshes_ += fmt::format(",\n     .centre = {},\n     .half_extent = {},\n     .texcoord_bits = {}{}{}{}}},\n",
                             literal(mesh.centre), literal(mesh.half_extent), mesh.texcoord_bits,
                             literal(mesh.billboard), outline_literal(mesh.outline), literal(mesh.shadow));
    }
    for (std::size_t i = 0; i < scene_.textures.size(); ++i) {
      const Texture& texture = scene_.textures[i];
      const std::string texels = out_.array("std::uint16_t", fmt::format("kTexels{}", i), texture.texels);
      const bool plain = texture.format == TextureFormat::rgb565;
      const std::string format =
          plain ? "" : fmt::format(", .format = zstrip::TextureFormat{{{}}}", static_cast<int>(texture.format));
      const std::string levels =
          texture.smaller_levels == 0 ? "" : fmt::format(", .smaller_levels = {}", texture.smaller_levels);
      textures_ += fmt::format("    {{.texels = {}, .log2_width = {}, .log2_height = {}{}{}}},\n", texels,
                               texture.log2_width, texture.log2_height, format, levels);
    }
  }

  void scene() {
    // Before the walk, because headers have these tables first.
    mesh_table_ = mesh_table();
    texture_table_ = texture_table();
    std::string parts;
    bool is_common = true;
    detail::for_each_part(scene_, [&](const char* member, const auto& part) {
      const std::string value = initializer(member, part);
      if (is_common || value != "{}") {
        parts += fmt::format("{}.{} = {}", parts.empty() ? "" : fmt::format(",\n{:38}", ""), member, value);
      }
      // All headers have the parts up to the background.
      if (std::string_view(member) == "background") is_common = false;
    });
    out_.line(fmt::format("\ninline constexpr zstrip::Scene kScene{{{}}};", parts));
  }

  std::string mesh_table() {
    if (bends()) {
      add_moving_meshes(scene_.meshes.size(), skins_, meshes_, out_);
    } else if (!meshes_.empty()) {
      out_.line(fmt::format("\ninline constexpr zstrip::Mesh kMeshes[{}] = {{\n{}}};", scene_.meshes.size(), meshes_));
    } else {
      return "{}";
    }
    return "kMeshes";
  }

  std::string texture_table() {
    if (textures_.empty()) return "{}";
    out_.line(
        fmt::format("inline constexpr zstrip::Texture kTextures[{}] = {{\n{}}};", scene_.textures.size(), textures_));
    return "kTextures";
  }

  // These write the data of a part of the scene and return its initializer: "{}" if there is none.
  std::string initializer(const char*, std::span<const Mesh>) { return mesh_table_; }
  std::string initializer(const char*, std::span<const Texture>) { return texture_table_; }
  std::string initializer(const char*, std::span<const LineSet> sets) { return sets.empty() ? "{}" : lines(); }
  std::string initializer(const char*, std::span<const EdgeSet> sets) { return sets.empty() ? "{}" : edges(); }
  std::string initializer(const char*, const Overlay* part) { return part == nullptr ? "{}" : overlay(*part); }
  std::string initializer(const char*, const Colour& colour) { return literal(colour); }
  template <class Record>
  std::string initializer(const char* member, std::span<const Record> records) {
    return out_.array(type_name(records.data()), constant_name(member), records);
  }
  template <class Record>
  std::string initializer(const char* member, const Record* record) {
    return record == nullptr ? "{}" : out_.array(type_name(record), constant_name(member), std::span(record, 1));
  }

  std::string lines() {
    std::string sets;
    for (std::size_t i = 0; i < scene_.lines.size(); ++i) {
      const LineSet& set = scene_.lines[i];
      sets += fmt::format(
          "    {{.segments = {},\n     .mesh = {},\n     .material = {},\n     .transform = {},\n     .width = {}}},\n",
          out_.array("zstrip::Segment", fmt::format("kSegments{}", i), set.segments), set.mesh, set.material,
          literal(set.transform), set.width);
    }
    out_.line(fmt::format("inline constexpr zstrip::LineSet kLines[{}] = {{\n{}}};", scene_.lines.size(), sets));
    return "kLines";
  }

  std::string edges() {
    std::string sets;
    for (std::size_t i = 0; i < scene_.edges.size(); ++i) {
      const EdgeSet& set = scene_.edges[i];
      sets += fmt::format("    {{.edges = {}, .mesh = {}}},\n",
                          out_.array("zstrip::Edge", fmt::format("kEdges{}", i), set.edges), set.mesh);
    }
    out_.line(fmt::format("inline constexpr zstrip::EdgeSet kEdgeSets[{}] = {{\n{}}};", scene_.edges.size(), sets));
    return "kEdgeSets";
  }

  std::string overlay(const Overlay& over) {
    std::string images, fonts, labels;
    for (std::size_t i = 0; i < over.images.size(); ++i) {
      const OverlayImage& image = over.images[i];
      images += fmt::format(
          "    {{.width = {},\n     .height = {},\n     .colours = {},\n     .coverage = {},\n     .coverage_bits = "
          "{}}},\n",
          image.width, image.height, out_.array("std::uint16_t", fmt::format("kImageColours{}", i), image.colours),
          out_.array("std::uint8_t", fmt::format("kImageCoverage{}", i), image.coverage), image.coverage_bits);
    }
    for (std::size_t i = 0; i < over.fonts.size(); ++i) {
      const Font& font = over.fonts[i];
      const auto is = [&font](const Font& own) { return font.glyphs.data() == own.glyphs.data(); };
      if (is(kSmallFont) || is(kLargeFont)) {
        fonts += is(kSmallFont) ? "    zstrip::kSmallFont,\n" : "    zstrip::kLargeFont,\n";
        continue;
      }
      fonts += fmt::format(
          "    {{.glyphs = {},\n     .coverage = {},\n     .coverage_bits = {},\n     .line_height = {},\n"
          "     .baseline = {},\n     .replacement = {}}},\n",
          out_.array("zstrip::Glyph", fmt::format("kGlyphs{}", i), font.glyphs),
          out_.array("std::uint8_t", fmt::format("kFontCoverage{}", i), font.coverage), font.coverage_bits,
          font.line_height, font.baseline, font.replacement);
    }
    for (std::size_t i = 0; i < over.labels.size(); ++i) {
      const Label& label = over.labels[i];
      out_.line(fmt::format("inline constexpr char kText{}[] = {};", i, quoted(label.text)));
      labels += fmt::format(
          "    {{.text = kText{},\n     .x = {},\n     .y = {},\n     .font = {},\n     .alignment = "
          "zstrip::Alignment{{{}}},\n     .colour = {},\n     .background = {}}},\n",
          i, label.x, label.y, label.font, static_cast<int>(label.alignment), literal(label.colour),
          literal(label.background));
    }
    const auto table = [this](const char* type, const char* name, std::size_t count, const std::string& records) {
      if (count == 0) return std::string("{}");
      out_.line(fmt::format("inline constexpr zstrip::{} {}[{}] = {{\n{}}};", type, name, count, records));
      return std::string(name);
    };
    const std::string all_images = table("OverlayImage", "kImages", over.images.size(), images);
    const std::string all_fonts = table("Font", "kFonts", over.fonts.size(), fonts);
    const std::string sprites = out_.array("zstrip::Sprite", "kSprites", over.sprites);
    const std::string all_labels = table("Label", "kLabels", over.labels.size(), labels);
    out_.line(
        fmt::format("inline constexpr zstrip::Overlay kOverlay{{\n    .images = {}, .fonts = {}, .sprites = {}, "
                    ".labels = {}}};",
                    all_images, all_fonts, sprites, all_labels));
    return "&kOverlay";
  }

  void tree() {
    if (baked_.tree.nodes.empty()) return;
    out_.line("\n/// A tree with the order of the triangles for every position of the camera; begin_frame needs it.");
    out_.array("zstrip::BspNode", "kNodes", baked_.tree.nodes);
    out_.line("inline constexpr zstrip::BspTree kTree{.nodes = kNodes};");
  }

  void animation() {
    out_.line("\n/// The motion of the instances, if it has tracks. Times in milliseconds.");
    const std::string tracks = out_.array("zstrip::Track", "kTracks", baked_.animation.tracks);
    const std::string keyframes = out_.array("zstrip::Keyframe", "kKeyframes", baked_.animation.keyframes);
    out_.line(
        fmt::format("inline constexpr zstrip::Animation kAnimation{{.tracks = {}, .keyframes = {}, .duration = {}}};",
                    tracks, keyframes, baked_.animation.duration));
    out_.line("/// The motion of a scene without tracks, if several frames are shown.");
    out_.line(fmt::format("inline constexpr zstrip::Turn kTurn{{.what = zstrip::Turning::{}, .still_instances = {}}};",
                          turning_name(baked_.turn.what), baked_.turn.still_instances));
    if (has_levels()) {
      out_.line("/// Coarser meshes of far instances, for zstrip::choose_levels or the player.");
      out_.array("zstrip::DetailLevel", "kLevels", baked_.levels);
    }
    if (baked_.events.empty()) return;
    out_.line("/// Numbers for the program at times of the motion, for zstrip::next_event or the player.");
    out_.array("zstrip::ClipEvent", "kEvents", baked_.events);
  }

  const char* projection_name() const {
    return baked_.camera.projection == Projection::orthographic ? "orthographic" : "perspective";
  }

  void camera() {
    const Camera& c = baked_.camera;
    out_.line(fmt::format(
        "\ninline constexpr zstrip::Camera kCamera{{.right = {},  // 2.30\n{pad}.up = {},\n{pad}.back = {},\n"
        "{pad}.eye = {},  // 16.16, like the members below\n{pad}.focal = {},\n{pad}.near_plane = {},\n{pad}.far_plane "
        "= {},\n"
        "{pad}.projection = zstrip::Projection::{},\n{pad}.fixed_depth_range = {}}};",
        literal(c.right), literal(c.up), literal(c.back), literal(c.eye), c.focal, c.near_plane, c.far_plane,
        projection_name(), c.fixed_depth_range, fmt::arg("pad", "                                        ")));
  }

  void plan() {
    const Budget& budget = baked_.budget;
    const View& view = baked_.view;
    std::string words, settings;
    if (view.dither) words += ", dithered", settings += ", true";
    if (view.samples != 1) {
      words += fmt::format(", with {} samples a pixel", view.samples);
      settings = fmt::format(", {}, {}", view.dither, view.samples);
    }
    out_.line(
        fmt::format("\n/// The picture of camera and plan{}.\n"
                    "inline constexpr zstrip::View kView{{{}, {}, zstrip::PixelFormat::{}{}}};",
                    words, view.width, view.height, name(view.format), settings));
    out_.line(fmt::format("/// All effects that the scene needs{}: instantiate one pipeline, with these.",
                          baked_.effects.has(effect::bins) ? ", and bins for the plan" : ""));
    if (is_unclipped()) {
      out_.line(fmt::format(
          "/// No code for clipping is linked. The boxes of all instances stay between the near and the far plane and "
          "within a\n"
          "/// thousand pixels of the picture's centre, {}.\n"
          "/// If the program moves camera or instances in another way and a box leaves this range, begin_frame "
          "returns\n"
          "/// Error::clipping; then bake with --clipping on.",
          baked_.unclipped_where));
    }
    out_.line(fmt::format("inline constexpr zstrip::Effects kEffects = {};", literal(baked_.effects)));
    constexpr Effects kBeyondScene =
        effect::bins | effect::depth_formats | effect::depth_ranges | effect::perspective_runs | effect::unclipped;
    const Effects beyond_scene{baked_.effects.bits & kBeyondScene.bits, baked_.effects.methods};
    const std::string of_view = effects_of(view) == Effects{} ? "" : " | zstrip::effects_of(kView)";
    out_.line(fmt::format("static_assert(kEffects == (zstrip::effects_of(kScene, kCamera){}));",
                          of_view + (beyond_scene == Effects{} ? "" : " | " + literal(beyond_scene))));
    if (bends()) {
      out_.line(
          "/// The scene as it was modelled, which the compiler can count and validate.\n"
          "inline constexpr zstrip::Scene kBindScene = [] {\n"
          "  zstrip::Scene scene = kScene;\n"
          "  scene.meshes = kBindMeshes;\n"
          "  return scene;\n"
          "}();");
    }
    out_.line(fmt::format("inline constexpr zstrip::SceneCounts kCounts = zstrip::count({});",
                          bends() ? "kBindScene" : "kScene"));
    out_.line(fmt::format(
        "/// The limits of --ram and other options, and the strips that fit them: {} of arena and {} for\n"
        "/// each of {}.\n"
        "inline constexpr zstrip::Budget kBudget{{.bytes = {},\n{pad}.strip_rows = {},\n{pad}.strip_columns = {},\n"
        "{pad}.split_columns = {},\n{pad}.strip_buffers = {},\n{pad}.modes = zstrip::Modes::{}}};",
        counted(baked_.plan.bytes(), "byte"), grouped(baked_.plan.strip_pixel_bytes(baked_.view)),
        counted(budget.strip_buffers, "strip buffer"), budget.bytes, budget.strip_rows, budget.strip_columns,
        budget.split_columns, budget.strip_buffers, budget.modes == Modes::binned ? "binned" : "streamed",
        fmt::arg("pad", "                                        ")));
    out_.line(
        "inline constexpr zstrip::PlanResult kPlanned = zstrip::plan(kCounts, kView, kEffects, kBudget);\n"
        "static_assert(kPlanned.status, \"the picture does not fit the bytes of kBudget\");\n"
        "inline constexpr zstrip::Plan kPlan = kPlanned.plan;");
    if (!is_fixed()) return;
    out_.line(
        fmt::format("/// Draws kScene in kView: scene, picture and plan are constants that the compiler has checked.\n"
                    "using FixedRenderer = zstrip::FixedRenderer<kScene, kView, kBudget, {},\n"
                    "                                            zstrip::Projection::{}, kCounts>;",
                    literal(beyond_scene), projection_name()));
  }

  const BakedScene& baked_;
  const Scene& scene_;
  const BakedSkins& skins_;
  std::string meshes_, textures_;           ///< records, without the arrays' definitions
  std::string mesh_table_, texture_table_;  ///< initializers of the scene's members
  HeaderText out_;
};

}  // namespace

bool is_namespace(const std::string& name) {
  const auto lower = [](char c) { return c >= 'a' && c <= 'z'; };
  if (name.empty() || !lower(name[0]) || name.back() == '_' || name.find("__") != std::string::npos) return false;
  const auto allowed = [&](char c) { return lower(c) || (c >= '0' && c <= '9') || c == '_'; };
  // Two namespaces, the keywords of C++20 (N4861, 5.11) and the other spellings of operators.
  constexpr std::string_view kTaken =
      " std zstrip "
      "alignas alignof asm auto bool break case catch char char8_t char16_t char32_t class concept const consteval "
      "constexpr constinit const_cast continue co_await co_return co_yield decltype default delete do double "
      "dynamic_cast else enum explicit export extern false float for friend goto if inline int long mutable namespace "
      "new noexcept nullptr operator private protected public register reinterpret_cast requires return short signed "
      "sizeof static static_assert static_cast struct switch template this thread_local throw true try typedef typeid "
      "typename union unsigned using virtual void volatile wchar_t while "
      "and and_eq bitand bitor compl not not_eq or or_eq xor xor_eq ";
  return std::all_of(name.begin(), name.end(), allowed) &&
         kTaken.find(fmt::format(" {} ", name)) == std::string_view::npos;
}

std::string to_scene_header(const BakedScene& baked, const std::string& name_space) {
  return Header(baked).text(name_space);
}

}  // namespace zstrip::sim
