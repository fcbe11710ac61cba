// One run of a board in QEMU: its console on a socket, its screen through QMP. Everything has a time-out,
// and the emulator ends with this object, or with the test if that is killed.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "colour_picture.hpp"
#include "grey_picture.hpp"

namespace zstrip::boards {

class Qemu {
 public:
  struct Options {
    std::string emulator = "qemu-system-arm";
    std::string machine;
    std::filesystem::path program;
    std::vector<std::string> words{};    ///< what the program reads as its command line; none: no semihosting at all
    bool count_instructions = false;     ///< every instruction takes one nanosecond
    int serial_port = 0;                 ///< the one that is the console; those before it lead nowhere
    std::string trace{};                 ///< an event of the emulator's; its lines can be read. Empty: none
    std::vector<std::string> devices{};  ///< more words of the emulator's own command line
  };
  using Duration = std::chrono::milliseconds;
  static constexpr Duration kPatience{60'000};

  /// Starts the emulator; the program runs at once. All functions throw std::runtime_error, with what went wrong, when
  /// the emulator does not do its part in time.
  explicit Qemu(const Options& options);
  ~Qemu();
  Qemu(const Qemu&) = delete;
  Qemu& operator=(const Qemu&) = delete;

  void write_console(std::string_view text);
  /// The next whole line, without its end.
  std::string read_line(Duration patience = kPatience);
  /// Writes `text` again and again until a line comes, and returns that: a board that just starts misses the first
  /// ones.
  std::string prompt(std::string_view text);
  /// Everything until the program ends, and its exit status.
  struct Finished {
    std::string output;
    int status;
  };
  Finished finish(Duration patience = kPatience);

  /// What the board has in its memory now.
  std::vector<std::byte> memory(std::uint32_t address, std::uint32_t size);
  /// What the board's display shows now, each of its pixels `scale` x `scale` on the emulator's screen.
  GreyPicture screen(int scale);
  ColourPicture colour_screen();
  /// Of a graphics card with several screens: `head` of the device with this id.
  ColourPicture colour_screen(const std::string& device, int head);

  /// The next whole line of the trace, without its end; nothing if there is none yet.
  std::optional<std::string> poll_trace_line();
  /// The same, but waits for it.
  std::string read_trace_line(Duration patience = kPatience);
  /// From now on the event of the options is traced, or not.
  void set_trace(bool on);

  pid_t process() const { return process_; }

 private:
  using Deadline = std::chrono::steady_clock::time_point;
  std::filesystem::path screenshot(const nlohmann::json& which);
  void connect_monitor(Deadline deadline);
  nlohmann::json read_monitor(Deadline deadline);
  nlohmann::json command(const nlohmann::json& request);
  void stop();

  std::filesystem::path folder_;  ///< of this run, for the monitor's socket, screenshots and the log
  pid_t process_ = -1;
  int console_ = -1;
  int monitor_ = -1;
  std::string console_text_;
  std::string monitor_text_;
  std::string traced_event_;
  std::ifstream trace_;
  std::string trace_text_;  ///< the beginning of a line that is not whole yet
};

}  // namespace zstrip::boards
