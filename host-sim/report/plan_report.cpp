// The table, the curve and the JSON of `zstrip plan`.
#include "report/plan_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "report/frame_record.hpp"
#include "report/number.hpp"
#include "report/plan_words.hpp"
#include "report/text.hpp"

namespace zstrip::sim {
namespace {

using Json = nlohmann::ordered_json;

struct Part {
  const char* name;
  std::uint32_t bytes;
  const char* what;
};

std::array<Part, 6> parts(const Plan& plan) {
  return {{{"instances", plan.instance_bytes, "compiled transforms and lights"},
           {"extents", plan.extent_bytes, "which strips each meshlet touches"},
           {"vertices", plan.vertex_bytes,
            plan.mode == Mode::binned ? "all transformed vertices" : "the meshlet being drawn"},
           {"depth", plan.depth_bytes, "z-buffer of a strip"},
           {"colour", plan.colour_bytes, "RGB565 strip, before it becomes the panel's format"},
           {"bins", plan.bin_bytes, "triangles waiting for their strip"}}};
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
  // The planner knows counts only; what the frame did may say otherwise.
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

Json to_object(const Alternative& alternative) {
  const Plan& plan = alternative.plan;
  Json bytes;
  for (const Part& part : parts(plan)) bytes[part.name] = part.bytes;
  bytes["arena"] = plan.bytes();
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
                  name(request.view.format), counted(choice.counts.triangles, "triangle"),
                  counted(choice.counts.meshlets, "meshlet"), counted(choice.counts.instances, "instance"));
  text += fmt::format("plan: {}{}\n\n", shape(chosen.plan, request.view),
                      chosen.overflowed ? "; its bins overflow, so that frames like this one are streamed" : "");
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
  text += fmt::format(
      "{:>10}  {:<12} {}\n", grouped(chosen.total_bytes), "total",
      request.budget.bytes == 0 ? "no limit given" : fmt::format("of {} allowed", grouped(request.budget.bytes)));
  text += curve(choice, request.view);
  text += "Instructions: a frame on a Cortex-M3, estimated from what the first frame does; zstrip bench measures.\n";
  return text;
}

std::string plan_json(const std::string& scene, const PlanRequest& request, const PlanChoice& choice) {
  Json curve = Json::array();
  for (const Alternative& point : choice.curve) curve.push_back(to_object(point));
  const Json object = {{"scene", scene},
                       {"width", request.view.width},
                       {"height", request.view.height},
                       {"format", name(request.view.format)},
                       {"strip_buffers", request.budget.strip_buffers},
                       {"counts",
                        {{"instances", choice.counts.instances},
                         {"triangles", choice.counts.triangles},
                         {"vertices", choice.counts.vertices},
                         {"meshlets", choice.counts.meshlets},
                         {"largest_meshlet", choice.counts.largest_meshlet},
                         {"longest_meshlet", choice.counts.longest_meshlet}}},
                       {"plan", to_object(choice.chosen)},
                       {"curve", curve}};
  return object.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace zstrip::sim
