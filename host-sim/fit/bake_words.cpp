// Options that have their default are left out, but for those that `zstrip fit` chooses.
#include "fit/bake_words.hpp"

#include <fmt/format.h>

#include <optional>
#include <string_view>

namespace zstrip::sim {
namespace {

bool is_plain(std::string_view word) {
  constexpr std::string_view kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_./,:=+%@";
  return !word.empty() && word.find_first_not_of(kPlain) == std::string_view::npos;
}

std::string shell_word(std::string_view word) {
  if (is_plain(word)) return std::string(word);
  std::string text = "'";
  for (const char letter : word) text += letter == '\'' ? "'\\''" : std::string(1, letter);
  return text + "'";
}

}  // namespace

std::vector<std::string> bake_words(const BakeArguments& arguments) {
  std::vector<std::string> words{"bake", arguments.scene, "-o", arguments.output};
  const auto add = [&words](const char* option, const std::optional<std::string>& value) {
    if (!value) return;
    // Joined, because a value may begin with a minus.
    words.push_back(fmt::format("{}={}", option, *value));
  };
  const auto add_flag = [&words](const char* option, bool given) {
    if (given) words.emplace_back(option);
  };
  const ViewArguments& view = arguments.plan.view;
  add("--size", view.size);
  add("--format", view.format);
  if (view.dither) words.emplace_back(*view.dither ? "--dither" : "--no-dither");
  if (view.samples) add("--samples", std::to_string(*view.samples));
  if (view.edges) words.emplace_back(*view.edges ? "--edges" : "--no-edges");
  add("--ram", arguments.plan.memory.ram);
  add("--strip-buffers", std::to_string(arguments.plan.strip_buffers.value_or(1)));
  add("--board", arguments.plan.memory.board);
  const CameraArguments& camera = arguments.camera;
  add("--up", camera.up);
  add("--animation", camera.animation);
  add_flag("--highlights", camera.highlights);
  add_flag("--plain-materials", camera.plain_materials);
  add("--camera", camera.camera);
  add("--eye", camera.eye);
  add("--look-at", camera.look_at);
  add("--orbit", camera.orbit);
  if (camera.field_of_view) add("--fov", fmt::format("{}", *camera.field_of_view));
  add_flag("--ortho", camera.orthographic);
  add("--background", camera.background);
  add("--light", camera.light);
  add("--textures", arguments.textures);
  if (arguments.lighting != "drawn") add("--lighting", arguments.lighting);
  add("--texture-size", camera.reduction.texture_size);
  add("--triangles", camera.reduction.triangles);
  add_flag("--lod", camera.reduction.lod);
  return words;
}

std::string shell_line(const std::vector<std::string>& words) {
  std::string line = "zstrip";
  for (const std::string& word : words) line += ' ' + shell_word(word);
  return line;
}

}  // namespace zstrip::sim
