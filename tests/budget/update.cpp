// Measures every program and writes what the tests compare with: update BINARIES FOLDER PAGE. BINARIES holds the
// programs, FOLDER budgets.csv and symbols.csv, PAGE the tables. Exit status: 0 written, 1 why not, 2 wrong words.
#include <exception>
#include <fstream>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <vector>

#include "budget_file.hpp"
#include "memory_page.hpp"
#include "usage.hpp"

namespace {

void update(const std::filesystem::path& binaries, const std::filesystem::path& folder,
            const std::filesystem::path& page_file) {
  using namespace zstrip::budget;
  std::vector<Usage> usages;
  SymbolTable symbols;
  for (const Target& target : targets()) {
    usages.push_back(measure(target, binaries));
    symbols[target.program] = symbol_sizes(file_of(target, binaries));
  }
  std::ifstream stream(page_file);
  const std::string page(std::istreambuf_iterator<char>(stream), {});
  const std::string fresh = page_with_tables(page, memory_tables(usages, compiler_version()));
  write_budgets(folder / "budgets.csv", usages);
  write_symbols(folder / "symbols.csv", symbols);
  std::ofstream out(page_file);
  out << fresh << std::flush;
  if (!out) throw std::runtime_error("cannot write " + page_file.string());
}

}  // namespace

int main(int count, char** words) {
  if (count != 4) {
    std::cerr << "usage: update BINARIES FOLDER PAGE\n";
    return 2;
  }
  try {
    update(words[1], words[2], words[3]);
  } catch (const std::exception& error) {
    std::cerr << "update: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
