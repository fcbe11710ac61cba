// Axes with logarithms, points, the front, names.
#include "accuracy/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace zstrip::sim {
namespace {

constexpr double kWidth = 760, kHeight = 430;
constexpr double kLeft = 62, kRight = 20, kTop = 14, kBottom = 52;
constexpr double kTitle = 18, kLegendLine = 20;  // title and legend of a file, above the axes

struct Group {
  std::string_view name, colour;
};
// Okabe and Ito's colours.
constexpr std::array<Group, 12> kGroups{{{"default", "#111111"},
                                         {"depth", "#0072b2"},
                                         {"fit", "#56b4e9"},
                                         {"shading", "#e69f00"},
                                         {"perspective", "#009e73"},
                                         {"filter", "#7f5aa8"},
                                         {"detail", "#d55e00"},
                                         {"format", "#cc79a7"},
                                         {"dither", "#6b705c"},
                                         {"strips", "#b8a500"},
                                         {"samples", "#8c564b"},
                                         {"several", "#9a9a9a"}}};

/// A logarithmic axis from below the least to above the largest value.
class Axis {
 public:
  Axis(double least, double most, double from, double to) : from_(from), to_(to) {
    low_ = std::log10(std::max(least, 1e-6)) - 0.06;
    high_ = std::log10(std::max(most, 1e-6)) + 0.06;
    if (high_ - low_ < 0.2) low_ -= 0.1, high_ += 0.1;
  }
  double at(double value) const {
    return from_ + (std::log10(std::max(value, 1e-6)) - low_) / (high_ - low_) * (to_ - from_);
  }
  /// Returns 1, 2 and 5 of each decade; in short ranges all tenths.
  std::vector<double> ticks() const {
    std::vector<double> found;
    for (int decade = static_cast<int>(std::floor(low_)); decade <= static_cast<int>(std::ceil(high_)); ++decade) {
      for (int digit = 1; digit < 10; ++digit) {
        if (high_ - low_ > 0.7 && digit != 1 && digit != 2 && digit != 5) continue;
        const double value = digit * std::pow(10, decade);
        if (std::log10(value) >= low_ && std::log10(value) <= high_) found.push_back(value);
      }
    }
    return found;
  }

 private:
  double low_, high_, from_, to_;
};

std::string short_number(double value) {
  if (value >= 1e6) return fmt::format("{:g} M", value / 1e6);
  if (value >= 1e3) return fmt::format("{:g} k", value / 1e3);
  return fmt::format("{:g}", value);
}

double error_of(const AccuracyPoint& point) { return point.errors[Figure::perceived]; }

/// Returns "flat", "strips 4"; settings of several knobs have a name if they are a preset.
std::string short_name(const AccuracyPoint& point) {
  for (const NamedSettings& named : named_settings()) {
    if (named.settings == point.settings && group_of(point) == "several") return std::string(named.name);
  }
  if (group_of(point) == "several") return "";
  for (const KnobInfo& knob : knobs()) {
    if (point.settings[knob.knob] == 0) continue;
    const std::string_view value = point.settings.name_of(knob.knob);
    const bool clear = knob.knob == Knob::depth || knob.knob == Knob::shading || knob.knob == Knob::filter ||
                       knob.knob == Knob::format || value == "affine";
    return clear ? std::string(value) : fmt::format("{} {}", knob.name, value);
  }
  return "default";
}

/// A coloured dot and a name for each varied knob, in as many lines as they need.
struct Legend {
  std::string svg;
  int lines = 1;
};
Legend legend_of(const Campaign& campaign) {
  struct Entry {
    Group group;
    double x;
    int line;
  };
  Legend legend;
  std::vector<Entry> entries;
  double x = kLeft + 6;
  for (const Group& group : kGroups) {
    const bool used =
        std::ranges::any_of(campaign.points, [&](const AccuracyPoint& point) { return group_of(point) == group.name; });
    if (!used) continue;
    const double width = 24 + 6.6 * static_cast<double>(group.name.size());
    if (x + width > kWidth) x = kLeft + 6, ++legend.lines;
    entries.push_back({group, x, legend.lines});
    x += width;
  }
  for (const Entry& entry : entries) {
    const double y = kLegendLine * (entry.line - legend.lines) - 6;
    legend.svg += fmt::format(
        "<circle cx=\"{:.1f}\" cy=\"{}\" r=\"5\" fill=\"{}\"/><text x=\"{:.1f}\" y=\"{}\" fill=\"#222\">{}</text>\n",
        entry.x, y - 4, entry.group.colour, entry.x + 9, y, entry.group.name);
  }
  return legend;
}

/// Draws the scene and the legend above the axes, in a height of `above`.
std::string head(const Campaign& campaign, const Legend& legend, double above) {
  return fmt::format(
             "<rect y=\"{}\" width=\"{}\" height=\"{}\" fill=\"#fff\"/><text x=\"{}\" y=\"{}\" font-size=\"15\" "
             "font-weight=\"600\" fill=\"#111\">{}</text>\n",
             -above, kWidth, kHeight + above, kLeft, kTitle - above, scene_name(campaign.request)) +
         legend.svg;
}

/// Writes the names of the default and of points with one changed knob; of coinciding points only the first that fits.
std::string names(const Campaign& campaign, const Axis& x, const Axis& y) {
  std::string svg;
  std::vector<std::array<double, 2>> taken;
  const auto add = [&](const AccuracyPoint& point, std::string_view weight) {
    const double at_x = x.at(time_of(point)), at_y = y.at(error_of(point));
    const bool free = std::ranges::none_of(taken, [&](const std::array<double, 2>& other) {
      return std::abs(other[0] - at_x) < 13 && std::abs(other[1] - at_y) < 50;
    });
    if (!free) return;
    taken.push_back({at_x, at_y});
    // Upwards from the point, or downwards if there is no room.
    const double angle = at_y < kTop + 80 ? 60 : -60;
    svg += fmt::format(
        "<text transform=\"translate({:.1f} {:.1f}) rotate({})\" x=\"13\" y=\"4\" font-size=\"11\" font-weight=\"{}\" "
        "fill=\"#222\" paint-order=\"stroke\" stroke=\"#fff\" stroke-width=\"3\">{}</text>\n",
        at_x, at_y, angle, weight, short_name(point));
  };
  for (const AccuracyPoint& point : campaign.points) {
    if (point.settings == Settings{}) add(point, "700");
  }
  for (const AccuracyPoint& point : campaign.points) {
    if (point.settings != Settings{} && !short_name(point).empty()) add(point, "400");
  }
  return svg;
}

}  // namespace

std::string group_of(const AccuracyPoint& point) {
  std::string group = "default";
  for (const KnobInfo& knob : knobs()) {
    if (point.settings[knob.knob] == 0) continue;
    group = group == "default" ? std::string(knob.name) : "several";
  }
  return group;
}

std::string_view colour_of_group(std::string_view group) {
  return std::ranges::find(kGroups, group, &Group::name)->colour;
}

const AccuracyPoint* recommended(const Campaign& campaign) {
  const auto standard = std::ranges::find(campaign.points, Settings{}, &AccuracyPoint::settings);
  if (standard == campaign.points.end()) return nullptr;
  const AccuracyPoint* best = &*standard;
  for (const AccuracyPoint& point : campaign.points) {
    const bool fine = error_of(point) <= 1.05 * error_of(*standard) &&
                      point.errors[Figure::wrong_pixels] <= 1.05 * standard->errors[Figure::wrong_pixels] &&
                      point.cost.ram_bytes <= standard->cost.ram_bytes;
    // Instructions are exact, but a gain of one percent is too small for a recommendation; the times of a clock vary.
    const double gain = point.cost.instructions ? 0.98 : 0.95;
    if (fine && time_of(point) < gain * time_of(*best)) best = &point;
  }
  return best;
}

std::string time_label(const Campaign& campaign) {
  if (campaign.request.target == "host") return "nanoseconds a frame on this machine";
  return fmt::format("instructions a frame on {}", campaign.request.target == "m0"   ? "Cortex-M0"
                                                   : campaign.request.target == "m3" ? "Cortex-M3"
                                                                                     : "Cortex-M4F");
}

namespace {

std::string plot(const Campaign& campaign, bool alone) {
  const std::vector<AccuracyPoint>& points = campaign.points;
  std::vector<double> times, errors, ram;
  for (const AccuracyPoint& point : points) {
    times.push_back(time_of(point));
    errors.push_back(error_of(point));
    ram.push_back(static_cast<double>(point.cost.ram_bytes));
  }
  const Axis x(*std::ranges::min_element(times), *std::ranges::max_element(times), kLeft, kWidth - kRight);
  const Axis y(*std::ranges::min_element(errors), *std::ranges::max_element(errors), kHeight - kBottom, kTop);
  const double most_ram = *std::ranges::max_element(ram);

  const Legend legend = alone ? legend_of(campaign) : Legend{};
  const double above = alone ? kTitle + 8 + kLegendLine * legend.lines : 0;
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"plot\" viewBox=\"0 {0} {1} {2}\" width=\"{1}\" "
      "height=\"{2}\" font-family=\"system-ui, sans-serif\" font-size=\"12\" role=\"img\"><title>{3}: time against "
      "visible error</title>\n",
      -above, kWidth, kHeight + above, scene_name(campaign.request));
  if (alone) svg += head(campaign, legend, above);
  svg += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"#fff\" stroke=\"#ccc\"/>\n", kLeft,
                     kTop, kWidth - kLeft - kRight, kHeight - kTop - kBottom);
  for (const double tick : x.ticks()) {
    svg += fmt::format(
        "<path d=\"M{0:.1f} {1}V{2}\" stroke=\"#eee\"/><text x=\"{0:.1f}\" y=\"{3}\" text-anchor=\"middle\" "
        "fill=\"#555\">{4}</text>\n",
        x.at(tick), kTop, kHeight - kBottom, kHeight - kBottom + 16, short_number(tick));
  }
  for (const double tick : y.ticks()) {
    svg += fmt::format(
        "<path d=\"M{1} {0:.1f}H{2}\" stroke=\"#eee\"/><text x=\"{3}\" y=\"{4:.1f}\" text-anchor=\"end\" "
        "fill=\"#555\">{5}</text>\n",
        y.at(tick), kLeft, kWidth - kRight, kLeft - 6, y.at(tick) + 4, short_number(tick));
  }
  svg += fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"middle\" fill=\"#222\">{}</text>\n",
                     (kLeft + kWidth - kRight) / 2, kHeight - 14, time_label(campaign));
  svg += fmt::format(
      "<text transform=\"translate(15 {}) rotate(-90)\" text-anchor=\"middle\" fill=\"#222\">visible "
      "error, CIELAB (1: just noticeable)</text>\n",
      (kTop + kHeight - kBottom) / 2);
  // The front of time and error: as time grows the error falls, in steps.
  std::string path;
  double least = 1e300;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (errors[i] >= least) continue;
    path += path.empty() ? fmt::format("M{:.1f} {:.1f}", x.at(times[i]), y.at(errors[i]))
                         : fmt::format("H{:.1f}V{:.1f}", x.at(times[i]), y.at(errors[i]));
    least = errors[i];
  }
  svg += fmt::format("<path class=\"front\" d=\"{}\" fill=\"none\" stroke=\"#444\" stroke-dasharray=\"5 3\"/>\n", path);
  const AccuracyPoint* best = recommended(campaign);
  // Large markers first, so that small ones stay visible; the default on top.
  std::vector<std::size_t> order(points.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
    const bool a_last = points[a].settings == Settings{}, b_last = points[b].settings == Settings{};
    return a_last != b_last ? b_last : ram[a] > ram[b];
  });
  for (const std::size_t i : order) {
    const std::string group = group_of(points[i]);
    const double radius = 3.5 + 8.5 * std::sqrt(ram[i] / most_ram);
    svg += fmt::format(
        "<circle data-point=\"{}\" data-group=\"{}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\" fill=\"{}\" "
        "fill-opacity=\"{}\" stroke=\"{}\"><title>{}</title></circle>\n",
        i, group, x.at(times[i]), y.at(errors[i]), radius, colour_of_group(group), group == "several" ? 0.35 : 0.7,
        points[i].on_front ? "#000" : "#fff", to_text(points[i].settings));
    if (&points[i] == best) {
      svg += fmt::format(
          "<circle class=\"recommended\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\" fill=\"none\" "
          "stroke=\"#d00\" stroke-width=\"2\"/>\n",
          x.at(times[i]), y.at(errors[i]), radius + 4);
    }
  }
  const auto label = [&](const AccuracyPoint& point, std::string_view text, double dy) {
    svg += fmt::format(
        "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\" font-weight=\"600\" fill=\"#111\" "
        "paint-order=\"stroke\" stroke=\"#fff\" stroke-width=\"3\">{}</text>\n",
        std::clamp(x.at(time_of(point)), kLeft + 40, kWidth - kRight - 45), y.at(error_of(point)) + dy, text);
  };
  if (alone) svg += names(campaign, x, y);
  const auto standard = std::ranges::find(points, Settings{}, &AccuracyPoint::settings);
  if (standard != points.end() && !alone) label(*standard, "default", -16);
  if (best != nullptr && standard != points.end() && best != &*standard) label(*best, "recommended", 26);
  return svg + "</svg>\n";
}

}  // namespace

std::string plot_svg(const Campaign& campaign) { return plot(campaign, false); }
std::string plot_file_svg(const Campaign& campaign) { return plot(campaign, true); }

}  // namespace zstrip::sim
