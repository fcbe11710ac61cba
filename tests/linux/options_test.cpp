// Options of zstrip-panel that make no sense: each is refused before anything is opened, by a line that names it.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdio>
#include <string>

namespace zstrip::panel {
namespace {

struct Ended {
  int status = -1;
  std::string words;
};

Ended run(const std::string& options) {
  const std::string command = "'" ZSTRIP_PANEL "' nowhere.zsc --display fbdev:/dev/nowhere " + options + " 2>&1";
  FILE* const pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return {};
  Ended ended;
  char buffer[256];
  while (std::fgets(buffer, sizeof buffer, pipe) != nullptr) ended.words += buffer;
  const int status = pclose(pipe);
  if (WIFEXITED(status)) ended.status = WEXITSTATUS(status);
  return ended;
}

TEST(LinuxPanelOptions, NumbersThatAreNone) {
  constexpr int kUsage = 2, kScene = 4;
  for (const char* option : {"--frames", "--turn", "--fps"}) {
    for (const char* value : {"nan", "inf", "-inf", "-1", "''", "x", "1x", "99999999999999999999"}) {
      const Ended ended = run(std::string(option) + "=" + value);
      EXPECT_EQ(ended.status, kUsage) << option << ' ' << value << ": " << ended.words;
      EXPECT_NE(ended.words.find(option), std::string::npos) << ended.words;
    }
    EXPECT_EQ(run(std::string(option) + " 5").status, kScene) << "a good one, and no scene";
  }
  for (const char* options : {"--frames 1.5", "--frames 4294967296", "--turn 0", "--turn 1000001", "--turn 2.5",
                              "--fps 0", "--fps 0.001", "--fps 1001", "--fps 1e400", "--fps -nan"}) {
    EXPECT_EQ(run(options).status, kUsage) << options;
  }
}

TEST(LinuxPanelOutput, ABrokenPipeIsAnErrorAndNoEnd) {
  const auto ended = [](const char* command) {
    FILE* const pipe = popen(command, "r");
    return pipe == nullptr ? -1 : pclose(pipe);  // closed at once, while the command still waits
  };
  constexpr int kOutput = 6;
  for (const char* command : {"sleep 0.2; exec '" ZSTRIP_PANEL "' --list 2>/dev/null",
                              "exec '" ZSTRIP_PANEL "' --list 2>/dev/null >/dev/full"}) {
    const int status = ended(command);
    ASSERT_TRUE(WIFEXITED(status)) << command << ": signal " << WTERMSIG(status);
    EXPECT_EQ(WEXITSTATUS(status), kOutput) << command;
  }
}

}  // namespace
}  // namespace zstrip::panel
