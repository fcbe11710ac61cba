// What a user can get wrong, but for outputs: one line that names the thing, the documented exit status, and no partial
// file.
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <csignal>
#include <ctime>
#include <filesystem>
#include <thread>

#include "address_sanitizer.hpp"
#include "failure_fixture.hpp"

namespace zstrip::sim::test {
namespace {

class BadInput : public FailureTest {
 protected:
  void expect_bad_file(const std::string& name) {
    expect_failure(ExitStatus::input, name, {"render", name, "-o", "picture.png"});
  }
};

TEST_F(BadInput, MissingFile) { expect_bad_file("no-such-model.obj"); }

TEST_F(BadInput, Folder) { expect_bad_file("/tmp"); }

TEST_F(BadInput, Device) { expect_bad_file("/dev/zero"); }

TEST_F(BadInput, Fifo) {
  ASSERT_EQ(::mkfifo(path("pipe.obj").c_str(), 0600), 0);
  expect_bad_file("pipe.obj");
}

TEST_F(BadInput, SceneFileOfMoreThan16Megabytes) {
  file("large.toml", "");
  std::filesystem::resize_file(path("large.toml"), (16U << 20) + 1);
  expect_failure(ExitStatus::input, "large.toml' has more than 16 MB", {"render", "large.toml", "-o", "picture.png"});
}

/// Were internal errors.
TEST_F(BadInput, PathsThatLeadNowhere) {
  file("plain", "no folder");
  std::filesystem::create_symlink("two", path("one"));
  std::filesystem::create_symlink("one", path("two"));
  const std::string long_name(300, 'n');
  for (const char* ending : {".obj", ".toml", ".zsc"}) {
    expect_bad_file("plain/model" + std::string(ending));
    expect_bad_file("one/model" + std::string(ending));
    expect_bad_file(long_name + ending);
    expect_failure(ExitStatus::input, "one/model", {"plan", "one/model" + std::string(ending)});
    expect_failure(ExitStatus::input, "one/model", {"bake", "one/model" + std::string(ending), "-o", "scene.zsc"});
  }
  expect_failure(ExitStatus::input, "levels of symbolic links", {"render", "one/model.obj"});
  file("scene.toml", "[[model]]\nname = 'a'\nfile = 'one/model.obj'\n[[instance]]\nmodel = 'a'\n");
  expect_failure(ExitStatus::input, "line 3: 'one/model.obj' cannot be read", {"render", "scene.toml"});
  expect_failure(ExitStatus::input, "one/sets", {"render", "cube", "--visible-sets", "one/sets", "-o", "a.png"});
}

TEST_F(BadInput, EmptyFile) {
  for (const char* name : {"a.obj", "a.gltf", "a.glb", "a.stl", "a.ply", "a.3ds", "a.dae"}) {
    file(name, "");
    expect_bad_file(name);
  }
}

TEST_F(BadInput, RandomBytes) {
  std::string noise;
  std::uint32_t state = 1;
  for (int i = 0; i < 20000; ++i) {
    state = state * 1664525 + 1013904223;
    noise += static_cast<char>(state >> 24);
  }
  for (const char* name : {"a.obj", "a.gltf", "a.glb", "a.stl", "a.ply", "a.3ds", "a.dae"}) {
    file(name, noise);
    expect_bad_file(name);
  }
}

TEST_F(BadInput, TruncatedModel) {
  const std::filesystem::path models = GLMARK2_MODELS;
  if (models.empty()) GTEST_SKIP() << "package glmark2-data is not installed";
  const std::string whole = read(models / "horse.3ds");
  for (const std::size_t length : {std::size_t{1}, std::size_t{100}, std::size_t{5000}, whole.size() / 2}) {
    file("cut.3ds", whole.substr(0, length));
    expect_bad_file("cut.3ds");
  }
}

TEST_F(BadInput, TruncatedBinaryPly) {
  std::string ply =
      "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
  ply += std::string(20, '\1');
  file("cut.ply", ply);
  expect_bad_file("cut.ply");
}

TEST_F(BadInput, NoFiniteTriangle) {
  file("nan.obj", "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  expect_bad_file("nan.obj");
}

TEST_F(BadInput, NameWithControlCharacters) {
  expect_failure(ExitStatus::input, "bad??name", {"render", "bad\n\x1Bname"});
}

/// They went to the terminal as they were; other letters still do.
TEST_F(BadInput, NameThatTurnsText) {
  for (const char* turn : {"\u202A", "\u202E", "\u2066", "\u2069", "\u200E", "\u200F", "\u061C", "\u2028", "\u2029",
                           "\u0085", "\u009B", "\x9B"}) {
    expect_failure(ExitStatus::input, "bad?gpj", {"render", std::string("bad") + turn + "gpj"});
  }
  for (const char* name : {"größe", "日本", "🙂", "e\u0301", "שלום", "\xE2", "\xFF"}) {
    expect_failure(ExitStatus::input, name, {"render", name});
  }
  const Outcome summary = run(ZSTRIP_COMMAND, {"render", "cube", "-o", "a\u202Egnp.png"}, path(""));
  EXPECT_NE(summary.out.find("written    a?gnp.png"), std::string::npos) << summary.out;
}

/// One of 80,000 corners took 24 s.
TEST_F(BadInput, FaceOfTooManyCorners) {
  std::string vertices, face = "f";
  constexpr int kCorners = 80'000;
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 6.283185307 * i / kCorners;
    vertices += "v " + std::to_string(std::cos(angle)) + ' ' + std::to_string(std::sin(angle)) + " 0\n";
    face += ' ' + std::to_string(i + 1);
  }
  file("face.obj", vertices + face + '\n');
  const auto begin = std::chrono::steady_clock::now();
  expect_failure(ExitStatus::input, "'face.obj' has a face of 80,000 corners; at most 5,000 are read",
                 {"render", "face.obj", "-o", "a.png"});
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds{10});
}

/// The file was blamed: status 4.
TEST_F(BadInput, AMachineWithTooLittleMemoryIsNoFaultOfTheModel) {
  if (kAddressSanitizer) GTEST_SKIP() << "it takes terabytes of addresses";
  file("large.obj", sphere_obj(600, 400));
  file("large.gltf", R"({"asset":{"version":"2.0"},"nodes":[{"mesh":0}],)"
                     R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],)"
                     R"("accessors":[{"componentType":5126,"type":"VEC3","count":1300000}]})");
  file("scene.toml", "[[model]]\nname = 'a'\nfile = 'large.obj'\n[[instance]]\nmodel = 'a'\n");
  for (const char* name : {"large.obj", "large.gltf", "scene.toml"}) {
    expect_failure(ExitStatus::environment, "this machine has too little memory", {"render", name, "-o", "a.png"},
                   {.memory = std::uint64_t{100} << 20});
  }
}

/// A reader of models was asked about both.
TEST_F(BadInput, AddressesAndArchivesAreNoModels) {
  const std::string address = "https://example.org/models/duck.glb";
  const std::string advice = "download it first: curl -LO '" + address + "'";
  for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
           {"render", address}, {"plan", address}, {"bake", address, "-o", "a.hpp"}}) {
    expect_failure(ExitStatus::input, "there is no file '" + address + "'; " + advice, words);
  }
  for (const char* name : {"duck.zip", "duck.rar", "duck.7z", "duck.obj.gz", "DUCK.ZIP", "duck.tar"}) {
    file(name, "PK\3\4");
    expect_failure(ExitStatus::input, std::string(name) + "' is an archive; unpack it first", {"render", name});
  }
  file("scene.toml", "[[model]]\nname = 'a'\nfile = 'duck.zip'\n[[instance]]\nmodel = 'a'\n");
  expect_failure(ExitStatus::input, "line 3: 'duck.zip' is an archive; unpack it first", {"render", "scene.toml"});
}

/// A reader of models was asked about them.
TEST_F(BadInput, WhatIsBakedForFirmwareIsNoModel) {
  for (const char* name : {"m.uf2", "m.hpp", "M.INO"}) {
    file(name, "UF2\n");
    expect_failure(ExitStatus::input, std::string(name) + "' was written by zstrip bake for firmware",
                   {"render", name, "-o", "a.png"});
  }
}

TEST_F(BadInput, MisspeltBuiltInSceneIsToldTheNearest) {
  expect_failure(ExitStatus::input,
                 "there is no file 'tepot', and no built-in scene of that name; did you mean 'teapot'?",
                 {"render", "tepot"});
  expect_failure(ExitStatus::input, "of that name; 'zstrip scenes' lists", {"render", "tepot.obj"});
}

TEST_F(BadInput, SceneFileWhoseModelIsMissing) {
  file("scene.toml", "[[model]]\nname = 'a'\nfile = 'gone.obj'\n[[instance]]\nmodel = 'a'\n");
  expect_failure(ExitStatus::input, "'scene.toml' line 3: ", {"render", "scene.toml", "-o", "picture.png"});
}

TEST_F(BadInput, SceneFileWhoseBuiltInSceneIsMisspelt) {
  file("scene.toml", "[[model]]\nname = 'a'\nbuilt_in = 'teapott'\n[[instance]]\nmodel = 'a'\n");
  expect_failure(ExitStatus::input, "line 3: there is no built-in scene 'teapott'; did you mean 'teapot'?",
                 {"render", "scene.toml", "-o", "picture.png"});
}

TEST_F(BadInput, EllipsoidThatRoundsToNothing) {
  for (const char* radius : {"[1e-9, 1, 1]", "[1, 1e-6, 1]", "[1e-6, 1e-6, 1]"}) {
    file("scene.toml", std::string("[[material]]\nname = 'a'\n[[ellipsoid]]\nmaterial = 'a'\nrotation = [31, 17, 5]\n"
                                   "radius = ") +
                           radius + "\n");
    expect_failure(ExitStatus::input, "'scene.toml' line 3: ", {"render", "scene.toml", "-o", "picture.png"});
  }
}

TEST_F(BadInput, CameraOfASceneFileNamesNoOption) {
  for (const char* place : {"r = 1e-9", "r = 1e9", "eye = [1e9, 0, 0]"}) {
    file("scene.toml",
         std::string("[[model]]\nname = 'a'\nbuilt_in = 'cube'\n[[instance]]\nmodel = 'a'\n[camera]\n") + place + "\n");
    expect_failure(ExitStatus::input, "line 6: [camera] is too far away",
                   {"render", "scene.toml", "-o", "picture.png"});
  }
}

TEST_F(BadInput, Options) {
  const auto usage = [&](const std::string& mention, std::vector<std::string> arguments) {
    expect_failure(ExitStatus::usage, mention, arguments);
  };
  usage("--size", {"render", "teapot", "--size", "0x0"});
  usage("--size", {"render", "teapot", "--size", "4097x100"});
  usage("--strip-rows", {"render", "teapot", "--strip-rows", "241"});
  usage("--depth-format", {"render", "teapot", "--depth-format", "z8"});
  usage("--ortho", {"render", "teapot", "--depth-format", "float", "--ortho"});
  usage("--ram 'lots' must be a number of bytes from 1 to 4095M, for example 20000, 20K or 1M",
        {"render", "teapot", "--ram", "lots"});
  usage("--format", {"render", "teapot", "--format", "rgb888"});
  usage("--image", {"render", "teapot", "--image", "gif"});
  usage("--frames", {"render", "teapot", "--frames", "0"});
  usage("--frames", {"render", "teapot", "--frames", "many"});
  usage("not in range 1 to 10000", {"render", "teapot", "--frames", "-1"});
  usage("not in range 1 to 10000", {"render", "teapot", "--frames", "99999999999"});
  usage("not in range 1 to 256", {"render", "teapot", "--threads", "-1"});
  usage("'.txt' is not a picture type", {"render", "teapot", "-o", "x.txt"});
  usage("--eye", {"render", "teapot", "--eye", "1,2"});
  usage("--eye", {"render", "teapot", "--eye", "0,0,3", "--orbit", "3,0,90"});
  usage("--eye", {"render", "teapot", "--eye", "0,0,0"});
  usage("--orbit", {"render", "teapot", "--orbit", "-1,0,0"});
  usage("--look-at", {"render", "teapot", "--look-at", "0,0,0"});
  usage("--fov", {"render", "teapot", "--eye", "0,0,3", "--fov", "180"});
  usage("--up", {"render", "teapot", "--up", "z"});
  usage("neither true nor false; leave the value out", {"render", "teapot", "--dither=strong"});
  usage("--highlights", {"render", "teapot", "--highlights"});
  usage("--plain-materials", {"render", "teapot", "--plain-materials"});
  usage("picture.png", {"render", "teapot", "-o", "picture.png", "--frames", "2"});
  usage("--bogus", {"render", "teapot", "--bogus"});
  usage("--samples: 'four' is not a number. Known are 1, 2, 4", {"render", "teapot", "--samples", "four"});
  usage("did you mean 4?", {"render", "teapot", "--samples", "8"});
  usage("--mode: 'stremed' is unknown, did you mean streamed?", {"plan", "teapot", "--mode", "stremed"});
  usage("--sort-key: 'far' is unknown", {"render", "teapot", "--sort-key", "far"});
  usage("scene", {"render"});
  usage("command", {});
  usage("frobnicate", {"frobnicate"});
  usage("'rendr' is unknown, did you mean render?; see 'zstrip --help'", {"rendr", "teapot"});
  usage("'--sise' is unknown, did you mean --size?; see 'zstrip render --help'", {"render", "teapot", "--sise", "3x3"});
  usage("'--quiet' is an option of render and bake", {"plan", "teapot", "--quiet"});
  usage("'--turntable' is an option of bake; render has none", {"render", "teapot", "--turntable"});
  usage("'--smaples' is unknown, did you mean --samples?", {"render", "teapot", "--smaples=4"});
  usage("'--size' comes after '--', which ends the options", {"render", "teapot", "--", "--size", "3x3"});
  usage("'--size' comes after '--', which ends the options", {"render", "--", "teapot", "--size", "3x3"});
  usage("'--versoin' is unknown, did you mean --version?", {"--versoin"});
}

TEST_F(BadInput, TooLittleMemorySaysWhatWorks) {
  const Outcome outcome = run(ZSTRIP_COMMAND, {"render", "teapot", "--ram", "1000", "-o", "a.png"}, path(""));
  EXPECT_EQ(outcome.status, static_cast<int>(ExitStatus::budget));
  EXPECT_NE(outcome.err.find("missing"), std::string::npos) << outcome.err;
  EXPECT_TRUE(files().empty());
  const std::size_t at = outcome.err.find("--ram ");
  ASSERT_NE(at, std::string::npos) << outcome.err;
  const std::uint32_t smallest = static_cast<std::uint32_t>(std::stoul(outcome.err.substr(at + 6)));
  EXPECT_EQ(
      run(ZSTRIP_COMMAND, {"render", "teapot", "--ram", std::to_string(smallest), "-o", "a.png"}, path("")).status, 0);
  expect_failure(ExitStatus::budget, "RAM", {"render", "teapot", "--ram", std::to_string(smallest - 1), "-o", "b.png"});
}

/// The option was blamed, which was not given; plan's error had no words, and bake wrote what no board draws.
TEST_F(BadInput, DepthFormatOfASceneFileThatDoesNotGoWithItsEdges) {
  file("own.toml",
       "[picture]\nedges = true\ndepth_format = 'z24'\n"
       "[[model]]\nname = 'a'\nbuilt_in = 'knot_lit'\n[[instance]]\nmodel = 'a'\n");
  for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
           {"render", "own.toml"}, {"plan", "own.toml"}, {"bake", "own.toml", "-o", "scene.hpp"}}) {
    expect_failure(ExitStatus::usage, "'edges' does not go with 'depth_format' in the scene file", arguments);
  }
}

TEST_F(BadInput, ADepthFormatThatIsGoneIsRefusedWithWhatToUseInstead) {
  const std::string instead = "use z24, or float where memory is short";
  for (const char* command : {"render", "plan"}) {
    expect_failure(ExitStatus::usage, "'w16' is gone: " + instead, {command, "cube", "--depth-format", "w16"});
  }
  expect_failure(ExitStatus::usage, "'z32' is gone: use z24", {"render", "cube", "--depth-format", "z32"});
  file("old.toml",
       "[picture]\ndepth_format = 'w16'\n[[model]]\nname = 'a'\nbuilt_in = 'cube'\n[[instance]]\nmodel = 'a'\n");
  expect_failure(ExitStatus::input, "line 2: [picture]: 'depth_format' names no word 'w16'; it is gone, " + instead,
                 {"render", "old.toml"});
}

TEST_F(BadInput, MissingVisibleSetsSayWhatWritesThem) {
  expect_failure(ExitStatus::input,
                 "'gone.zpv' does not exist; 'zstrip bake' of this scene with --visible-sets writes it",
                 {"render", "cube", "--visible-sets", "gone.zpv", "-o", "picture.png"});
}

/// Was an internal error with two numbers.
TEST_F(BadInput, PoolOfAShadowThatIsTooSmallNamesItsKey) {
  file("scene.toml",
       "[[model]]\nname = 'a'\nbuilt_in = 'knot_lit'\n[[instance]]\nmodel = 'a'\n"
       "[[light]]\ndirection = [1, -1, 0]\nshadow = { size = 256, pool = 2400 }\n");
  expect_failure(ExitStatus::budget, "pool of 2,400 bytes; give the key 'pool'",
                 {"render", "scene.toml", "-o", "picture.png"});
}

TEST_F(BadInput, TooManyRowsForTheMemory) {
  expect_failure(ExitStatus::budget, "--strip-rows auto",
                 {"render", "teapot", "--ram", "20K", "--strip-rows", "200", "-o", "a.png"});
}

TEST_F(BadInput, TooLittleForWholeMeshesNamesMeshlets) {
  expect_failure(ExitStatus::budget, "meshlets", {"render", "knot", "--ram", "20K"});
  expect_failure(ExitStatus::budget, "RAM of 1 byte is too little", {"render", "knot", "--ram", "1"});
}

/// The reader of OpenGEX wrote a line of its own.
TEST_F(BadInput, OneLineWhateverTheReaderSays) {
  const std::filesystem::path models = ASSIMP_MODELS;
  if (models.empty()) GTEST_SKIP() << "package assimp-testmodels is not installed";
  expect_bad_file(models / "OpenGEX/empty_camera.ogex");
  // Its only face has three corners on a line.
  expect_failure(ExitStatus::input, "corners are not finite, or triangles have no area",
                 {"render", models / "OBJ/number_formats.obj"});
}

/// A polygon of so many corners that goes to and fro: the time of its triangulation grows with their square.
std::string comb_obj(int faces, int corners) {
  std::string obj;
  for (int i = 0; i < corners; ++i) {
    obj += "v " + std::to_string(i < corners / 2 ? i : corners - i) + ' ' +
           std::to_string(i % 2 * 5 + (i < corners / 2 ? 0 : 2)) + " 0\n";
  }
  std::string face = "f";
  for (int i = 1; i <= corners; ++i) face += ' ' + std::to_string(i);
  for (int i = 0; i < faces; ++i) obj += face + '\n';
  return obj;
}

TEST_F(BadInput, FilesThatTakeTooLongAreGivenUp) {
  // What the timer of the guard sends after 20 s comes after one; that the timer does, CrashGuardDeathTest shows.
  file("intricate.obj", comb_obj(40, 4900));
  const pid_t child = ::fork();
  if (child == 0) {
    if (::chdir(path("").c_str()) != 0 || std::freopen("err.txt", "w", stderr) == nullptr) ::_exit(126);
    ::execl(ZSTRIP_COMMAND, ZSTRIP_COMMAND, "render", "intricate.obj", "--quiet", nullptr);
    ::_exit(127);
  }
  clockid_t clock{};
  ASSERT_EQ(::clock_getcpuclockid(child, &clock), 0);
  timespec used{};
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds{60};
  while (used.tv_sec < 1 && ::clock_gettime(clock, &used) == 0 && std::chrono::steady_clock::now() < deadline) {
    std::this_thread::sleep_for(std::chrono::milliseconds{10});
  }
  ::kill(child, SIGPROF);
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), static_cast<int>(ExitStatus::input));
  EXPECT_EQ(read(path("err.txt")),
            "zstrip: 'intricate.obj' is not read after 20 s: the file is damaged, or too intricate; export it again\n");
  EXPECT_EQ(files(), (std::vector<std::string>{"err.txt", "intricate.obj"}));
}

TEST_F(BadInput, PlyThatWantsAllMemory) {
  file("huge.ply",
       "ply\nformat ascii 1.0\nelement vertex 4000000000\nproperty float x\nproperty float y\nproperty float z\n"
       "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n");
  expect_bad_file("huge.ply");
}

}  // namespace
}  // namespace zstrip::sim::test
