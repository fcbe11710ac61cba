// The choices of `zstrip fit` as a table, as JSON and as a page.
#include "fit/fit_report.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "fit/bake_words.hpp"
#include "image/rgb_png.hpp"
#include "import/reduction.hpp"
#include "text/html.hpp"
#include "text/number.hpp"
#include "text/text.hpp"

namespace zstrip::sim {
namespace {

constexpr const char* kStyle =
    "body{margin:0 auto;max-width:1100px;padding:0 24px 48px;font:15px/1.5 system-ui,sans-serif;color:#1a1a1a;"
    "background:#fafafa}main{display:grid;grid-template-columns:repeat(auto-fill,minmax(240px,1fr));gap:20px}"
    "figure{margin:0;padding:8px;background:#fff;border:1px solid #ddd;border-radius:8px}"
    "figure.chosen{border-color:#d00}img{width:100%;display:block;image-rendering:pixelated}"
    "figcaption{font-size:13px;font-variant-numeric:tabular-nums;white-space:pre-line}";

double percent_off(const FitChoice& choice) {
  return 100.0 * static_cast<double>(choice.off) / (static_cast<double>(choice.picture.rgb.size()) / 3);
}

}  // namespace

std::string fit_table(const FitSearch& found, const BoardModel& board, std::size_t chosen) {
  std::string text =
      fmt::format("{} combinations tried for {}; listed: {} that fit and that no other beats in everything\n",
                  grouped(found.tried), board.description, grouped(found.choices.size()));
  text +=
      fmt::format("{:>5}  {:<18} {:>9} {:>10} {:>6}  {:<11} {:<5} {:>11} {:>9} {:>11} {:>6} {:>7}\n", "", "textures",
                  "triangles", "", "pixels", "smooth", "light", "flash", "RAM", "frames/s", "rms", "off");
  for (std::size_t i = 0; i < found.choices.size(); ++i) {
    const FitChoice& choice = found.choices[i];
    text +=
        fmt::format("{:>2} {:>2}  {:<18} {:>9} {:>10} {:>6.2f}  {:<11} {:<5} {:>11} {:>9} {:>11} {:>6.2f} {:>5.1f} %\n",
                    i == chosen ? "->" : "", i + 1, choice.textures, choice.triangles, grouped(choice.triangle_count),
                    choice.error_pixels, choice.smoothing, choice.arguments.lighting, grouped(choice.flash),
                    grouped(choice.ram), choice.rate.words(), choice.rms, percent_off(choice));
  }
  if (found.triangles_stay) text += fmt::format("More than half of the triangles stay: {}.\n", kTrianglesStay);
  return text +
         "Frames a second are an estimate; pixels: how far the surface moved, by the simplifier's measure; rms and "
         "pixels off by more than 24 of 255 are against the whole model. To bake the choice again:\n  " +
         printable(shell_line(bake_words(found.choices[chosen].arguments))) + '\n';
}

std::string fit_json(const FitSearch& found, const BoardModel& board, std::size_t chosen) {
  using Json = nlohmann::ordered_json;
  Json choices = Json::array();
  for (const FitChoice& choice : found.choices) {
    const ReductionArguments& reduction = choice.arguments.camera.reduction;
    Json one = {{"texture_size", nullptr},
                {"textures", choice.arguments.textures},
                {"triangles_option", reduction.triangles.value_or("100%")},
                {"triangles", choice.triangle_count},
                {"error_pixels", choice.error_pixels},
                {"lod", reduction.lod},
                {"lighting", choice.arguments.lighting},
                {"flash_bytes", choice.flash},
                {"ram_bytes", choice.ram},
                {"frames_per_second", {choice.rate.least, choice.rate.most}},
                {"rms", choice.rms},
                {"pixels_off", choice.off},
                {"samples", choice.arguments.plan.view.samples.value_or(1)},
                {"edges", choice.arguments.plan.view.edges.value_or(false)},
                {"bake", bake_words(choice.arguments)}};
    if (reduction.texture_size) one["texture_size"] = std::stoi(*reduction.texture_size);
    choices.push_back(std::move(one));
  }
  const Json object = {
      {"board", board.name}, {"tried", found.tried}, {"chosen", chosen + 1}, {"choices", std::move(choices)}};
  return object.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

Result<std::string> fit_page(const FitSearch& found, const BoardModel& board, std::size_t chosen) {
  const std::string name = std::filesystem::path(found.choices[chosen].arguments.scene).filename().string();
  const std::string title = escaped(fmt::format("{} on {}", printable(name), board.description));
  std::string html = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>{0}</title><style>{1}</style></head>"
      "<body><h1>{0}</h1><p>Frames a second are an estimate. Differences are against the whole model.</p><main>\n",
      title, kStyle);
  const auto add = [&html](const RgbImage& picture, const char* kind, const std::string& words) -> Result<Done> {
    const Result<std::vector<std::uint8_t>> png = encode_rgb_png(picture);
    if (!png) return png.failure();
    html += fmt::format("<figure{}><img src=\"{}\" alt=\"\"><figcaption>{}</figcaption></figure>\n", kind,
                        data_url(*png), escaped(words));
    return Done{};
  };
  if (const Result<Done> done = add(found.whole, "", "The whole model"); !done) return done.failure();
  for (std::size_t i = 0; i < found.choices.size(); ++i) {
    const FitChoice& choice = found.choices[i];
    const std::string words = fmt::format(
        "{}{}: textures {}\n{} ({}, {:.2f} pixels off){}\nflash {}, RAM {}\n{} frames/s\n"
        "rms {:.2f}, {:.1f} % of the pixels off by more than 24",
        i + 1, i == chosen ? ", chosen" : "", choice.textures, counted(choice.triangle_count, "triangle"),
        choice.triangles, choice.error_pixels,
        (choice.smoothing == "no" ? "" : ", " + choice.smoothing) + (choice.has_baked_light() ? ", light baked" : ""),
        grouped(choice.flash), grouped(choice.ram), choice.rate.words(), choice.rms, percent_off(choice));
    if (const Result<Done> done = add(choice.picture, i == chosen ? " class=\"chosen\"" : "", words); !done) {
      return done.failure();
    }
  }
  return html + "</main></body></html>\n";
}

}  // namespace zstrip::sim
