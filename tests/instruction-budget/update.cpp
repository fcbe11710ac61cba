// Measures rows again: update ZSTRIP FIRMWARE BUDGETS [NAME...]. ZSTRIP is the command, FIRMWARE the folder of the
// programs for boards; without a NAME all rows of BUDGETS. Exit status: 0 written, 1 why not, 2 wrong words.
#include <algorithm>
#include <exception>
#include <iostream>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "budget_row.hpp"
#include "measure.hpp"

namespace {

using namespace zstrip::instruction_budget;

void update(const Programs& programs, const std::filesystem::path& file, const std::vector<std::string>& names) {
  BudgetFile budgets = read_budgets(file);
  const Compilers here = compilers_here();
  if (!names.empty() && here != budgets.compilers) {
    throw std::runtime_error("other compilers than those of " + file.string() + ": all rows must be measured again");
  }
  for (const std::string& name : names) {
    if (std::ranges::find(budgets.rows, name, &BudgetRow::name) == budgets.rows.end()) {
      throw std::runtime_error("there is no row " + name);
    }
  }
  budgets.compilers = here;
  for (BudgetRow& row : budgets.rows) {
    if (!names.empty() && std::ranges::find(names, row.name) == names.end()) continue;
    const auto measured = measure(row, programs);
    if (!measured) throw std::runtime_error("this machine cannot count the instructions of " + row.name);
    row.most = *measured;
  }
  write_budgets(file, budgets);
}

}  // namespace

int main(int count, char** words) {
  const std::vector<std::string> arguments(words + 1, words + count);
  if (arguments.size() < 3) {
    std::cerr << "usage: update ZSTRIP FIRMWARE BUDGETS [NAME...]\n";
    return 2;
  }
  try {
    update({arguments[0], arguments[1]}, arguments[2], {arguments.begin() + 3, arguments.end()});
  } catch (const std::exception& error) {
    std::cerr << "update: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
