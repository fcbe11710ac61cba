// Values of options: what is taken, and that everything else is a usage error which names the option.
#include "cli/parse.hpp"
#include "cli/nearest_name.hpp"
#include "cli/output_names.hpp"
#include "support.hpp"
#include "text/edit_distance.hpp"
#include "text/number.hpp"

namespace zstrip::sim::test {
namespace {

template <typename T>
void expect_usage_error(const Result<T>& result, const std::string& option) {
  ASSERT_FALSE(result);
  EXPECT_EQ(result.failure().status, ExitStatus::usage);
  EXPECT_NE(result.failure().message.find(option), std::string::npos) << result.failure().message;
}

TEST(Parse, Size) {
  const auto size = parse_size("640x480");
  ASSERT_TRUE(size);
  EXPECT_EQ(size->first, 640);
  EXPECT_EQ(size->second, 480);
  EXPECT_TRUE(parse_size("1x4096"));
  for (const char* text : {"", "x", "0x0", "0x5", "5x0", "4097x1", "1x4097", "640", "640x", "x480", "-1x5", "6 x5",
                           "640x480x2", "99999999999x1"}) {
    expect_usage_error(parse_size(text), "--size");
  }
}

TEST(Parse, Bytes) {
  EXPECT_EQ(*parse_bytes("20000"), 20000U);
  EXPECT_EQ(*parse_bytes("20K"), 20480U);
  EXPECT_EQ(*parse_bytes("3M"), 3145728U);
  EXPECT_EQ(*parse_bytes("4095M"), 4293918720U);
  for (const char* text : {"16k", "16KB", "16kb", "16KiB", "16 KiB", "16 kb"}) EXPECT_EQ(*parse_bytes(text), 16384U);
  for (const char* text : {"2m", "2MB", "2 MiB"}) EXPECT_EQ(*parse_bytes(text), 2097152U);
  EXPECT_EQ(*parse_bytes("7B"), 7U);
  for (const char* text : {"", "K", "KB", " 5", "0", "-5", "4096M", "1G", "5000000000", "1.5K", "16KK"}) {
    expect_usage_error(parse_bytes(text), "--ram");
  }
}

TEST(Parse, StripRows) {
  EXPECT_EQ(*parse_strip_rows("auto"), 0);
  EXPECT_EQ(*parse_strip_rows("7"), 7);
  for (const char* text : {"", "0", "-1", "4097", "seven"}) expect_usage_error(parse_strip_rows(text), "--strip-rows");
}

TEST(Parse, Vector) {
  EXPECT_EQ(*parse_vector("--eye", "1,-2.5,3e2"), (std::array<double, 3>{1, -2.5, 300}));
  for (const char* text : {"", "1,2", "1,2,3,4", "1,,3", "a,b,c", "nan,0,0", "inf,0,0", "1 2 3"}) {
    expect_usage_error(parse_vector("--eye", text), "--eye");
  }
}

void expect_text(const std::string& message, const std::string& part) {
  EXPECT_NE(message.find(part), std::string::npos) << message;
}

TEST(Parse, WordsThatAreUnknownAreToldTheNearest) {
  expect_text(parse_format("rgb56").failure().message, "did you mean rgb565?");
  expect_text(parse_depth_format("z23").failure().message, "did you mean z24?");
  expect_text(parse_perspective("afine").failure().message, "did you mean affine?");
  expect_text(parse_image_type("pgn").failure().message, "did you mean png? Known are png, jpeg, ppm, raw");
  expect_text(parse_up_axis("-w").failure().message, "did you mean -x?");
}

TEST(Parse, EachLetterInsertedDeletedOrReplacedIsOneEdit) {
  EXPECT_EQ(edit_distance("", "abc"), 3);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3);
  EXPECT_EQ(edit_distance("st7798", "st7789"), 2);
}

TEST(Parse, NumbersThatAreUnknownAreToldTheNearest) {
  constexpr std::string_view kSamples[] = {"1", "2", "4"};
  EXPECT_EQ(nearest_name("16", kSamples), "4");
  EXPECT_EQ(nearest_name("-3000000", kSamples), "1");
  EXPECT_EQ(unknown_value("3", kSamples), "'3' is unknown, did you mean 2? Known are 1, 2, 4");
  EXPECT_EQ(unknown_value("four", kSamples), "'four' is not a number. Known are 1, 2, 4");
}

TEST(Parse, Words) {
  EXPECT_EQ(*parse_format("gray4"), PixelFormat::gray4);
  EXPECT_EQ(*parse_format("rgb565"), PixelFormat::rgb565);
  EXPECT_EQ(*parse_format("xrgb8888"), PixelFormat::xrgb8888);
  EXPECT_EQ(*parse_image_type("ppm"), ImageType::ppm);
  EXPECT_EQ(*parse_up_axis("-z"), UpAxis::minus_z);
  expect_usage_error(parse_format("rgb888"), "--format");
  expect_usage_error(parse_image_type("gif"), "--image");
  expect_usage_error(parse_up_axis("w"), "--up");
}

TEST(ParseDepthFormat, NamesAndNothingElse) {
  EXPECT_EQ(*parse_depth_format("z16"), DepthFormat::z16);
  EXPECT_EQ(*parse_depth_format("float"), DepthFormat::float16);
  EXPECT_EQ(*parse_depth_format("z24"), DepthFormat::z24);
  for (const char* text : {"", "z", "Z16", "z16 ", "16"})
    expect_usage_error(parse_depth_format(text), "--depth-format");
}

TEST(ParsePerspective, NamesAndNothingElse) {
  EXPECT_EQ(*parse_perspective("affine"), effect::perspective_affine);
  EXPECT_EQ(*parse_perspective("16"), Effects{});
  EXPECT_EQ(*parse_perspective("8"), effect::perspective_8);
  EXPECT_EQ(*parse_perspective("1"), effect::perspective_1);
  for (const char* text : {"", "Affine", "2", "16 "}) expect_usage_error(parse_perspective(text), "--perspective");
}

TEST(Grouped, ThreeDigits) {
  EXPECT_EQ(grouped(0), "0");
  EXPECT_EQ(grouped(999), "999");
  EXPECT_EQ(grouped(1000), "1,000");
  EXPECT_EQ(grouped(1234567), "1,234,567");
}

TEST(Counted, OneAndMore) {
  EXPECT_EQ(counted(0, "byte"), "0 bytes");
  EXPECT_EQ(counted(1, "byte"), "1 byte");
  EXPECT_EQ(counted(2345, "byte"), "2,345 bytes");
  EXPECT_EQ(counted(2, "mesh"), "2 meshes");
}

class OutputNamesTest : public FolderTest {};

TEST_F(OutputNamesTest, FilesAndFolders) {
  const auto name = [](std::optional<std::string> output, std::optional<std::uint32_t> frames = {}) {
    return *name_outputs("models/cat.3ds", output, frames, {}, PixelFormat::rgb565);
  };
  EXPECT_EQ(name({}).file(0), "cat.png");
  EXPECT_EQ(name({}, 3).file(2), "cat/frame_0002.png");
  EXPECT_EQ(name(path("a.ppm")).type, ImageType::ppm);
  EXPECT_EQ(name(path("a.ppm")).frames, 1U);
  EXPECT_EQ(name(path("folder")).frames, 8U);
  EXPECT_EQ(name(path("folder")).file(11).filename(), "frame_0011.png");
  std::filesystem::create_directory(path("folder.png"));
  EXPECT_TRUE(name(path("folder.png")).folder);
  EXPECT_FALSE(name(file("plain", "")).folder);
  expect_usage_error(name_outputs("cat", path("a.png"), 2, {}, PixelFormat::rgb565), "-o");
  expect_usage_error(name_outputs("cat", path("a.png"), {}, ImageType::raw, PixelFormat::rgb565), "--image");
  EXPECT_EQ(name(path("a.JPG")).type, ImageType::jpeg);
  EXPECT_EQ(name(path("a.apng")).frames, 8U);
  EXPECT_EQ(name(path("a.apng"), 3).file(2), path("a.apng"));
}

/// They became folders of that name.
TEST_F(OutputNamesTest, EndingsThatAreNoPictureTypeAreRefused) {
  const auto named = [](const std::string& output, std::optional<ImageType> type = {}) {
    return name_outputs("cat", output, {}, type, PixelFormat::rgb565);
  };
  for (const char* output : {"x.txt", "x.gif", "x.pgn", "folder/x.png.txt"}) {
    expect_usage_error(named(path(output)), "is not a picture type; files end in .png, .apng");
  }
  expect_usage_error(named(file("there.txt", "mine")), "'.txt'");
  EXPECT_FALSE(named(file("there.txt", "mine"), ImageType::png)->folder);
  for (const char* output : {"x.txt/", "v1.2", ".hidden", "x."}) EXPECT_TRUE(named(path(output))->folder) << output;
  std::filesystem::create_directory(path("folder.txt"));
  EXPECT_TRUE(named(path("folder.txt"))->folder);
}

}  // namespace
}  // namespace zstrip::sim::test
