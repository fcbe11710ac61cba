// The figures of a frame as JSON, and the words that reports share.
#include <nlohmann/json.hpp>

#include "image/to_rgb.hpp"
#include "report/frame_record.hpp"
#include "report/heat_json.hpp"
#include "report/ram_json.hpp"

namespace zstrip::sim {

nlohmann::ordered_json heat_json(const HeatFigures& figures) {
  return {{"mean", figures.mean},
          {"worst", figures.worst},
          {"worst_x", figures.worst_x},
          {"worst_y", figures.worst_y},
          {"seen_percent", figures.seen_percent}};
}

nlohmann::ordered_json ram_bytes(const FrameReport& report) {
  const Plan& plan = report.plan;
  return {
      {"instances", plan.instance_bytes}, {"extents", plan.extent_bytes}, {"vertices", plan.vertex_bytes},
      {"depth", plan.depth_bytes},        {"colour", plan.colour_bytes},  {"bins", plan.bin_bytes},
      {"effects", plan.effect_bytes},     {"arena", plan.bytes()},        {"strip_pixels", report.strip_pixel_bytes}};
}

std::string format_words(const View& view) {
  std::string words = name(view.format);
  if (view.dither) words += " dithered";
  if (view.samples != 1) words += ", " + std::to_string(view.samples) + " samples a pixel";
  return words;
}

const char* name(Mode mode) { return mode == Mode::binned ? "binned" : "streamed"; }

}  // namespace zstrip::sim
