// docs/gallery.md has the figures that are counted, and the table of these is whole.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

#include "gallery_table.hpp"

namespace zstrip::gallery {
namespace {

std::string text_of(const char* file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

measured::Table recorded() { return measured::read_table(ZSTRIP_MEASURED "/gallery.csv", gallery_format()); }

/// Regression: estimates stood there, up to eight times too low.
TEST(Gallery, ThePageHasTheInstructionsAndBytesThatAreCounted) {
  const std::string page = text_of(ZSTRIP_MEASURED "/../gallery.md");
  for (const char* const scene : kScenes) {
    const PageRow row = row_of_page(recorded(), scene);
    const std::string begin = "\n" + row.begin;
    bool found = false;
    for (std::size_t at = page.find(begin); at != std::string::npos; at = page.find(begin, at + 1)) {
      const std::string line = page.substr(at + 1, page.find('\n', at + 1) - at - 1);
      found = found || line.ends_with(row.end);
    }
    EXPECT_TRUE(found) << "docs/gallery.md has no line " << row.begin << "... " << row.end;
  }
}

TEST(Gallery, TheTableOfMeasuredFiguresIsWrittenFromThem) {
  EXPECT_EQ(text_of(ZSTRIP_MEASURED "/gallery.md"), gallery_page(recorded())) << "tests/measure gallery writes both";
}

TEST(Gallery, ARowHasTheMeanAndTheMostOfItsFrames) {
  const measured::Row row = row_of("chess", "m3", "size", "22", parse_counted("3 0123abcd 10 20 60 30\n"), 60648);
  EXPECT_EQ(row, (measured::Row{"chess", "m3", "size", "22", "3", "30", "60", "60648"}));
  EXPECT_THROW(parse_counted("3 0123abcd"), std::runtime_error);
}

}  // namespace
}  // namespace zstrip::gallery
