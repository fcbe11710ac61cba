// The report of `zstrip bake`: bytes by kind and what they cost in accuracy, effects and why, the plan.
#include "report/bake_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "image/to_rgb.hpp"
#include "report/frame_record.hpp"
#include "report/plan_words.hpp"
#include "text/number.hpp"
#include "text/text.hpp"
#include "visibility/methods.hpp"

namespace zstrip::sim {
namespace {

/// "1/43,690", of something above 0.
std::string fraction(double part, double whole) {
  return fmt::format("1/{}", grouped(static_cast<std::uint64_t>(std::llround(whole / part))));
}

/// "at most 0.38 degrees off", or "exact".
std::string off_words(double worst, const char* unit) {
  return worst == 0 ? "exact" : fmt::format("at most {:.2g} {} off", worst, unit);
}

std::string position_words(const Accuracy& accuracy) {
  if (accuracy.position == 0) return "exact";
  return fmt::format("at most {:.3g} units off, {} of the model's size of {:.4g}", accuracy.position,
                     fraction(accuracy.position, accuracy.size), accuracy.size);
}

std::string flash_lines(const BakeRecord& record) {
  const FlashBytes& flash = record.flash;
  std::string text;
  const auto add = [&text](std::uint64_t bytes, const char* kind, const std::string& words) {
    if (bytes > 0) text += fmt::format("{:>21}  {}{}{}\n", grouped(bytes), kind, words.empty() ? "" : ": ", words);
  };
  const bool known = record.accuracy.has_value();
  const Accuracy accuracy = record.accuracy.value_or(Accuracy{});
  add(flash.positions, "positions", known ? position_words(accuracy) : "");
  add(flash.normals, "normals", known ? off_words(accuracy.normal, "degrees") : "");
  add(flash.colours, "vertex colours", "");
  add(flash.texcoords, "texture coordinates", known ? off_words(accuracy.texcoord, "texels") : "");
  add(flash.triangles, "triangles", "");
  add(flash.meshlets, "meshlets", "");
  add(flash.edges, "edges that are anti-aliased",
      record.edges_left_out == 0 ? "" : grouped(record.edges_left_out) + " that the motion never shows are left out");
  add(flash.texels, record.palettes.empty() ? "textures, RGB565" : "textures",
      known ? "a channel " + off_words(100 * accuracy.texel, "%") : "");
  add(flash.joints, "joints, and their weights at each vertex", "");
  add(flash.morphs, "morph targets", "");
  add(flash.keyframes, "keyframes of the animation", "");
  add(flash.tree, "tree of painter-bsp", counted(record.method.value_or(BakedMethodRecord{}).nodes, "node"));
  add(flash.tables, "tables of meshes, materials, textures, instances and lights, camera", "");
  return text;
}

/// "at most 8, 4, 8 of 255 off (red, green, blue), 1.2, 0.8, 2.1 on average", or "exact".
std::string palette_words(const TexelErrors& errors) {
  if (errors.largest == std::array<int, 3>{}) return "exact";
  return fmt::format("at most {} of 255 off (red, green, blue), {:.2f} on average", fmt::join(errors.largest, ", "),
                     fmt::join(errors.mean, ", "));
}

std::string palette_lines(const BakeRecord& record) {
  std::string text;
  for (const PaletteRecord& palette : record.palettes) {
    text += fmt::format("  {:<10} texture {}: {} colours, {} instead of {}: {}\n", text.empty() ? "palettes" : "",
                        palette.texture, 1 << index_bits(palette.format), grouped(palette.bytes),
                        counted(palette.bytes_before, "byte"), palette_words(palette.errors));
  }
  if (record.palettes_would_save > 0) {
    text += fmt::format(
        "  palettes   none; --textures auto would save {} of texels and change no pixel, but takes code "
        "and time for each fragment\n",
        counted(record.palettes_would_save, "byte"));
  }
  return text;
}

std::string mipmap_lines(const BakeRecord& record) {
  std::string text;
  for (const MipmapRecord& mipmaps : record.mipmaps) {
    text += fmt::format("  {:<10} texture {}: {} for {}\n", text.empty() ? "mipmaps" : "", mipmaps.texture,
                        counted(mipmaps.bytes, "byte"), counted(mipmaps.levels, "smaller level"));
  }
  return text;
}

std::string reduced_line(const BakeRecord& record) {
  if (!record.reduced) return "";
  const Reduced& reduced = record.reduced->in_file;
  return fmt::format("  reduced    {} of {} of the file, at most {:.3g} units off, {:.2g} pixels\n",
                     grouped(reduced.triangles), counted(reduced.triangles_before, "triangle"), reduced.error,
                     record.reduced->pixels);
}

std::string shrunk_line(const BakeRecord& record) {
  if (!record.shrunk) return "";
  if (record.shrunk->textures == 0) return "  shrunk     no texture: none has a longer side\n";
  return fmt::format("  shrunk     {}, {} of {} are left\n", counted(record.shrunk->textures, "texture"),
                     grouped(record.shrunk->texels), counted(record.shrunk->texels_before, "texel"));
}

std::string levels_lines(const BakeRecord& record) {
  if (!record.levels) return "";
  const LevelsRecord& levels = *record.levels;
  if (levels.levels == 0) return "  detail     no levels: no mesh can lose enough triangles without losing its shape\n";
  return fmt::format("  detail     {} for {}, with {}; {} of RAM for the instances\n",
                     counted(levels.levels, "coarser mesh"), counted(levels.meshes, "mesh"),
                     counted(levels.triangles, "triangle"), counted(levels.ram, "byte"));
}

std::string light_line(const BakeRecord& record) {
  if (!record.light_baked) return "";
  return fmt::format("  light      baked into vertices of {} of {}\n", grouped(*record.light_baked),
                     counted(record.counts.instances, "instance"));
}

std::string effect_lines(const BakeRecord& record) {
  std::string text;
  for (const FoundEffect& found : record.effects) {
    std::string why = found.effect.called_for_by;
    if (!found.materials.empty()) why += fmt::format(": material '{}'", printable(found.materials.front()));
    if (found.materials.size() > 1) why += fmt::format(" and {} more", grouped(found.materials.size() - 1));
    if (!found.origin.empty()) why += fmt::format(" in {}", printable(found.origin));
    text += fmt::format("  {:<10} {}: {}\n", text.empty() ? "effects" : "", found.effect.name, why);
  }
  return text.empty() ? "  effects    none\n" : text;
}

std::string clipping_line(const BakeRecord& record) {
  if (!record.clipping) return "";
  if (!record.clipping->left_out) return fmt::format("  clipping   stays: {}\n", record.clipping->why);
  return fmt::format("  clipping   left out: no instance comes near a plane of the camera {}\n",
                     record.clipping->where);
}

}  // namespace

LevelsRecord levels_record(const Scene& scene, std::span<const DetailLevel> levels) {
  LevelsRecord record{.levels = levels.size(), .ram = levels.empty() ? 0 : scene.instances.size_bytes()};
  for (std::size_t i = 0; i < levels.size(); ++i) {
    record.meshes += i == 0 || levels[i].mesh != levels[i - 1].mesh;
    record.triangles += scene.meshes[levels[i].coarser].triangles.size();
  }
  return record;
}

std::string bake_summary(const BakeRecord& record) {
  const SceneCounts& counts = record.counts;
  const Effects method = record.method ? record.method->method : Effects{};
  std::string text = fmt::format("{}: {} in {}, {}, {}\n", printable(record.scene),
                                 counted(counts.triangles, "triangle"), counted(counts.meshlets, "meshlet"),
                                 counted(counts.instances, "instance"), counted(record.materials, "material"));
  text += reduced_line(record) + shrunk_line(record) + levels_lines(record);
  text += fmt::format("  flash      {}\n", counted(record.flash.total(), "byte")) + flash_lines(record);
  text += palette_lines(record);
  text += mipmap_lines(record) + light_line(record);
  text += effect_lines(record);
  text += clipping_line(record);
  text += fmt::format("  picture    {}x{}, {}; {}\n", record.view.width, record.view.height, format_words(record.view),
                      shape(record.plan, record.view));
  text += fmt::format("  RAM        {}{}\n", memory(record.plan, record.plan.strip_pixel_bytes(record.view), method),
                      record.strip_buffers == 2 ? ", times 2 buffers" : "");
  if (const SkinRam& skin = record.skin_ram; skin.vertices > 0) {
    const auto part = [](std::uint64_t bytes, const char* of) {
      return bytes > 0 ? fmt::format(", {} for the {}", grouped(bytes), of) : std::string();
    };
    text += fmt::format("             and {} {}for the vertices that {} move{}{}\n", counted(skin.vertices, "byte"),
                        record.lent_bytes ? "to lend " : "",
                        skin.joints == 0    ? "morph targets"
                        : skin.weights == 0 ? "joints"
                                            : "joints and morph targets",
                        part(skin.joints, "joints"), part(skin.weights, "weights of morph targets"));
  }
  if (record.method) {
    text += fmt::format("  visibility {}; {}\n", visibility_words(record.plan, method),
                        record.method->splits == 0 ? "no triangle was cut"
                                                   : counted(record.method->splits, "cut") + " through triangles");
  }
  if (record.lent_bytes) {
    text += fmt::format("             and {} for tables of the opened blob (with addresses of 32 bits)\n",
                        counted(*record.lent_bytes, "byte"));
  }
  text += fmt::format("  written    {}\n", printable(record.output));
  if (const auto& sets = record.visible_sets) {
    text += fmt::format("  cells      {} with {} of {}; {:.1f} % of them left out, on average; {} in {}\n",
                        grouped(sets->cells), counted(sets->sets, "different set"), counted(sets->meshlets, "meshlet"),
                        100 * sets->hidden, counted(sets->bytes, "byte"), printable(sets->output));
  }
  return text;
}

}  // namespace zstrip::sim
