// The report of `zstrip bake` as JSON; the keys are documented in README.md.
#include <nlohmann/json.hpp>

#include "image/to_rgb.hpp"
#include "report/bake_report.hpp"
#include "report/frame_record.hpp"
#include "report/plan_words.hpp"
#include "visibility/methods.hpp"

namespace zstrip::sim {
namespace {

using Json = nlohmann::ordered_json;

}  // namespace

std::string bake_json(const BakeRecord& record) {
  const FlashBytes& flash = record.flash;
  const SceneCounts& counts = record.counts;
  const Plan& plan = record.plan;
  Json object = {{"scene", record.scene},
                 {"output", record.output},
                 {"width", record.view.width},
                 {"height", record.view.height},
                 {"format", name(record.view.format)},
                 {"dither", record.view.dither},
                 {"samples", record.view.samples},
                 {"warnings", record.warnings},
                 {"counts",
                  {{"instances", counts.instances},
                   {"materials", record.materials},
                   {"triangles", counts.triangles},
                   {"vertices", counts.vertices},
                   {"meshlets", counts.meshlets}}},
                 {"flash_bytes",
                  {{"positions", flash.positions},
                   {"normals", flash.normals},
                   {"colours", flash.colours},
                   {"texcoords", flash.texcoords},
                   {"triangles", flash.triangles},
                   {"meshlets", flash.meshlets},
                   {"edges", flash.edges},
                   {"textures", flash.texels},
                   {"joints", flash.joints},
                   {"morphs", flash.morphs},
                   {"keyframes", flash.keyframes},
                   {"tree", flash.tree},
                   {"tables", flash.tables},
                   {"total", flash.total()}}}};
  object["edges_left_out"] = record.edges_left_out;
  object["accuracy"] = nullptr;
  if (const auto& accuracy = record.accuracy) {
    object["accuracy"] = {{"size", accuracy->size},
                          {"position", accuracy->position},
                          {"normal_degrees", accuracy->normal},
                          {"texcoord_texels", accuracy->texcoord},
                          {"texel_channel", accuracy->texel}};
  }
  object["reduced"] = nullptr;
  if (const auto& reduced = record.reduced) {
    object["reduced"] = {{"triangles_before", reduced->in_file.triangles_before},
                         {"triangles", reduced->in_file.triangles},
                         {"error", reduced->in_file.error},
                         {"error_pixels", reduced->pixels}};
  }
  object["shrunk"] = nullptr;
  if (const auto& shrunk = record.shrunk) {
    object["shrunk"] = {
        {"textures", shrunk->textures}, {"texels_before", shrunk->texels_before}, {"texels", shrunk->texels}};
  }
  object["levels"] = nullptr;
  if (const auto& levels = record.levels) {
    object["levels"] = {
        {"coarser_meshes", levels->levels}, {"meshes", levels->meshes}, {"triangles", levels->triangles}};
  }
  object["light_baked"] = record.light_baked.value_or(0);
  object["palettes"] = Json::array();
  for (const PaletteRecord& palette : record.palettes) {
    object["palettes"].push_back({{"texture", palette.texture},
                                  {"bits", index_bits(palette.format)},
                                  {"bytes", palette.bytes},
                                  {"bytes_before", palette.bytes_before},
                                  {"largest_error", palette.errors.largest},
                                  {"mean_error", palette.errors.mean}});
  }
  object["palettes_would_save"] = record.palettes_would_save;
  object["mipmaps"] = Json::array();
  for (const MipmapRecord& mipmaps : record.mipmaps) {
    object["mipmaps"].push_back(
        {{"texture", mipmaps.texture}, {"smaller_levels", mipmaps.levels}, {"bytes", mipmaps.bytes}});
  }
  object["effects"] = Json::array();
  for (const FoundEffect& found : record.effects) {
    object["effects"].push_back({{"name", found.effect.name},
                                 {"reason", found.effect.called_for_by},
                                 {"materials", found.materials},
                                 {"origin", found.origin}});
  }
  object["clipping"] = nullptr;
  if (const auto& clipping = record.clipping) {
    object["clipping"] = {{"left_out", clipping->left_out}, {"poses", clipping->poses}, {"why", clipping->why}};
  }
  Json bytes;
  for (const auto& [purpose, size] : by_purpose(plan)) bytes[name(purpose)] = size;
  bytes["visibility"] = plan.visibility_bytes;
  bytes["arena"] = plan.bytes();
  bytes["strip_pixels"] = plan.strip_pixel_bytes(record.view);
  object["plan"] = {{"mode", name(plan.mode)},
                    {"strips", plan.strips},
                    {"strip_rows", plan.strip_rows},
                    {"strip_columns", plan.strip_columns},
                    {"strip_buffers", record.strip_buffers},
                    {"ram_bytes", bytes}};
  if (record.skin_ram.vertices > 0) {
    object["plan"]["ram_bytes"]["moved_vertices"] = record.skin_ram.vertices;
    object["plan"]["ram_bytes"]["joints"] = record.skin_ram.joints;
    object["plan"]["ram_bytes"]["weights"] = record.skin_ram.weights;
  }
  if (record.levels) object["plan"]["ram_bytes"]["instances"] = record.levels->ram;
  if (record.lent_bytes) object["plan"]["ram_bytes"]["lent_tables"] = *record.lent_bytes;
  if (const auto& method = record.method) {
    object["visibility"] = {
        {"method", visibility_name(method->method)}, {"splits", method->splits}, {"tree_nodes", method->nodes}};
  }
  if (const auto& sets = record.visible_sets) {
    object["visible_sets"] = {{"output", sets->output},     {"cells", sets->cells}, {"sets", sets->sets},
                              {"meshlets", sets->meshlets}, {"bytes", sets->bytes}, {"hidden", sets->hidden}};
  }
  return object.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace zstrip::sim
