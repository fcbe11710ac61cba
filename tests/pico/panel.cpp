// The Pico's panel: reads what its lines carried (board.mjs) and shows it to the model of the ST7789. Every picture
// has to be the host's: the black glass that is switched on, then frame after frame of the teapot; at the end words.
//   zstrip_pico_panel [--pictures FOLDER] [--words WORDS] [--frame PPM|-]... < LINES
// With --frame frame n is to be the picture in the nth file, or anything for -, and there are no more frames than
// these. Lines are "NANOSECONDS WORD VALUE": reset, select, data, light and a level; cycle, the nanoseconds of a bit;
// bytes in hexadecimal; frame, which is complete; stuck, after which the bus gives up. Prints what is wrong, a line
// each, then "N pictures". Exit status: 0 nothing is wrong, 1 something is, 2 not such lines.
#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "../boards/host_render.hpp"
#include "panel/dcs_model.hpp"
#include "zstrip_hal/framebuffer.hpp"
#include "zstrip_hal/message_screen.hpp"

namespace zstrip::boards {
namespace {

constexpr std::uint16_t kSide = 240;
constexpr std::size_t kPixels = std::size_t{kSide} * kSide;
constexpr std::uint32_t kFramesPerTurn = 64;
constexpr std::uint8_t kColumns = 0x2A, kRows = 0x2B, kMemoryWrite = 0x2C;

/// A panel's glass as the program sees it: RGB565.
std::vector<std::uint16_t> pixels_of(const sim::RgbImage& image) {
  std::vector<std::uint16_t> pixels;
  for (std::size_t at = 0; at < image.rgb.size(); at += 3) {
    pixels.push_back(
        static_cast<std::uint16_t>(image.rgb[at] >> 3 << 11 | image.rgb[at + 1] >> 2 << 5 | image.rgb[at + 2] >> 3));
  }
  return pixels;
}

std::vector<std::uint16_t> picture_of_words(const std::string& words) {
  std::vector<std::byte> memory(2 * kPixels);
  hal::Framebuffer display(memory, {kSide, kSide, hal::DisplayFormat::rgb565_swapped});
  if (hal::show_message(display, words) != hal::Error::none) throw std::runtime_error("no picture of " + words);
  std::vector<std::uint16_t> pixels;
  for (std::size_t at = 0; at < memory.size(); at += 2) {
    pixels.push_back(static_cast<std::uint16_t>(std::to_integer<unsigned>(memory[at]) << 8 |
                                                std::to_integer<unsigned>(memory[at + 1])));
  }
  return pixels;
}

/// A file of `zstrip render`.
std::vector<std::uint16_t> picture_of_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string kind;
  std::uint32_t width = 0, height = 0, white = 0;
  sim::RgbImage image{.width = kSide, .height = kSide, .rgb = std::vector<std::uint8_t>(3 * kPixels)};
  file >> kind >> width >> height >> white;
  if (kind != "P6" || width != kSide || height != kSide || white != 255 || file.get() != '\n' ||
      !file.read(reinterpret_cast<char*>(image.rgb.data()), static_cast<std::streamsize>(image.rgb.size()))) {
    throw std::runtime_error("no picture of the panel's size: " + path);
  }
  return pixels_of(image);
}

class Panel {
 public:
  Panel(std::string folder, std::vector<std::string> frames) : folder_(std::move(folder)), frames_(std::move(frames)) {}

  void take(std::uint64_t nanoseconds, const std::string& word, const std::string& value) {
    model_.elapse(sim::Nanoseconds(nanoseconds) - model_.now());
    if (word == "reset") return model_.set_reset(value == "1");
    if (word == "select") return select(value == "0");
    if (word == "data") return void(wire_ = value == "1" ? sim::Wire::data : sim::Wire::command);
    if (word == "stuck") return give_up();
    if (word == "frame") return end_picture();
    if (word == "light") return void(lit_ = value == "1");
    if (word == "cycle") return model_.clocked_at(sim::Nanoseconds(std::stoul(value)));
    if (word != "bytes" || value.size() % 2 != 0) throw std::runtime_error("unknown line: " + word + " " + value);
    for (std::size_t at = 0; at < value.size(); at += 2) {
      receive(static_cast<std::uint8_t>(std::stoul(value.substr(at, 2), nullptr, 16)));
    }
    if (!on_ && darkness().empty()) expect(std::vector<std::uint16_t>(kPixels), "glass when it is switched on");
    on_ = darkness().empty();
  }

  void end_with(const std::string& words) { expect(picture_of_words(words), "words"); }

  /// How many things were wrong.
  std::size_t report() {
    for (const std::string& complaint : model_.complaints()) say("panel: " + complaint);
    for (const std::string& line : wrong_) std::cout << line << "\n";
    std::cout << pictures_ << " pictures\n";
    return wrong_.size();
  }

 private:
  void say(std::string what) { wrong_.push_back(std::move(what)); }
  std::string darkness() const { return lit_ ? model_.darkness() : "the backlight is off"; }

  void receive(std::uint8_t byte) {
    const std::byte bytes[] = {static_cast<std::byte>(byte)};
    model_.receive(wire_, bytes);
    if (wire_ == sim::Wire::command) {
      end_window();
      command_ = {byte};
    } else if (!command_.empty() && command_[0] == kMemoryWrite) {
      ++window_bytes_;
    } else {
      command_.push_back(byte);
      const auto range = [&] {
        return 1U + static_cast<unsigned>(command_[3] << 8 | command_[4]) -
               static_cast<unsigned>(command_[1] << 8 | command_[2]);
      };
      if (command_.size() == 5 && command_[0] == kColumns) columns_ = range();
      if (command_.size() == 5 && command_[0] == kRows) rows_ = range();
    }
  }

  void select(bool selected) {
    if (!selected && window_bytes_ == 2U * columns_ * rows_) end_window();
  }

  /// What comes now is no frame.
  void give_up() {
    model_.interrupted();
    window_bytes_ = 0;
    given_up_ = true;
  }

  void end_window() {
    if (window_bytes_ == 0) return;
    if (window_bytes_ != 2U * columns_ * rows_) {
      say("a window of " + std::to_string(columns_) + "x" + std::to_string(rows_) + " got " +
          std::to_string(window_bytes_) + " bytes");
    }
    shown_ += window_bytes_ / 2;
    window_bytes_ = 0;
    command_.clear();
    if (pictures_ == 0 && shown_ == kPixels) end_picture();  // black, and sent to a display that is off
  }

  void end_picture() {
    if (shown_ > kPixels) say("more pixels than a picture has");
    shown_ = 0;
    if (given_up_ || pictures_++ == 0) return;
    const std::uint32_t frame = pictures_ - 2;
    if (!frames_.empty()) return expect_file(frame);
    expect(render_turntable_rgb565("teapot", frame % kFramesPerTurn, kFramesPerTurn, kSide, kSide),
           "frame " + std::to_string(frame));
  }

  void expect_file(std::uint32_t frame) {
    if (frame >= frames_.size()) return say("one frame too many");
    if (frames_[frame] != "-") {
      expect(picture_of_file(frames_[frame]), "frame " + std::to_string(frame));
    } else if (pixels_of(model_.seen()) == before_) {
      say("frame " + std::to_string(frame) + " is that before it");
    }
    before_ = pixels_of(model_.seen());
  }

  void expect(const std::vector<std::uint16_t>& pixels, const std::string& name) {
    if (const std::string dark = darkness(); !dark.empty()) say(name + " does not show: " + dark);
    const std::vector<std::uint16_t> seen = pixels_of(model_.seen());
    std::size_t differ = 0;
    for (std::size_t i = 0; i < kPixels; ++i) differ += seen[i] != pixels[i];
    if (differ != 0) say(name + ": " + std::to_string(differ) + " pixels are not those of the host");
    save(name);
  }

  void save(const std::string& name) const {
    if (folder_.empty()) return;
    const sim::RgbImage image = model_.seen();
    std::ofstream file(folder_ + "/" + name + ".ppm", std::ios::binary);
    file << "P6\n" << image.width << " " << image.height << "\n255\n";
    file.write(reinterpret_cast<const char*>(image.rgb.data()), static_cast<std::streamsize>(image.rgb.size()));
    if (!file.flush()) throw std::runtime_error("cannot write " + folder_ + "/" + name + ".ppm");
  }

  sim::DcsModel model_{sim::kSt7789Part, sim::Glass{.width = kSide, .height = kSide, .inverted = true}};
  sim::Wire wire_ = sim::Wire::command;
  bool lit_ = false, on_ = false, given_up_ = false;
  std::vector<std::uint8_t> command_;  // and its parameters
  unsigned columns_ = 0, rows_ = 0;    // of the window
  std::size_t window_bytes_ = 0, shown_ = 0;
  std::uint32_t pictures_ = 0;
  std::string folder_;
  std::vector<std::string> frames_;  // files; empty: those of the teapot
  std::vector<std::uint16_t> before_ = std::vector<std::uint16_t>(kPixels);
  std::vector<std::string> wrong_;
};

int run(const std::vector<std::string>& arguments) {
  std::string folder, words;
  std::vector<std::string> frames;
  for (std::size_t i = 0; i < arguments.size(); i += 2) {
    const bool is_folder = arguments[i] == "--pictures", is_frame = arguments[i] == "--frame";
    if (i + 1 == arguments.size() || (!is_folder && !is_frame && arguments[i] != "--words")) {
      throw std::runtime_error("wrong words: " + arguments[i]);
    }
    (is_folder ? folder : is_frame ? frames.emplace_back() : words) = arguments[i + 1];
  }
  Panel panel(folder, frames);
  std::string line;
  while (std::getline(std::cin, line)) {
    std::istringstream words_of_line(line);
    std::uint64_t nanoseconds = 0;
    std::string word, value;
    if (!(words_of_line >> nanoseconds >> word >> value)) throw std::runtime_error("no such line: " + line);
    panel.take(nanoseconds, word, value);
  }
  if (!words.empty()) panel.end_with(words);
  return panel.report() == 0 ? 0 : 1;
}

}  // namespace
}  // namespace zstrip::boards

int main(int count, char** arguments) {
  try {
    return zstrip::boards::run({arguments + 1, arguments + count});
  } catch (const std::exception& error) {
    std::cerr << "zstrip_pico_panel: " << error.what() << "\n";
    return 2;
  }
}
