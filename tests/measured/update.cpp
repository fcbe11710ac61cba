// Reads words, and turns what is thrown into messages.
#include "measured/update.hpp"

#include <algorithm>
#include <exception>
#include <iostream>

namespace zstrip::measured {

bool Choice::has(const std::string& row) const { return whole() || std::ranges::find(rows, row) != rows.end(); }

void check(const Choice& choice, const std::vector<std::string>& known) {
  for (const std::string& row : choice.rows) {
    if (std::ranges::find(known, row) != known.end()) continue;
    std::string message = "there is no row " + row + "; there are:";
    for (const std::string& each : std::set<std::string>(known.begin(), known.end())) message += " " + each;
    throw UnknownRow(message);
  }
}

Table recorded_or_empty(const std::filesystem::path& file, const Table& format) {
  return std::filesystem::exists(file) ? read_table(file, format) : format;
}

void say_progress(const std::string& part, std::size_t done, std::size_t all, const std::string& what) {
  std::cerr << part << ' ' << done << '/' << all << ": " << what << '\n';
}

int run_update(int count, char** words, const std::string& usage, std::size_t words_before,
               const std::function<void(const std::vector<std::string>& before, const Choice& choice)>& body) {
  std::vector<std::string> arguments(words + 1, words + count);
  if (arguments.size() < words_before) {
    std::cerr << "usage: " << usage << " [--exact] [ROW...]\n";
    return 2;
  }
  const auto rest = arguments.begin() + static_cast<std::ptrdiff_t>(words_before);
  Choice choice{.rows = {rest, arguments.end()}};
  choice.exact = std::erase(choice.rows, "--exact") != 0;
  arguments.erase(rest, arguments.end());
  try {
    body(arguments, choice);
  } catch (const UnknownRow& error) {
    std::cerr << error.what() << '\n';
    return 2;
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
  return 0;
}

}  // namespace zstrip::measured
