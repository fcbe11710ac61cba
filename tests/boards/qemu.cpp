// Starts, watches and ends the emulator.
#include "qemu.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <thread>
#include <utility>

namespace zstrip::boards {
namespace {

using Json = nlohmann::json;
using Clock = std::chrono::steady_clock;

[[noreturn]] void fail(const std::string& what) { throw std::runtime_error("qemu: " + what); }
[[noreturn]] void fail_with_errno(const std::string& what) { fail(what + ": " + std::strerror(errno)); }

std::filesystem::path make_folder() {
  std::string name = std::filesystem::temp_directory_path() / "zstrip-board-XXXXXX";
  if (mkdtemp(name.data()) == nullptr) fail_with_errno("cannot make " + name);
  return name;
}

std::vector<std::string> command_line(const Qemu::Options& options, const std::filesystem::path& folder) {
  std::vector<std::string> line{options.emulator, "-M",   options.machine, "-display",     "none",
                                "-monitor",       "none", "-kernel",       options.program};
  for (int port = 0; port < options.serial_port; ++port) line.insert(line.end(), {"-serial", "null"});
  line.insert(line.end(), {"-serial", "stdio"});
  line.insert(line.end(), {"-qmp", "unix:" + (folder / "qmp").string() + ",server=on,wait=off"});
  if (!options.trace.empty()) line.insert(line.end(), {"-trace", options.trace, "-D", folder / "trace"});
  line.insert(line.end(), options.devices.begin(), options.devices.end());
  if (options.count_instructions) line.insert(line.end(), {"-icount", "shift=0"});
  if (!options.words.empty()) {
    std::string config = "enable=on,target=native";
    for (const std::string& word : options.words) config += ",arg=" + word;
    line.insert(line.end(), {"-semihosting-config", config});
  }
  return line;
}

/// Does not return, and only calls what is allowed between fork and exec.
[[noreturn]] void become_emulator(char* const* arguments, int console, int log, pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(127);
  dup2(console, STDIN_FILENO);
  dup2(console, STDOUT_FILENO);
  dup2(log, STDERR_FILENO);
  execvp(arguments[0], arguments);
  _exit(127);
}

/// Appends what arrives; false at the end of the stream.
bool receive(int socket, std::string& text, Clock::time_point deadline, const char* what) {
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now());
  pollfd waiting{socket, POLLIN, 0};
  const int ready = poll(&waiting, 1, static_cast<int>(std::max<long long>(left.count(), 0)));
  if (ready < 0 && errno == EINTR) return true;
  if (ready < 0) fail_with_errno("poll");
  if (ready == 0) fail(std::string("time-out while waiting for ") + what + "; got so far: \"" + text + "\"");
  char buffer[4096];
  const ssize_t count = recv(socket, buffer, sizeof buffer, 0);
  if (count < 0 && errno != ECONNRESET) fail_with_errno("recv");
  if (count <= 0) return false;
  text.append(buffer, static_cast<std::size_t>(count));
  return true;
}

/// The next line, without its end.
std::string receive_line(int socket, std::string& text, Clock::time_point deadline, const char* what) {
  std::size_t end = 0;
  while ((end = text.find('\n')) == std::string::npos) {
    if (!receive(socket, text, deadline, what)) fail(std::string("it ended instead of sending ") + what);
  }
  std::string line = text.substr(0, end);
  text.erase(0, end + 1);
  if (line.ends_with('\r')) line.pop_back();
  return line;
}

void send_all(int socket, std::string_view text) {
  while (!text.empty()) {
    const ssize_t count = send(socket, text.data(), text.size(), MSG_NOSIGNAL);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail_with_errno("send");
    text.remove_prefix(static_cast<std::size_t>(count));
  }
}

}  // namespace

Qemu::Qemu(const Options& options) : folder_(make_folder()), traced_event_(options.trace) {
  try {
    if (!std::filesystem::exists(options.program)) fail("there is no " + options.program.string());
    std::vector<std::string> line = command_line(options, folder_);
    std::vector<char*> arguments;
    for (std::string& word : line) arguments.push_back(word.data());
    arguments.push_back(nullptr);

    int ends[2];
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) fail_with_errno("socketpair");
    console_ = ends[0];
    const int log = open((folder_ / "log").c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
    const pid_t parent = getpid();
    process_ = fork();
    if (process_ == 0) become_emulator(arguments.data(), ends[1], log, parent);
    close(ends[1]);
    if (log >= 0) close(log);
    if (process_ < 0) fail_with_errno("fork");
  } catch (...) {
    stop();
    throw;
  }
}

Qemu::~Qemu() { stop(); }

void Qemu::stop() {
  if (process_ > 0) {
    kill(process_, SIGKILL);
    waitpid(process_, nullptr, 0);
    process_ = -1;
  }
  if (console_ >= 0) close(std::exchange(console_, -1));
  if (monitor_ >= 0) close(std::exchange(monitor_, -1));
  std::error_code ignored;  // a folder that stays behind fails no test
  std::filesystem::remove_all(folder_, ignored);
}

void Qemu::write_console(std::string_view text) { send_all(console_, text); }

std::string Qemu::read_line(Duration patience) {
  return receive_line(console_, console_text_, Clock::now() + patience, "a line on the console");
}

std::string Qemu::prompt(std::string_view text) {
  const Deadline deadline = Clock::now() + kPatience;
  constexpr int kMilliseconds = 100;
  pollfd waiting{console_, POLLIN, 0};
  do {
    if (Clock::now() > deadline) fail("time-out while waiting for an answer to " + std::string(text));
    write_console(text);
  } while (console_text_.empty() && poll(&waiting, 1, kMilliseconds) == 0);
  return read_line();
}

Qemu::Finished Qemu::finish(Duration patience) {
  const Deadline deadline = Clock::now() + patience;
  while (receive(console_, console_text_, deadline, "the program's end")) {
  }
  int status = 0;
  if (waitpid(process_, &status, 0) != process_) fail_with_errno("waitpid");
  process_ = -1;
  return {std::exchange(console_text_, {}), WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status)};
}

void Qemu::connect_monitor(Deadline deadline) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  const std::string path = folder_ / "qmp";
  if (path.size() >= sizeof address.sun_path) fail("the path is too long for a socket: " + path);
  std::copy(path.begin(), path.end(), address.sun_path);
  monitor_ = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (monitor_ < 0) fail_with_errno("socket");
  // It listens some time after it was started.
  while (connect(monitor_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
    if (Clock::now() > deadline) fail_with_errno("cannot connect to its monitor");
    if (waitpid(process_, nullptr, WNOHANG) == process_) {
      process_ = -1;
      std::ifstream log(folder_ / "log");
      fail("it ended at once: " + std::string(std::istreambuf_iterator<char>(log), {}));
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  if (!read_monitor(deadline).contains("QMP")) fail("its monitor does not speak QMP");
  command({{"execute", "qmp_capabilities"}});
}

Json Qemu::read_monitor(Deadline deadline) {
  return Json::parse(receive_line(monitor_, monitor_text_, deadline, "an answer of its monitor"));
}

Json Qemu::command(const Json& request) {
  const Deadline deadline = Clock::now() + kPatience;
  send_all(monitor_, request.dump() + "\n");
  for (;;) {
    Json answer = read_monitor(deadline);
    if (answer.contains("event")) continue;
    if (!answer.contains("return")) fail(request.dump() + " answered " + answer.dump());
    return answer["return"];
  }
}

std::optional<std::string> Qemu::poll_trace_line() {
  if (!trace_.is_open()) trace_.open(folder_ / "trace");
  if (!trace_.is_open()) return std::nullopt;
  std::string part;
  std::getline(trace_, part);
  trace_text_ += part;
  if (!trace_.eof()) return std::exchange(trace_text_, {});
  trace_.clear();  // more may come
  return std::nullopt;
}

std::string Qemu::read_trace_line(Duration patience) {
  const Deadline deadline = Clock::now() + patience;
  for (;;) {
    if (auto line = poll_trace_line()) return std::move(*line);
    if (Clock::now() > deadline) fail("time-out while waiting for its trace");
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

void Qemu::set_trace(bool on) {
  if (monitor_ < 0) connect_monitor(Clock::now() + kPatience);
  command({{"execute", "trace-event-set-state"}, {"arguments", {{"name", traced_event_}, {"enable", on}}}});
}

std::vector<std::byte> Qemu::memory(std::uint32_t address, std::uint32_t size) {
  if (monitor_ < 0) connect_monitor(Clock::now() + kPatience);
  // As the processor sees it: some machines give their processor a bus of its own.
  const std::filesystem::path file = folder_ / "memory";
  command({{"execute", "memsave"}, {"arguments", {{"val", address}, {"size", size}, {"filename", file.string()}}}});
  std::ifstream stream(file, std::ios::binary);
  std::vector<std::byte> bytes(size);
  stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
  if (!stream) fail("it saved less memory than asked for");
  return bytes;
}

std::filesystem::path Qemu::screenshot(const nlohmann::json& which) {
  if (monitor_ < 0) connect_monitor(Clock::now() + kPatience);
  const std::filesystem::path file = folder_ / "screen.ppm";
  nlohmann::json arguments = which;
  arguments["filename"] = file.string();
  command({{"execute", "screendump"}, {"arguments", arguments}});
  return file;
}

GreyPicture Qemu::screen(int scale) { return read_scaled_ppm(screenshot(nlohmann::json::object()), scale); }

ColourPicture Qemu::colour_screen() { return read_ppm(screenshot(nlohmann::json::object())); }

ColourPicture Qemu::colour_screen(const std::string& device, int head) {
  return read_ppm(screenshot({{"device", device}, {"head", head}}));
}

}  // namespace zstrip::boards
