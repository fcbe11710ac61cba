// Draws the frames of a workload and prints one line of JSON: nanoseconds a frame, and how many pixels of the first
// frame are covered, which shows that it is the same picture. With --draw-each it draws each frame so often and
// measures nothing, to be counted from outside. Exit status: 0 done, 1 it cannot be drawn, 2 the words are wrong.
#include "bench/peer_programs/peer_program.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>

namespace {

using namespace zstrip::peer;

struct Options {
  std::string scene;
  int width = 0, height = 0;
  std::uint32_t frames = 1, draw_each = 0;
};

std::ptrdiff_t covered_pixels(const Renderer& renderer, zstrip::Colour background) {
  const auto colour =
      static_cast<std::uint16_t>((background.r >> 3) << 11 | (background.g >> 2) << 5 | background.b >> 3);
  return std::ranges::count_if(renderer.pixels(), [colour](std::uint16_t pixel) { return pixel != colour; });
}

void run(const Options& options) {
  const auto scene = Scene::open(options.scene);
  if (!scene) throw std::runtime_error("no scene of this name that can be given to other renderers");
  const auto renderer = make_renderer(*scene, options.width, options.height);
  std::chrono::nanoseconds spent{0};
  std::ptrdiff_t covered = 0;
  for (std::uint32_t frame = 0; frame < options.frames; ++frame) {
    const View view = scene->view(frame, options.width, options.height);
    for (std::uint32_t i = 0; i < options.draw_each; ++i) renderer->draw(view);
    if (options.draw_each != 0) continue;
    if (frame == 0) {
      renderer->draw(view);  // so that preparations at the first use are not measured
      covered = covered_pixels(*renderer, scene->background());
    }
    const auto begin = std::chrono::steady_clock::now();
    renderer->draw(view);
    spent += std::chrono::steady_clock::now() - begin;
  }
  if (options.draw_each != 0) return;
  std::printf("{\"ns_per_frame\": %.0f, \"covered\": %td}\n",
              static_cast<double>(spent.count()) / static_cast<double>(options.frames), covered);
}

int parse_and_run(int count, char** words) {
  CLI::App app{"Draws a workload with another renderer"};
  Options options;
  app.add_option("scene", options.scene)->required();
  app.add_option("width", options.width)->required()->check(CLI::Range(1, 4096));
  app.add_option("height", options.height)->required()->check(CLI::Range(1, 4096));
  app.add_option("frames", options.frames)->required()->check(CLI::Range(1, 100000));
  app.add_option("--draw-each", options.draw_each)->check(CLI::Range(1, 100));
  try {
    app.parse(count, words);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  run(options);
  return 0;
}

}  // namespace

int main(int count, char** words) {
  try {
    return parse_and_run(count, words);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
  } catch (...) {
    std::fputs("failed\n", stderr);
  }
  return 1;
}
