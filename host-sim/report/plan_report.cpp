// The table, the curve and the JSON of `zstrip plan`.
#include "report/plan_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "bench/board_estimate.hpp"
#include "image/to_rgb.hpp"
#include "report/frame_record.hpp"
#include "report/plan_words.hpp"
#include "text/number.hpp"
#include "text/text.hpp"
#include "visibility/methods.hpp"

namespace zstrip::sim {
namespace {

using Json = nlohmann::ordered_json;

struct Part {
  const char* name;
  std::uint32_t bytes;
  const char* what;
};

std::array<Part, 8> parts(const Plan& plan) {
  return {{{"instances", plan.instance_bytes, "compiled transforms and lights"},
           {"extents", plan.extent_bytes, "which strips each meshlet touches"},
           {"vertices", plan.vertex_bytes,
            plan.mode == Mode::binned ? "all transformed vertices" : "the meshlet being drawn"},
           {"depth", plan.depth_bytes, "z-buffer of a strip"},
           {"colour", plan.colour_bytes, "RGB565 strip, before it becomes the panel's pixels"},
           {"bins", plan.bin_bytes, "triangles waiting for their strip"},
           {"effects", plan.effect_bytes,
            "fog, light by place, the order of blended instances, billboards, environment maps, outlines, shadows, "
            "CSG, edges"},
           {"visibility", plan.visibility_bytes, "order of triangles, or bounds of depth"}}};
}

/// A length with three digits that count, without an exponent.
std::string length(double value) {
  const int before_point = static_cast<int>(std::floor(std::log10(std::max(value, 1e-12)))) + 1;
  return fmt::format("{:.{}f}", value, std::clamp(3 - before_point, 0, 12));
}

/// Returns the table of depth formats and the separations that they sort.
std::string depth_table(const DepthAdvice& depth) {
  std::string text = fmt::format("\n{:<10}  {:>5}  sorts surfaces this far apart\n{:<17}  {:<14} {}\n", "depth",
                                 "bytes", "", "at " + length(depth.nearest), "at " + length(depth.farthest));
  for (const FormatSeparation& format : depth.formats) {
    text += fmt::format("{:<10}  {:>5}  {:<14} {:<14}{}\n", name(format.format), depth_bytes(format.format),
                        length(format.at_nearest), length(format.at_farthest),
                        format.format == depth.advised ? "  <- the cheapest that is enough" : "");
  }
  return text + fmt::format("Needed at {}: {}.\n", length(depth.farthest), length(depth.needed));
}

/// Layers keep pixels of one sample, with their depth.
bool has_layer(const PlanRequest& request, const PlanChoice& choice) {
  return request.view.samples == 1 && choice.kept.possible;
}

std::string layer_table(const KeptFrames& kept) {
  std::string text =
      fmt::format("\nas a static layer, {} frames of a rotation, each kept alone\n{:>10}  {:>10}  {:>10}\n",
                  kept.frames, "largest", "average", "any");
  const auto row = [&](const KeptBytes& bytes, const std::string& what) {
    text += fmt::format("{:>10}  {:>10}  {:>10}  {}\n", grouped(bytes.largest), grouped(bytes.average),
                        grouped(bytes.worst), what);
  };
  row(kept.depth, fmt::format("pool for depth in {}", name(kept.format)));
  row(kept.colour, "pool for colour");
  row({kept.dirty, kept.dirty, kept.dirty}, "dirty tiles");
  return text;
}

std::string millions(std::uint64_t instructions) {
  return fmt::format("{:.2f} M", static_cast<double>(instructions) / 1e6);
}

std::string curve(const PlanChoice& choice, const View& view) {
  constexpr std::size_t kWidth = 32;
  const Alternative& chosen = choice.chosen;
  std::vector<Alternative> points = choice.curve;
  if (std::none_of(points.begin(), points.end(),
                   [&](const Alternative& point) { return point.total_bytes == chosen.total_bytes; })) {
    points.push_back(chosen);
    std::stable_sort(points.begin(), points.end(),
                     [](const Alternative& a, const Alternative& b) { return a.total_bytes < b.total_bytes; });
  }
  std::uint64_t slowest = 1;
  for (const Alternative& point : points) slowest = std::max(slowest, point.instructions);
  std::string text = fmt::format("\n{:>10}  {:<34} {:>12}\n", "bytes", "plan", "instructions");
  for (const Alternative& point : points) {
    const std::size_t length = std::max<std::size_t>(1, kWidth * point.instructions / slowest);
    text += fmt::format("{:>10}  {:<34} {:>12}  {}{}\n", grouped(point.total_bytes), shape(point.plan, view),
                        millions(point.instructions), std::string(length, '#'),
                        point.total_bytes == chosen.total_bytes ? "  <- this plan" : "");
  }
  // The planner has counts only; what the frame did may differ.
  const Alternative* best = &chosen;
  for (const Alternative& point : points) {
    if (point.total_bytes < chosen.total_bytes && point.instructions < best->instructions) best = &point;
  }
  if (best != &chosen) {
    text += fmt::format("This scene is drawn faster in {} bytes: allow the planner no more than that.\n",
                        grouped(best->total_bytes));
  }
  return text;
}

std::vector<BoardRate> rates_of(const PlanRequest& request, const PlanChoice& choice) {
  std::vector<BoardRate> rates;
  for (const BoardModel& board : board_models()) {
    rates.push_back(
        rate_on(board, board.spi_mhz,
                {.plan = choice.chosen.plan, .view = request.view, .instructions = choice.chosen.instructions}));
  }
  return rates;
}

std::string rates_text(const PlanRequest& request, const PlanChoice& choice) {
  std::vector<std::string> rates, too_small;
  for (const BoardRate& rate : rates_of(request, choice)) {
    (rate.fits() ? rates : too_small).push_back(fmt::format("{} {}", rate.board, rate.words()));
  }
  std::string text = "Estimated frames a second with this plan, one core drawing: ";
  text += rates.empty() ? "no board has the memory.\n" : fmt::format("{}.\n", fmt::join(rates, ", "));
  if (!too_small.empty()) text += fmt::format("Boards with too little memory: {}.\n", fmt::join(too_small, ", "));
  return text;
}

Json rates_json(const PlanRequest& request, const PlanChoice& choice) {
  Json rates = Json::array();
  for (const BoardRate& rate : rates_of(request, choice)) {
    rates.push_back({{"board", rate.board}, {"needed_ram", rate.needed_ram}, {"frames_a_second", nullptr}});
    if (rate.fits()) rates.back()["frames_a_second"] = {{"least", rate.least}, {"most", rate.most}};
  }
  return rates;
}

Json to_object(const Alternative& alternative, const LayerBytes& layer) {
  const Plan& plan = alternative.plan;
  Json bytes;
  for (const Part& part : parts(plan)) bytes[part.name] = part.bytes;
  bytes["arena"] = plan.bytes();
  bytes["layer"] = layer.sum();
  bytes["total"] = alternative.total_bytes;
  return {{"mode", name(plan.mode)},
          {"strips", plan.strips},
          {"strip_rows", plan.strip_rows},
          {"strip_columns", plan.strip_columns},
          {"bytes", bytes},
          {"estimated_m3_instructions", alternative.instructions},
          {"bins_overflowed", alternative.overflowed}};
}

}  // namespace

std::string plan_table(const std::string& scene, const PlanRequest& request, const PlanChoice& choice) {
  const Alternative& chosen = choice.chosen;
  std::string text =
      fmt::format("{}, {}x{} {}: {}, {}, {}\n", printable(scene), request.view.width, request.view.height,
                  format_words(request.view), counted(choice.counts.triangles, "triangle"),
                  counted(choice.counts.meshlets, "meshlet"), counted(choice.counts.instances, "instance"));
  text += fmt::format("plan: {}{}\n\n", shape(chosen.plan, request.view),
                      chosen.overflowed ? "; its bins overflow, so that frames like this one are streamed" : "");
  if (request.depth) text += fmt::format("depth: {}, chosen\n\n", name(choice.depth_format));
  if (request.method != Effects{}) text += fmt::format("{}\n\n", visibility_words(chosen.plan, request.method));
  for (const Part& part : parts(chosen.plan)) {
    if (part.bytes != 0) text += fmt::format("{:>10}  {:<12} {}\n", grouped(part.bytes), part.name, part.what);
  }
  text += fmt::format("{:>10}  {:<12} {}\n", grouped(chosen.plan.bytes()), "arena", "the sum");
  if (request.budget.strip_buffers != 0) {
    text +=
        fmt::format("{:>10}  {:<12} {} for the display\n",
                    grouped(std::uint64_t{request.budget.strip_buffers} * chosen.plan.strip_pixel_bytes(request.view)),
                    "pixels", counted(request.budget.strip_buffers, "strip buffer"));
  }
  if (request.budget.layer.sum() != 0) {
    text += fmt::format("{:>10}  {:<12} pools and dirty tiles\n", grouped(request.budget.layer.sum()), "layer");
  }
  text += fmt::format(
      "{:>10}  {:<12} {}\n", grouped(chosen.total_bytes), "total",
      request.budget.bytes == 0 ? "no limit given" : fmt::format("of {} allowed", grouped(request.budget.bytes)));
  if (choice.moved_bytes != 0) {
    text += fmt::format("{:>10}  {:<12} vertices that move, joints and weights, in addition\n",
                        grouped(choice.moved_bytes), "moved");
  }
  if (choice.level_bytes != 0) {
    text += fmt::format("{:>10}  {:<12} instances, whose levels change, in addition\n", grouped(choice.level_bytes),
                        "detail");
  }
  text += fmt::format("{:>10}  {:<12} of the scene; a program adds its code\n", grouped(choice.flash_bytes), "flash");
  text += curve(choice, request.view);
  if (choice.depth) text += depth_table(*choice.depth);
  if (has_layer(request, choice)) text += layer_table(choice.kept);
  text +=
      "Instructions of a frame on a Cortex-M3 are estimated from the work of the first frame; zstrip bench counts.\n";
  const std::vector<std::string> left_out = left_out_of_estimates(choice.effects);
  if (!left_out.empty()) text += fmt::format("The estimate leaves out: {}.\n", fmt::join(left_out, ", "));
  return text + rates_text(request, choice);
}

std::string plan_json(const std::string& scene, const PlanRequest& request, const PlanChoice& choice) {
  Json curve = Json::array();
  for (const Alternative& point : choice.curve) curve.push_back(to_object(point, request.budget.layer));
  Json depth = nullptr;
  if (choice.depth) {
    Json formats = Json::array();
    for (const FormatSeparation& format : choice.depth->formats) {
      formats.push_back(
          {{"format", name(format.format)}, {"at_nearest", format.at_nearest}, {"at_farthest", format.at_farthest}});
    }
    depth = {{"nearest", choice.depth->nearest},
             {"farthest", choice.depth->farthest},
             {"needed_separation", choice.depth->needed},
             {"advised_format", name(choice.depth->advised)},
             {"separations", formats}};
  }
  const auto pool = [](const KeptBytes& bytes) {
    return Json{{"largest", bytes.largest}, {"average", bytes.average}, {"worst", bytes.worst}};
  };
  Json object = {{"scene", scene},
                 {"width", request.view.width},
                 {"height", request.view.height},
                 {"format", name(request.view.format)},
                 {"dither", request.view.dither},
                 {"samples", request.view.samples},
                 {"visibility", visibility_name(request.method)},
                 {"depth_format", name(choice.depth_format)},
                 {"strip_buffers", request.budget.strip_buffers},
                 {"counts",
                  {{"instances", choice.counts.instances},
                   {"triangles", choice.counts.triangles},
                   {"vertices", choice.counts.vertices},
                   {"meshlets", choice.counts.meshlets},
                   {"largest_meshlet", choice.counts.largest_meshlet},
                   {"longest_meshlet", choice.counts.longest_meshlet}}},
                 {"estimate_leaves_out", left_out_of_estimates(choice.effects)},
                 {"flash_bytes", choice.flash_bytes},
                 {"moved_bytes", choice.moved_bytes},
                 {"level_bytes", choice.level_bytes},
                 {"boards", rates_json(request, choice)},
                 {"plan", to_object(choice.chosen, request.budget.layer)},
                 {"curve", curve},
                 {"depth", depth},
                 {"static_layer",
                  {{"frames", choice.kept.frames},
                   {"depth_format", name(choice.kept.format)},
                   {"depth_bytes", pool(choice.kept.depth)},
                   {"colour_bytes", pool(choice.kept.colour)},
                   {"dirty_bytes", choice.kept.dirty}}}};
  if (!has_layer(request, choice)) object["static_layer"] = nullptr;
  return object.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace zstrip::sim
