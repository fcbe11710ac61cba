// A machine in the emulator with a real Debian kernel.
#include "guest.hpp"

#include <stdlib.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <thread>

namespace zstrip::linux_guest {
namespace {

using namespace std::chrono_literals;

const std::filesystem::path kGuests = ZSTRIP_GUESTS;
constexpr auto kPatience = 240s;  // a kernel starts in some seconds, if it is alone

std::filesystem::path folder_of(Machine machine) {
  return kGuests / (machine == Machine::amd64 ? "amd64" : machine == Machine::arm64 ? "arm64" : "armhf");
}

boards::Qemu::Options emulator_of(const Guest::Options& options) {
  const bool is_arm = options.machine != Machine::amd64, is_board = options.machine == Machine::sabrelite,
             is_64 = options.machine == Machine::arm64;
  const std::filesystem::path folder = folder_of(options.machine);
  const std::string console = is_board ? "ttymxc1" : is_arm ? "ttyAMA0" : "ttyS0";
  boards::Qemu::Options emulator;
  emulator.emulator = is_64 ? "qemu-system-aarch64" : is_arm ? "qemu-system-arm" : "qemu-system-x86_64";
  emulator.machine = is_board ? "sabrelite" : is_64 ? "virt" : is_arm ? "virt,highmem=off" : "pc";
  emulator.serial_port = is_board ? 1 : 0;
  emulator.program = folder / "kernel";
  emulator.devices = {"-nodefaults",
                      "-no-reboot",
                      "-m",
                      "256",
                      "-initrd",
                      (folder / "initrd").string(),
                      "-append",
                      "quiet loglevel=1 panic=-1 console=" + console + " zstrip.console=" + console +
                          " zstrip.modules=" + options.modules + " " + options.kernel};
  if (is_board) {
    emulator.devices.insert(emulator.devices.end(), {"-dtb", (folder / "sabrelite.dtb").string()});
  } else if (is_arm) {
    const std::string tree = (folder / (options.tree + ".dtb")).string();
    emulator.devices.insert(emulator.devices.end(), {"-cpu", is_64 ? "cortex-a53" : "cortex-a15", "-dtb", tree});
  }
  emulator.devices.insert(emulator.devices.end(), options.devices.begin(), options.devices.end());
  return emulator;
}

/// Empty if there is no such file.
std::string words_of(const char* file) {
  std::ifstream words(kGuests / file);
  return words ? std::string(std::istreambuf_iterator<char>(words), {}) : "";
}

}  // namespace

std::string missing_gpiod2() { return words_of("missing-gpiod2"); }

std::string missing(Machine machine) {
  if (const std::string reason = words_of("missing"); !reason.empty()) return reason;
  return std::filesystem::exists(folder_of(machine) / "initrd") ? "" : "the test LinuxGuests makes the machines first";
}

Guest::Guest(const Options& options) : emulator_(emulator_of(options)) {
  const Answer start = answer("ready", "the start of " + emulator_of(options).machine);
  if (!start.text.empty()) throw std::runtime_error("the guest started with: " + start.text);
}

Guest::Answer Guest::run(const std::string& command) {
  emulator_.write_console(command + "\n");
  return answer("status ", "the end of: " + command);
}

Guest::Answer Guest::answer(const std::string& last, const std::string& what) {
  Answer answer;
  const auto next_line = [&] {
    try {
      return emulator_.read_line(kPatience);
    } catch (const std::runtime_error& error) {
      throw std::runtime_error("waiting for " + what + ": " + error.what() + "; so far: " + answer.text);
    }
  };
  for (;;) {
    const std::string line = next_line();
    if (line.starts_with(last)) {
      if (line.size() > last.size()) answer.status = std::stoi(line.substr(last.size()));
      return answer;
    }
    answer.text += line + "\n";
  }
}

std::string Guest::screen_differs(const boards::ColourPicture& expected) {
  return differs(expected, [this] { return emulator_.colour_screen(); });
}

std::string Guest::head_differs(int head, const boards::ColourPicture& expected) {
  return differs(expected, [this, head] { return emulator_.colour_screen("card", head); });
}

std::string Guest::differs(const boards::ColourPicture& expected, const std::function<boards::ColourPicture()>& seen) {
  const auto deadline = std::chrono::steady_clock::now() + 20s;
  for (;;) {
    std::string difference = boards::difference(expected, seen());
    if (difference.empty() || std::chrono::steady_clock::now() > deadline) return difference;
    std::this_thread::sleep_for(50ms);
  }
}

namespace {

/// Draws a frame with the host's command, and takes it from its file.
template <class Take>
auto drawn(int frame, const std::string& options, const std::string& extension, Take take) {
  std::string folder = std::filesystem::temp_directory_path() / "zstrip-frames-XXXXXX";
  if (mkdtemp(folder.data()) == nullptr) throw std::runtime_error("cannot make " + folder);
  // `zstrip render` gives only the first frame of a turn alone.
  const std::string frames = frame == 0 ? "1" : kTurn;
  const std::string output = frame == 0 ? folder + "/frame_0000" + extension : folder;
  const std::string command = std::string(ZSTRIP_COMMAND) + " render " + (kGuests / "scene.zsc").string() +
                              " --quiet --frames " + frames + " -o " + output + " " + options;
  if (std::system(command.c_str()) != 0) throw std::runtime_error("failed: " + command);
  const std::string number = std::to_string(frame);
  auto result =
      take(std::filesystem::path(folder) / ("frame_" + std::string(4 - number.size(), '0') + number + extension));
  std::filesystem::remove_all(folder);
  return result;
}

std::string size_option(int width, int height) {
  return "--size " + std::to_string(width) + "x" + std::to_string(height);
}

}  // namespace

boards::ColourPicture host_frame(int frame, int width, int height) {
  return drawn(frame, size_option(width, height) + " --image ppm", ".ppm",
               [](const std::filesystem::path& file) { return boards::read_ppm(file); });
}

std::vector<std::byte> host_frame_mono(int frame, int width, int height) {
  return drawn(frame, size_option(width, height) + " --format mono --image raw", ".raw",
               [width, height](const std::filesystem::path& file) {
                 std::vector<std::byte> bytes(static_cast<std::size_t>((width + 7) / 8 * height));
                 std::ifstream stream(file, std::ios::binary);
                 stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
                 if (!stream || stream.peek() != std::ifstream::traits_type::eof())
                   throw std::runtime_error("not a picture of one bit a pixel: " + file.string());
                 return bytes;
               });
}

}  // namespace zstrip::linux_guest
