// PROGRAM PICTURE [--accept]: runs the sketch that it is linked with for 20 turns of its loop and compares what the
// panel shows with PICTURE, a PNG. With --accept it writes that file. Exit status 1 if anything is wrong.
#include <spng.h>

#include <Arduino.h>
#undef abs
#undef max
#undef min
#undef round

#include <atomic>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <memory>
#include <string_view>
#include <thread>

#include "board.hpp"
#include "image/rgb_png.hpp"

namespace {

using namespace zstrip;
using Bytes = std::vector<std::uint8_t>;

Bytes file_bytes(const char* path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Red, green and blue of each pixel; empty if it is no such picture.
Bytes png_pixels(const Bytes& png) {
  const std::unique_ptr<spng_ctx, decltype(&spng_ctx_free)> reader(spng_ctx_new(0), &spng_ctx_free);
  std::size_t size = 0;
  if (spng_set_png_buffer(reader.get(), png.data(), png.size()) != 0) return {};
  if (spng_decoded_image_size(reader.get(), SPNG_FMT_RGB8, &size) != 0) return {};
  Bytes pixels(size);
  if (spng_decode_image(reader.get(), pixels.data(), size, SPNG_FMT_RGB8, 0) != 0) return {};
  return pixels;
}

}  // namespace

/// Only sketches for two cores have it.
[[gnu::weak]] void loop1();

int main(int count, char** words) {
  if (count < 2) return 2;
  std::atomic<bool> stops = false;
  std::thread second_core([&stops] {
    while (loop1 != nullptr && !stops.load()) loop1();
  });
  setup();
  for (int turn = 0; turn < 20; ++turn) loop();
  stops = true;
  second_core.join();

  const std::string fault = package::board().fault();
  if (!fault.empty()) {
    std::printf("%s\n", fault.c_str());
    return 1;
  }
  const sim::RgbImage seen = package::board().seen();
  if (count > 2 && std::string_view(words[2]) == "--accept") {
    const auto png = sim::encode_rgb_png(seen);
    if (!png) return 1;
    std::ofstream(words[1], std::ios::binary).write(reinterpret_cast<const char*>(png->data()), std::ssize(*png));
    return 0;
  }
  if (png_pixels(file_bytes(words[1])) == seen.rgb) return 0;
  std::printf("The panel shows another picture than %s; to accept it: %s %s --accept\n", words[1], words[0], words[1]);
  return 1;
}
