// Reads the words, and writes or compares the table.
#include "part.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>

#include "machines.hpp"

namespace zstrip::effects_cost {
namespace {

constexpr int kSkipped = 77;

Names split(const std::string& text) {
  Names words;
  std::istringstream stream(text);
  for (std::string word; std::getline(stream, word, ',');) words.push_back(word);
  return words;
}

void write(const Part& part, const Names& before, const measured::Choice& choice) {
  measured::check(choice, part.names);
  measured::Table fresh = part.format;
  fresh.notes = part.notes;
  std::size_t done = 0;
  for (const std::string& name : part.names) {
    ++done;
    if (!choice.has(name)) continue;
    measured::say_progress(fresh.part, done, part.names.size(), name);
    for (measured::Row& row : part.measure(name, before[1], split(before[3]))) fresh.rows.push_back(std::move(row));
  }
  const std::filesystem::path csv = before[2] + ".csv", page = before[2] + ".md";
  const measured::Table recorded = measured::recorded_or_empty(csv, part.format);
  const measured::Table merged = measured::merged(recorded, fresh, choice.exact, choice.whole());
  measured::write_table(csv, merged);
  std::ofstream stream(page);
  stream << part.page(merged) << std::flush;
  if (!stream) throw std::runtime_error("cannot write " + page.string());
}

int compare(const Part& part, const Names& before, const measured::Choice& choice) {
  measured::check(choice, part.names);
  const measured::Table table = measured::read_table(before[2] + ".csv", part.format);
  if (table.notes != part.notes) {
    std::cout << "the recorded figures are those of other compilers\n";
    return kSkipped;
  }
  bool right = true;
  for (const std::string& name : choice.rows) {
    std::string lines;
    for (const measured::Row& row : part.measure(name, before[1], {kCheckedMachine})) lines += complaint(table, row);
    if (part.check) lines += part.check(name, before[1]);
    std::cout << (lines.empty() ? "agrees: " + name + "\n" : lines);
    right = right && lines.empty();
  }
  return right ? 0 : 1;
}

}  // namespace

int run_part(int count, char** words, const Part& part) {
  const std::string command = count > 1 ? words[1] : "";
  const auto print = [](const auto& lines) {
    for (const std::string& line : lines) std::cout << line << '\n';
  };
  if (command == "names") {
    print(part.names);
    return 0;
  }
  if (command == "usual") {
    print(part.usual);
    return 0;
  }
  int status = 0;
  const int failed =
      measured::run_update(count, words, "names | usual | programs | measure BUILD FILE MACHINES | check BUILD FILE",
                           command == "measure" ? 4
                           : command == "check" ? 3
                                                : 1,
                           [&](const Names& before, const measured::Choice& choice) {
                             if (command == "programs") {
                               measured::check(choice, part.names);
                               std::set<std::string> programs;
                               for (const std::string& name : part.names) {
                                 if (choice.has(name)) programs.merge(part.programs(name));
                               }
                               print(programs);
                             } else if (command == "measure") {
                               write(part, before, choice);
                             } else if (command == "check") {
                               status = compare(part, before, choice);
                             } else {
                               status = 2;
                               std::cerr << "there is no command " << command << '\n';
                             }
                           });
  return failed != 0 ? failed : status;
}

}  // namespace zstrip::effects_cost
