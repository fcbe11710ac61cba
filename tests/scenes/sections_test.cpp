// The scenes take no RAM but for what is posed, and need nothing that a freestanding target does not have.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <memory>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace {

struct Symbol {
  std::string name, type, section;
};

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(' '), last = text.find_last_not_of(' ');
  return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

/// What `nm` says of the archive: name | value | class | type | size | line | section.
std::vector<Symbol> symbols_of_archive() {
  const std::string command = std::string(ZSTRIP_NM) + " --format=sysv '" + ZSTRIP_SCENES_ARCHIVE + "'";
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  if (!pipe) return {};
  std::string output;
  std::array<char, 4096> buffer{};
  while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), pipe.get()))
    output.append(buffer.data(), count);

  std::vector<Symbol> symbols;
  std::istringstream lines(output);
  for (std::string line; std::getline(lines, line);) {
    std::vector<std::string> fields;
    std::istringstream columns(line);
    for (std::string field; std::getline(columns, field, '|');) fields.push_back(trimmed(field));
    if (fields.size() == 7 && fields[0] != "Name") symbols.push_back({fields[0], fields[2], fields[6]});
  }
  return symbols;
}

bool starts_with(const std::string& text, const char* start) { return text.rfind(start, 0) == 0; }

TEST(Sections, TablesLieInReadOnlyMemory) {
  std::set<std::string> missing = {
      "kTeapotPositions",       "kTeapotNormals",   "kTeapotTriangles", "kKnotPositions", "kKnotColours",
      "kKnotTriangles",         "kRandom50",        "kRandom10k",       "kCubeTexels",    "kRoomTexels",
      "kRandom10kMeshletTable", "kKnotMeshletTable"};
  for (const Symbol& symbol : symbols_of_archive()) {
    for (const std::string& table : std::set<std::string>(missing)) {
      const std::string mangled = std::to_string(table.size()) + table + "E";
      if (symbol.name.find(mangled) != std::string::npos && starts_with(symbol.section, ".rodata"))
        missing.erase(table);
    }
  }
  for (const std::string& table : missing) ADD_FAILURE() << table << " is not in .rodata";
}

// What sanitizers and coverage add of their own to instrumented builds.
bool of_instrumentation(const std::string& name) {
  return starts_with(name, "__asan") || starts_with(name, "__odr_asan") || starts_with(name, "__ubsan") ||
         starts_with(name, "__gcov");
}

// Constants with pointers in them are relocated on hosts (.data.rel.ro) and lie in flash on boards.
TEST(Sections, NothingIsWritable) {
  std::size_t objects = 0;
  for (const Symbol& symbol : symbols_of_archive()) {
    if (!starts_with(symbol.name, "_ZN6zstrip")) continue;
    ++objects;
    if (symbol.name == "_ZN6zstrip6scenes16character_in_ramE") {
      EXPECT_TRUE(starts_with(symbol.section, ".bss")) << "zeros take no flash: " << symbol.section;
      continue;
    }
    if (symbol.name == "_ZN6zstrip6scenes18character_skinningE") continue;
    const bool writable = starts_with(symbol.section, ".bss") || starts_with(symbol.section, ".tbss") ||
                          symbol.section == "*COM*" ||
                          (starts_with(symbol.section, ".data") && !starts_with(symbol.section, ".data.rel.ro"));
    EXPECT_FALSE(writable) << symbol.name << " in " << symbol.section;
  }
  EXPECT_GT(objects, 40U);
}

TEST(Sections, NeedsOnlyTheCore) {
  std::set<std::string> defined, used;
  for (const Symbol& symbol : symbols_of_archive()) (symbol.type == "U" ? used : defined).insert(symbol.name);
  ASSERT_FALSE(used.empty());
  for (const std::string& name : used) {
    const bool allowed = defined.count(name) != 0 || starts_with(name, "mem") || name == "_GLOBAL_OFFSET_TABLE_" ||
                         name == "_ZN6zstrip4sineEi" || name == "_ZN6zstrip6cosineEi" || name == "__stack_chk_fail" ||
                         starts_with(name, "_ZN6zstrip4poseE") || starts_with(name, "_ZN6zstrip9pose_skinE") ||
                         of_instrumentation(name);
    EXPECT_TRUE(allowed) << name;
  }
}

}  // namespace
