// An import says what it does, and ends in time.
#include "import_fixture.hpp"

#include <chrono>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "gltf_file.hpp"
#include "import/crash_guard.hpp"
#include "import/read_model.hpp"
#include "text/step_report.hpp"

namespace zstrip::sim::test {
namespace {

/// A model of 4.5 million triangles gave no sign of life for 91 s.
TEST_F(Import, TellsWhatItIsDoing) {
  file("cube.obj", cube_obj());
  testing::internal::CaptureStderr();
  {
    const StepReport report(true, std::chrono::milliseconds{0});
    model(path("cube.obj"));
  }
  model(path("cube.obj"));
  EXPECT_EQ(testing::internal::GetCapturedStderr(),
            "zstrip: reading 'cube.obj', 0 s\nzstrip: finding the surfaces of 'cube.obj', 0 s\n"
            "zstrip: merging the vertices of 'cube.obj', 0 s\nzstrip: quantising the vertices, 0 s\n"
            "zstrip: cutting the model into meshlets, 0 s\n");
}

/// The thread that reports must not need the one that works.
TEST(StepReport, TellsAStepThatTakesLong) {
  testing::internal::CaptureStderr();
  {
    const StepReport report(true, std::chrono::milliseconds{20});
    tell_step("waiting");
    std::this_thread::sleep_for(std::chrono::seconds{1});
  }
  EXPECT_NE(testing::internal::GetCapturedStderr().find("zstrip: waiting, "), std::string::npos);
  testing::internal::CaptureStderr();
  {
    const StepReport report(false, std::chrono::milliseconds{0});
    tell_step("waiting");
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

class GltfWork : public Import {
 protected:
  /// The processor time in seconds of reading a file of one root node; `nodes`: the nodes behind it, with commas
  /// between them, all of them children of the root.
  double seconds_of(const std::string& root, std::size_t children, const std::string& nodes,
                    const std::string& members) {
    std::string list;
    for (std::size_t i = 1; i <= children; ++i) list += (i == 1 ? "" : ",") + std::to_string(i);
    const std::string path =
        file("w.gltf", gltf_of(R"("nodes":[{)" + root + R"("children":[)" + list + "]}," + nodes + "]," + members));
    const std::clock_t begin = std::clock();
    const Result<SourceModel> read = read_model(path, UpAxis::plus_y);
    EXPECT_TRUE(read) << read.failure().message;
    return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  }
};

std::string json_list(std::size_t count, const std::function<std::string(std::size_t)>& part) {
  std::string all;
  for (std::size_t i = 0; i < count; ++i) all += (i == 0 ? "" : ",") + part(i);
  return all;
}

/// All nodes were placed again for each one that is enlarged.
TEST_F(GltfWork, NodesOfNoSizeWerePlacedOneByOne) {
  constexpr std::size_t kNodes = 12000;
  GltfData data;
  data.add_floats({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3");
  data.add_floats({0, 1}, "SCALAR");
  data.add_floats({0, 0, 0, 1, 1, 1}, "VEC3");
  const std::string channels = json_list(kNodes, [](std::size_t i) {
    return R"({"sampler":0,"target":{"node":)" + std::to_string(i + 1) + R"(,"path":"scale"}})";
  });
  const auto seconds = [&](const std::string& scale) {
    return seconds_of(R"("mesh":0,)", kNodes,
                      json_list(kNodes, [&](std::size_t) { return R"({"scale":)" + scale + "}"; }),
                      R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"animations":[{"channels":[)" +
                          channels + R"(],"samplers":[{"input":1,"output":2}]}],)" + data.json());
  };
  const double usual = seconds("[1,1,1]");
  EXPECT_LT(seconds("[0,0,0]"), 4 * usual + 0.5);
}

/// Each joint was compared with all before it, also when the skin had too many long before.
TEST_F(GltfWork, JointsOfASkinThatIsLeftOutWereCompared) {
  constexpr std::size_t kJoints = 30000;
  GltfData data;
  std::vector<float> places, weights;
  std::string joints;
  std::vector<std::uint16_t> corners;
  for (std::size_t i = 0; i < kJoints / 4; ++i) {
    const auto at = static_cast<float>(i);
    places.insert(places.end(), {at, at * at, 0});
    weights.insert(weights.end(), {0.25F, 0.25F, 0.25F, 0.25F});
    for (std::size_t k = 4 * i; k < 4 * i + 4; ++k) {
      joints += {static_cast<char>(k & 0xFF), static_cast<char>(k >> 8)};
    }
    if (i >= 2) corners.insert(corners.end(), {0, static_cast<std::uint16_t>(i - 1), static_cast<std::uint16_t>(i)});
  }
  data.add_floats(places, "VEC3");
  data.add_floats(weights, "VEC4");
  data.add(joints, R"("componentType":5123,"count":)" + std::to_string(kJoints / 4) + R"(,"type":"VEC4")");
  data.add_indices(corners);
  data.add_floats({0, 1}, "SCALAR");
  data.add_floats({0, 0, 0, 1, 1, 1}, "VEC3");
  const auto seconds = [&](const std::string& path) {
    const auto place = [](std::size_t i) { return R"({"translation":[)" + std::to_string(i) + ",0,0]}"; };
    const auto number = [](std::size_t i) { return std::to_string(i + 1); };
    return seconds_of(R"("mesh":0,"skin":0,)", kJoints, json_list(kJoints, place),
                      R"("skins":[{"joints":[)" + json_list(kJoints, number) +
                          R"(]}],"meshes":[{"primitives":[{"attributes":{"POSITION":0,"WEIGHTS_0":1,"JOINTS_0":2},)"
                          R"("indices":3}]}],"animations":[{"channels":[{"sampler":0,"target":{"node":1,"path":")" +
                          path + R"("}}],"samplers":[{"input":4,"output":5}]}],)" + data.json());
  };
  const double at_rest = seconds("weights");
  EXPECT_LT(seconds("translation"), 4 * at_rest + 0.5);
}

/// Each weight was sought among all of its animation.
TEST_F(GltfWork, WeightsOfMorphTargetsWereSoughtOneByOne) {
  constexpr std::size_t kTargets = 60000;
  const auto seconds = [&](float moved) {
    GltfData data;
    data.add_floats({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3");
    data.add_floats({0}, "SCALAR");
    data.add_floats(std::vector<float>(kTargets, moved), "SCALAR");
    return seconds_of("", 1, R"({"mesh":0})",
                      R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"targets":[)" +
                          json_list(kTargets, [](std::size_t) { return std::string("{}"); }) +
                          R"(]}]}],"animations":[{"channels":[{"sampler":0,"target":{"node":1,"path":"weights"}}],)"
                          R"("samplers":[{"input":1,"output":2}]}],)" +
                          data.json());
  };
  const double at_rest = seconds(0);
  const double moving = seconds(1);
  EXPECT_LT(moving, 4 * at_rest + 0.5);
}

using CrashGuardDeathTest = Import;

TEST_F(CrashGuardDeathTest, EndsALoopAfterItsTime) {
  const auto loop = [] {
    const CrashGuard guard("crashed", "took too long", std::chrono::seconds{1}, ~std::uint64_t{0});
    while (std::clock() >= 0) {
    }
  };
  EXPECT_EXIT(loop(), ::testing::ExitedWithCode(4), "^took too long\n$");
}

TEST_F(CrashGuardDeathTest, LiftedLimitsLetWorkGoOn) {
  const auto work = [] {
    CrashGuard guard("crashed", "took too long", std::chrono::seconds{1}, 1);
    guard.lift_limits();
    const std::clock_t begin = std::clock();
    while (std::clock() - begin < 2 * CLOCKS_PER_SEC) {
    }
    const std::vector<char> memory(std::size_t{64} << 20);
    std::_Exit(memory.back());
  };
  EXPECT_EXIT(work(), ::testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace zstrip::sim::test
