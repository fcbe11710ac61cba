// Outputs that cannot be written, or are in the way of each other.
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <thread>

#include "failure_fixture.hpp"

namespace zstrip::sim::test {
namespace {

using BadOutput = FailureTest;

TEST_F(BadOutput, PlacesThatCannotBeWritten) {
  // Nobody, not even root, creates files there.
  expect_failure(ExitStatus::output, "/sys/picture.png", {"render", "teapot", "-o", "/sys/picture.png"});
  expect_failure(ExitStatus::output, "/sys/pictures", {"render", "teapot", "-o", "/sys/pictures"});
  expect_failure(ExitStatus::output, "no/such", {"render", "teapot", "-o", "no/such/picture.png"});
  expect_failure(ExitStatus::output, "/sys/report.json",
                 {"render", "teapot", "-o", "/dev/null", "--json", "/sys/report.json"});
}

TEST_F(BadOutput, FileInPlaceOfAFolder) {
  file("plain.txt", "mine");
  expect_failure(ExitStatus::output, "plain.txt/frames", {"render", "teapot", "-o", "plain.txt/frames"});
  EXPECT_EQ(read(path("plain.txt")), "mine");
}

/// They were replaced by a file.
TEST_F(BadOutput, LinksThatLeadNowhereStay) {
  std::filesystem::create_symlink("gone/report.json", path("dangling.json"));
  std::filesystem::create_symlink("gone.png", path("dangling.png"));
  std::filesystem::create_symlink("loop.png", path("loop.png"));
  for (const auto& [link, reason] : {std::pair{"dangling.png", "a symbolic link to 'gone.png': No such file"},
                                     {"loop.png", "a symbolic link to 'loop.png': Too many levels"}}) {
    expect_failure(ExitStatus::output, reason, {"render", "cube", "-o", link});
    EXPECT_TRUE(std::filesystem::is_symlink(path(link)));
  }
  expect_failure(ExitStatus::output, "dangling.json", {"render", "cube", "-o", "/dev/null", "--json", "dangling.json"});
  std::filesystem::create_symlink("nowhere", path("folder"));
  expect_failure(ExitStatus::output, "'folder'", {"render", "cube", "-o", "folder"});
}

TEST_F(BadOutput, FullDisk) {
  expect_failure(ExitStatus::output, "/dev/full", {"render", "teapot", "-o", "/dev/full"});
  expect_failure(ExitStatus::output, "/dev/full", {"render", "teapot", "-o", "/dev/null", "--json", "/dev/full"});
}

TEST_F(BadOutput, AWriteThatStopsHalfway) {
  // The limit lets a write begin and fail in the middle, as a full disk does.
  expect_failure(ExitStatus::output, "picture.raw", {"render", "teapot", "-o", "picture.raw"}, {.file_bytes = 5000});
  file("picture.raw", "the old picture");
  expect_failure(ExitStatus::output, "picture.raw", {"render", "teapot", "-o", "picture.raw"}, {.file_bytes = 5000});
  EXPECT_EQ(read(path("picture.raw")), "the old picture");
}

TEST_F(BadOutput, StandardErrorFullOrClosed) {
  for (const char* place : {"/dev/full", "-"}) {
    const auto status = [&](const std::vector<std::string>& arguments) {
      return run(ZSTRIP_COMMAND, arguments, path(""), {.err = place}).status;
    };
    EXPECT_EQ(status({"render", "nothere"}), static_cast<int>(ExitStatus::input)) << place;
    EXPECT_EQ(status({"render", "teapot", "--size", "0x0"}), static_cast<int>(ExitStatus::usage)) << place;
    // The summary is output, and warnings are not.
    EXPECT_EQ(status({"render", "teapot", "--json", "-"}), static_cast<int>(ExitStatus::output)) << place;
    EXPECT_EQ(status({"render", "teapot", "--json", "-", "--quiet"}), 0) << place;
    EXPECT_EQ(status({"render", "teapot", "--eye", "0,0,4", "--look-at", "0,0,8", "-o", "black.ppm", "--quiet"}), 0)
        << place;
    EXPECT_EQ(read(path("black.ppm")).size(), 15U + 320U * 240U * 3U) << "no message in the picture";
  }
}

TEST_F(BadOutput, StandardOutputFullOrClosed) {
  for (const char* place : {"/dev/full", "-"}) {
    for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
             {"scenes"}, {"--help"}, {"render", "teapot"}, {"render", "teapot", "--quiet", "--json", "-"}}) {
      const Outcome outcome = run(ZSTRIP_COMMAND, arguments, path(""), {.out = place});
      EXPECT_EQ(outcome.status, static_cast<int>(ExitStatus::output)) << arguments[0] << place;
      EXPECT_EQ(outcome.err.find('\n'), outcome.err.size() - 1) << outcome.err;
    }
  }
}

/// The pictures were lost, and the status was 0.
TEST_F(BadOutput, APictureForAClosedStreamIsAnError) {
  std::filesystem::create_symlink("/dev/stdout", path("link.hpp"));
  for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
           {"render", "cube", "-o", "/dev/stdout"},
           {"render", "cube", "-o", "/dev/fd/1", "--image", "raw", "--quiet"},
           {"render", "cube", "-o", "/dev/null", "--quiet", "--json", "/proc/self/fd/1"},
           {"bake", "cube", "-o", "link.hpp", "--quiet"}}) {
    expect_failure(ExitStatus::output, "cannot write ", arguments, {.out = "-"});
  }
  expect_failure(ExitStatus::output, "'/dev/stdout': No such device or address; open that stream, or choose",
                 {"render", "cube", "-o", "/dev/stdout"}, {.out = "-"});
  EXPECT_EQ(run(ZSTRIP_COMMAND, {"render", "cube", "-o", "/dev/stderr", "--quiet"}, path(""), {.err = "-"}).status, 6);
  EXPECT_EQ(run(ZSTRIP_COMMAND, {"render", "cube", "-o", "/dev/null", "--quiet"}, path(""), {.out = "-"}).status, 0);
}

TEST_F(BadOutput, ReportOverAPicture) {
  file("t.obj", kTriangleObj);
  file("a.png", "mine");
  std::filesystem::create_symlink("a.png", path("link.json"));
  const auto usage = [&](const std::string& mention, std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "render");
    expect_failure(ExitStatus::usage, mention, arguments);
  };
  usage("a.png", {"teapot", "-o", "a.png", "--json", "a.png"});
  usage("a.png", {"teapot", "-o", "a.png", "--json", "./x/../a.png"});
  usage("link.json", {"teapot", "-o", "a.png", "--json", "link.json"});
  usage("teapot.png", {"teapot", "--json", "teapot.png"});
  usage("frame_0001.png", {"teapot", "-o", "d", "--frames", "2", "--json", "d/frame_0001.png"});
  usage("t.obj", {"t.obj", "-o", "t.obj"});
  usage("t.obj", {"t.obj", "--json", "t.obj"});
  usage("/dev/stdout", {"teapot", "-o", "-"});
  usage("standard output", {"teapot", "-o", "/dev/stdout", "--json", "-"});
  EXPECT_EQ(read(path("a.png")), "mine");
  EXPECT_EQ(run(ZSTRIP_COMMAND, {"render", "teapot", "-o", "/dev/null", "--json", "/dev/null"}, path("")).status, 0);
  EXPECT_EQ(
      run(ZSTRIP_COMMAND, {"render", "teapot", "-o", "d", "--frames", "1", "--json", "d/frame_0001.png"}, path(""))
          .status,
      0);
}

TEST_F(BadOutput, SignalsLeaveNoTemporaryFile) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const pid_t child = ::fork();
    if (child == 0) {
      if (::chdir(path("").c_str()) != 0) ::_exit(126);
      ::execl(ZSTRIP_COMMAND, ZSTRIP_COMMAND, "render", "cube", "-o", "x.ppm", "--size", "2048x2048", "--quiet",
              nullptr);
      ::_exit(127);
    }
    // Until the temporary file is there, or the whole picture already.
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds{60};
    while (files().empty() && std::chrono::steady_clock::now() < deadline) {
      std::this_thread::sleep_for(std::chrono::microseconds{100});
    }
    ::kill(child, signal);
    int status = 0;
    ::waitpid(child, &status, 0);
    const std::vector<std::string> left = files();
    EXPECT_TRUE(left.empty() || left == std::vector<std::string>{"x.ppm"}) << left.front();
    if (!left.empty()) {
      EXPECT_EQ(std::filesystem::file_size(path("x.ppm")), 17U + 3U * 2048U * 2048U);
    }
    std::filesystem::remove(path("x.ppm"));
  }
}

}  // namespace
}  // namespace zstrip::sim::test
