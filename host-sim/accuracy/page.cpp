// Writes a complete static HTML page; the script (page/page.js) only makes it easier to read.
#include "accuracy/page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <mutex>

#include "accuracy/heat_map.hpp"
#include "accuracy/page_files.hpp"
#include "accuracy/plot.hpp"
#include "image/rgb_png.hpp"
#include "render/parallel.hpp"
#include "text/html.hpp"
#include "text/number.hpp"

namespace zstrip::sim {
namespace {

template <class Pixel, class ToRgb>
Result<std::vector<std::uint8_t>> png_of(const View& view, const std::vector<Pixel>& pixels, const ToRgb& to_rgb) {
  RgbImage image{view.width, view.height, {}};
  for (const Pixel& pixel : pixels) {
    for (const auto channel : to_rgb(pixel)) image.rgb.push_back(static_cast<std::uint8_t>(channel));
  }
  return encode_rgb_png(image);
}

std::string figure_text(double value) {
  if (std::isnan(value)) return "–";
  if (std::abs(value) < 1e-7) return "0";  // the rounding error of double arithmetic
  if (value == std::floor(value) && std::abs(value) < 1e6) return fmt::format("{:.0f}", value);
  return std::abs(value) >= 100 ? fmt::format("{:.0f}", value) : fmt::format("{:.3g}", value);
}

std::string fps_text(const Cost& cost) {
  if (!cost.least_fps) return "–";
  return fmt::format("{:.1f}–{:.1f}", *cost.least_fps, *cost.most_fps);
}

std::string table(const PageScene& scene) {
  const Campaign& campaign = scene.campaign;
  const bool board = campaign.request.target != "host";
  std::string html = "<div class=\"wide\"><table><thead><tr><th>settings</th><th>" +
                     std::string(board ? "instructions" : "µs") + "</th>" +
                     (board ? "<th title=\"predicted of a board\">frames/s</th><th>program</th>" : "") +
                     "<th>RAM</th><th>scene</th>";
  for (const FigureInfo& figure : figures()) {
    html +=
        fmt::format("<th title=\"{}\">{}<br><small>{}</small></th>", escaped(figure.meaning), figure.name, figure.unit);
  }
  html += "</tr></thead><tbody>\n";
  const AccuracyPoint* best = recommended(campaign);
  for (std::size_t i = 0; i < campaign.points.size(); ++i) {
    const AccuracyPoint& point = campaign.points[i];
    const std::string group = group_of(point);
    html += fmt::format(
        "<tr data-point=\"{}\" data-group=\"{}\" data-front=\"{}\"><th><i style=\"background:{}\"></i>{}{}{}"
        "<code>{}</code></th>",
        i, group, point.on_front ? 1 : 0, colour_of_group(group), escaped(to_text(point.settings)),
        point.on_front ? " <b title=\"on the front\">●</b>" : "",
        &point == best ? " <b class=\"best\">recommended</b>" : "", escaped(command_of(point, campaign.request)));
    html += board
                ? fmt::format("<td>{}</td><td>{}</td><td>{}</td>", grouped(*point.cost.instructions),
                              fps_text(point.cost), point.cost.program_bytes ? grouped(*point.cost.program_bytes) : "–")
                : fmt::format("<td>{:.0f}</td>", point.cost.nanoseconds / 1000);
    html += fmt::format("<td>{}</td><td>{}</td>", grouped(point.cost.ram_bytes), grouped(point.cost.scene_bytes));
    for (const double value : point.errors.value) html += "<td>" + figure_text(value) + "</td>";
    html += "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

/// The causes of the error, with the default and with other values of the knobs that change them.
std::string causes_table(const Campaign& campaign) {
  if (campaign.causes.empty()) return "";
  std::string html =
      "<h3>Where the error comes from</h3><p>Each stage of drawing alone as coarse as the renderer's, all others "
      "exact, "
      "against one exact sample in the middle of each pixel; aliasing is that sample against 16.</p>\n"
      "<div class=\"wide causes\"><table><thead><tr><th>cause</th><th>settings</th>";
  for (const FigureInfo& figure : figures())
    html +=
        fmt::format("<th title=\"{}\">{}<br><small>{}</small></th>", escaped(figure.meaning), figure.name, figure.unit);
  html += "</tr></thead><tbody>\n";
  for (const CauseErrors& found : campaign.causes) {
    const CauseInfo& cause = info(found.of.cause);
    html += fmt::format("<tr data-cause=\"{}\"><th title=\"{}\">{}</th><th>{}</th>", cause.name, escaped(cause.meaning),
                        cause.name, escaped(to_text(found.of.settings)));
    for (const double value : found.errors.value) html += "<td>" + figure_text(value) + "</td>";
    html += "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

std::string scene_json(const PageScene& scene) {
  std::string text = fmt::format("{{\"width\":{},\"height\":{},\"points\":[", scene.campaign.request.view.width,
                                 scene.campaign.request.view.height);
  for (std::size_t i = 0; i < scene.campaign.points.size(); ++i) {
    const AccuracyPoint& point = scene.campaign.points[i];
    std::string object = point_json(point);
    object.back() = ',';
    text += fmt::format("{}{}\"group\":\"{}\",\"time\":{},\"front\":{}}}", i == 0 ? "" : ",", object, group_of(point),
                        time_of(point), point.on_front);
  }
  text += "],\"causes\":[";
  for (std::size_t i = 0; i < scene.campaign.causes.size(); ++i) {
    const auto& [of, errors] = scene.campaign.causes[i];
    text += fmt::format("{}{{\"cause\":\"{}\",\"perceived\":{:.4g},\"knobs\":{{", i == 0 ? "" : ",",
                        info(of.cause).name, errors[Figure::perceived]);
    std::string_view comma;
    for (const Knob knob : info(of.cause).knobs) {
      text += fmt::format("{}\"{}\":\"{}\"", comma, info(knob).name, of.settings.name_of(knob));
      comma = ",";
    }
    text += "}}";
  }
  text += "],\"truth\":\"" + data_url(scene.truth) + "\",\"pictures\":{";
  for (std::size_t i = 0; i < scene.pictures.size(); ++i) {
    const PointPictures& p = scene.pictures[i];
    text += fmt::format("{}\"{}\":{{\"drawn\":\"{}\",\"heat\":\"{}\"}}", i == 0 ? "" : ",", p.point, data_url(p.drawn),
                        data_url(p.heat));
  }
  text += "}}";
  // Escapes text that could end the enclosing element.
  std::string safe;
  for (const char c : text) safe += c == '<' ? "\\u003c" : std::string(1, c);
  return safe;
}

/// The default and its truth, for browsers without the script.
std::string default_pictures(const PageScene& scene) {
  for (const PointPictures& p : scene.pictures) {
    if (scene.campaign.points[p.point].settings != Settings{}) continue;
    const auto figure = [](const std::string& url, std::string_view text) {
      return fmt::format("<figure><img src=\"{}\" alt=\"{}\"><figcaption>{}</figcaption></figure>", url, text, text);
    };
    return "<div class=\"pictures\">" + figure(data_url(p.drawn), "default settings") +
           figure(data_url(scene.truth), "truth, 16 samples a pixel") +
           figure(data_url(p.heat), "visible error: black none, red 2, yellow 9, white 20 units") + "</div>\n";
  }
  return "";
}

}  // namespace

Result<PageScene> with_pictures(const AccuracyScene& scene, Campaign campaign, unsigned jobs) {
  PageScene page{std::move(campaign), {}, {}};
  std::vector<std::size_t> wanted;
  for (std::size_t i = 0; i < page.campaign.points.size(); ++i) {
    const AccuracyPoint& point = page.campaign.points[i];
    const bool strips_only = group_of(point) == "strips";  // the same picture as the default
    if ((point.part == "one" && !strips_only) || point.on_front) wanted.push_back(i);
  }
  const View& view = page.campaign.request.view;
  Result<std::vector<std::uint8_t>> truth = png_of(view, scene.true_picture(), [](const auto& pixel) { return pixel; });
  if (!truth) return truth.failure();
  page.truth = std::move(*truth);
  page.pictures.resize(wanted.size());
  const Result<Done> drawn =
      for_each_on_threads(static_cast<std::uint32_t>(wanted.size()), jobs, [&](unsigned, std::uint32_t index) {
        AccuracyPictures pictures;
        const Result<Errors> errors = scene.errors(page.campaign.points[wanted[index]].settings, &pictures);
        if (!errors) return Result<Done>(errors.failure());
        Result<std::vector<std::uint8_t>> picture =
            png_of(view, pictures.drawn, [](const auto& pixel) { return pixel; });
        if (!picture) return Result<Done>(picture.failure());
        Result<std::vector<std::uint8_t>> heat = png_of(view, pictures.heat, heat_colour);
        if (!heat) return Result<Done>(heat.failure());
        page.pictures[index] = {wanted[index], std::move(*picture), std::move(*heat)};
        return Result<Done>(Done{});
      });
  if (!drawn) return drawn.failure();
  return page;
}

std::string command_of(const AccuracyPoint& point, const AccuracyRequest& request) {
  return fmt::format("zstrip accuracy {} --target {} --size {}x{} --frames {} --only {} -o out/accuracy", request.scene,
                     request.target, request.view.width, request.view.height, request.frames, to_text(point.settings));
}

std::string accuracy_page(const std::vector<PageScene>& scenes) {
  std::string html = fmt::format(
      "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
      "content=\"width=device-width\"><title>zstrip: what accuracy costs</title>\n<style>{}</style></head><body>\n"
      "<header><h1>What accuracy costs</h1><p>Each point is a way to draw the scene: to the left faster, lower closer "
      "to "
      "the truth, which a rasteriser in double precision draws with 16 samples a pixel. The area of a point is its "
      "RAM. "
      "Black rims are points that no other beats in time, error and RAM at once; the dashed line is the best error for "
      "each time. Recommended (red ring): the fastest that looks no worse than the default by more than 5 % and takes "
      "no "
      "more RAM.</p></header>\n<nav id=\"filters\"></nav>\n",
      page_files::kStyle);
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const PageScene& scene = scenes[i];
    const AccuracyRequest& request = scene.campaign.request;
    html += fmt::format("<section class=\"scene\" data-scene=\"{}\"><h2>{} <small>{}x{}, {}, {} poses</small></h2>\n",
                        i, escaped(request.scene), request.view.width, request.view.height, time_label(scene.campaign),
                        request.frames);
    html += "<div class=\"show\"><div class=\"figure\">" + plot_svg(scene.campaign) + "</div><div class=\"detail\">" +
            default_pictures(scene) + "</div></div>\n" + table(scene) + causes_table(scene.campaign);
    html += fmt::format("<script type=\"application/json\" class=\"data\">{}</script></section>\n", scene_json(scene));
  }
  html += "<section class=\"words\"><h2>Knobs</h2><dl>";
  for (const KnobInfo& knob : knobs()) {
    html += fmt::format("<dt>{}</dt><dd>{}: ", knob.name, knob.meaning);
    for (const KnobValue& value : knob.values) {
      html +=
          fmt::format("{}<b>{}</b> {}", &value == knob.values.data() ? "" : "; ", value.name, escaped(value.meaning));
    }
    html += "</dd>";
  }
  html += "</dl><h2>Causes</h2><dl>";
  for (const CauseInfo& cause : causes()) {
    html += fmt::format("<dt>{}</dt><dd>{}</dd>", cause.name, escaped(cause.meaning));
  }
  html += "</dl><h2>Figures</h2><dl>";
  for (const FigureInfo& figure : figures()) {
    html += fmt::format("<dt>{}</dt><dd>{}, in {}</dd>", figure.name, escaped(figure.meaning), figure.unit);
  }
  return html + fmt::format("</dl></section>\n<script>{}</script></body></html>\n", page_files::kScript);
}

}  // namespace zstrip::sim
