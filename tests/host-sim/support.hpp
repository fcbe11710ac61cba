// What the tests of the host command share: a folder of their own, models made to measure, running the program.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <string>
#include <vector>

#include "own_folder.hpp"

namespace zstrip::sim::test {

/// A fresh folder for each test, removed at its end.
class FolderTest : public ::testing::Test {
 protected:
  /// Writes a file into the folder and returns its path.
  std::string file(const std::string& name, const std::string& content) const;
  std::string path(const std::string& name) const { return (folder_.path() / name).string(); }
  /// Names of all files in the folder and below, sorted, hidden ones included.
  std::vector<std::string> files() const;

 private:
  OwnFolder folder_;
};

std::string read(const std::filesystem::path& path);

inline const std::string kTriangleObj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
/// A closed cube of side 2 around the origin, quads, outwards.
std::string cube_obj();
/// A closed, bumpy sphere of 2 * columns * (rows - 1) triangles.
std::string sphere_obj(int columns, int rows);

struct Outcome {
  int status = -1;  ///< exit status; 1000 + signal if killed
  std::string out, err;
};
struct Limits {
  std::uint64_t file_bytes = 0;  ///< largest file that the program may write; 0: no limit
  std::uint64_t memory = 0;      ///< bytes of addresses that the program may have; 0: no limit
  std::string out{}, err{};      ///< where the streams go instead of into Outcome; "-": closed
};
/// Runs `program` in `folder` and waits for it.
Outcome run(const std::string& program, const std::vector<std::string>& arguments, const std::string& folder,
            const Limits& limits = {});

}  // namespace zstrip::sim::test
