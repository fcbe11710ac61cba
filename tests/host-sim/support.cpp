// What the tests of the host command share.
#include "support.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <numbers>
#include <sstream>
#include <utility>

namespace zstrip::sim::test {

std::string FolderTest::file(const std::string& name, const std::string& content) const {
  std::ofstream(path(name), std::ios::binary) << content;
  return path(name);
}

std::vector<std::string> FolderTest::files() const {
  std::vector<std::string> names;
  std::error_code ignored;  // of links in a circle
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_.path())) {
    if (entry.is_regular_file(ignored))
      names.push_back(std::filesystem::relative(entry.path(), folder_.path()).string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::string read(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

std::string cube_obj() {
  return "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n"
         "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 3 4 8 7\nf 2 3 7 6\nf 4 1 5 8\n";
}

std::string sphere_obj(int columns, int rows) {
  std::ostringstream obj;
  obj << "v 0 1 0\nv 0 -1 0\n";
  for (int row = 1; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const double theta = std::numbers::pi * row / rows;
      const double phi = 2 * std::numbers::pi * column / columns;
      const double radius = 1 + 0.1 * std::sin(8 * phi) * std::sin(theta) * std::sin(5 * theta);
      obj << "v " << radius * std::sin(theta) * std::sin(phi) << ' ' << radius * std::cos(theta) << ' '
          << radius * std::sin(theta) * std::cos(phi) << '\n';
    }
  }
  const auto index = [&](int row, int column) { return 3 + (row - 1) * columns + column % columns; };
  for (int column = 0; column < columns; ++column) {
    obj << "f 1 " << index(1, column) << ' ' << index(1, column + 1) << '\n';
    for (int row = 1; row + 1 < rows; ++row) {
      const int a = index(row, column), b = index(row + 1, column);
      const int c = index(row + 1, column + 1), d = index(row, column + 1);
      obj << "f " << a << ' ' << b << ' ' << c << "\nf " << a << ' ' << c << ' ' << d << '\n';
    }
    obj << "f 2 " << index(rows - 1, column + 1) << ' ' << index(rows - 1, column) << '\n';
  }
  return obj.str();
}

Outcome run(const std::string& program, const std::vector<std::string>& arguments, const std::string& folder,
            const Limits& limits) {
  // Outside `folder`, so that what the program leaves there is only the program's.
  std::string out_name = (std::filesystem::temp_directory_path() / "zstrip-out-XXXXXX").string();
  std::string err_name = (std::filesystem::temp_directory_path() / "zstrip-err-XXXXXX").string();
  const int out = ::mkstemp(out_name.data());
  const int err = ::mkstemp(err_name.data());
  std::vector<char*> words{const_cast<char*>(program.c_str())};
  for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
  words.push_back(nullptr);

  const pid_t child = ::fork();
  if (child == 0) {
    const int null = ::open("/dev/null", O_RDONLY);
    if (::chdir(folder.c_str()) != 0) ::_exit(126);
    for (const auto& [resource, most] :
         {std::pair{RLIMIT_FSIZE, limits.file_bytes}, std::pair{RLIMIT_AS, limits.memory}}) {
      const rlimit limit{most, most};
      if (most > 0) ::setrlimit(resource, &limit);
    }
    ::dup2(null, STDIN_FILENO);
    ::dup2(out, STDOUT_FILENO);
    ::dup2(err, STDERR_FILENO);
    for (const auto& [place, stream] : {std::pair{limits.out, STDOUT_FILENO}, std::pair{limits.err, STDERR_FILENO}}) {
      if (place == "-") ::close(stream);
      if (!place.empty() && place != "-") ::dup2(::open(place.c_str(), O_WRONLY), stream);
    }
    ::execv(program.c_str(), words.data());
    ::_exit(127);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  ::close(out);
  ::close(err);
  Outcome outcome{WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status), read(out_name), read(err_name)};
  ::unlink(out_name.c_str());
  ::unlink(err_name.c_str());
  return outcome;
}

}  // namespace zstrip::sim::test
