// Pictures: what is written can be read back, what is damaged is refused, and no file is ever half there.
#include <fcntl.h>
#include <turbojpeg.h>
#include <unistd.h>
#include <webp/encode.h>

#include <cstdlib>
#include <string>

#include "image/decode.hpp"
#include "image/encode.hpp"
#include "image/resample.hpp"
#include "image/write_file.hpp"
#include "render/render_frame.hpp"
#include "support.hpp"

namespace zstrip::sim::test {
namespace {

std::vector<std::byte> bytes(std::initializer_list<unsigned> values) {
  std::vector<std::byte> result;
  for (const unsigned value : values) result.push_back(static_cast<std::byte>(value));
  return result;
}

RgbImage round_trip(const View& view, const std::vector<std::byte>& pixels) {
  const auto file = encode(ImageType::png, view, pixels);
  EXPECT_TRUE(file);
  const auto image = decode_image(*file);
  EXPECT_TRUE(image) << image.failure().message;
  EXPECT_EQ(image->width, view.width);
  EXPECT_EQ(image->height, view.height);
  return *image;
}

TEST(Png, Rgb565RepeatsUpperBits) {
  // Red, green, blue, white; native order.
  const auto pixels = bytes({0x00, 0xF8, 0xE0, 0x07, 0x1F, 0x00, 0xFF, 0xFF});
  const std::vector<std::uint8_t> expected{255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255};
  EXPECT_EQ(round_trip({2, 2, PixelFormat::rgb565}, pixels).rgb, expected);
}

TEST(Png, SwappedIsTheSamePicture) {
  const auto swapped = bytes({0xF8, 0x00, 0x12, 0x34});
  const auto native = bytes({0x00, 0xF8, 0x34, 0x12});
  EXPECT_EQ(round_trip({2, 1, PixelFormat::rgb565_swapped}, swapped).rgb,
            round_trip({2, 1, PixelFormat::rgb565}, native).rgb);
}

TEST(Png, WiderAndNarrowerColoursRepeatUpperBits) {
  // The lowest two bits of rgb666 and the highest byte of xrgb8888 do not count; rows of rgb444 end at bytes.
  EXPECT_EQ(round_trip({2, 1, PixelFormat::rgb666}, bytes({0xFF, 0x03, 0x84, 0x00, 0x80, 0xFC})).rgb,
            (std::vector<std::uint8_t>{255, 0, 0x86, 0, 0x82, 255}));
  EXPECT_EQ(round_trip({1, 2, PixelFormat::xrgb8888}, bytes({1, 2, 3, 99, 255, 0, 128, 0})).rgb,
            (std::vector<std::uint8_t>{3, 2, 1, 128, 0, 255}));
  EXPECT_EQ(round_trip({3, 1, PixelFormat::rgb444}, bytes({0x12, 0x34, 0x56, 0x78, 0x90})).rgb,
            (std::vector<std::uint8_t>{0x11, 0x22, 0x33, 0x44, 0x55, 0x66, 0x77, 0x88, 0x99}));
}

TEST(Png, Gray4HasSixteenGreysAndPaddedRows) {
  const auto pixels = bytes({0x0F, 0x80, 0x12, 0x30});  // rows of three pixels
  const std::vector<std::uint8_t> grey{0, 255, 136, 17, 34, 51};
  std::vector<std::uint8_t> expected;
  for (const std::uint8_t value : grey) expected.insert(expected.end(), 3, value);
  EXPECT_EQ(round_trip({3, 2, PixelFormat::gray4}, pixels).rgb, expected);
}

TEST(Png, MonoLeftPixelIsTheHighBit) {
  const auto image = round_trip({9, 1, PixelFormat::mono}, bytes({0x81, 0x80}));
  for (std::uint32_t x = 0; x < 9; ++x) EXPECT_EQ(image.pixel(x, 0)[0], x == 0 || x == 7 || x == 8 ? 255 : 0) << x;
}

TEST(Ppm, HeaderAndPixels) {
  const auto file = encode(ImageType::ppm, {1, 2, PixelFormat::rgb565}, bytes({0x00, 0xF8, 0x1F, 0x00}));
  ASSERT_TRUE(file);
  EXPECT_EQ(std::string(file->begin(), file->end()), std::string("P6\n1 2\n255\n\xFF\0\0\0\0\xFF", 17));
}

TEST(Ppm, GreyIsPgm) {
  const auto file = encode(ImageType::ppm, {3, 1, PixelFormat::gray4}, bytes({0x0F, 0x80}));
  ASSERT_TRUE(file);
  EXPECT_EQ(std::string(file->begin(), file->end()), std::string("P5\n3 1\n255\n\0\xFF\x88", 14));
  EXPECT_STREQ(file_extension(ImageType::ppm, PixelFormat::gray4), ".pgm");
}

TEST(Raw, IsTheBytesOfTheStrips) {
  const auto pixels = bytes({1, 2, 3, 4});
  const auto file = encode(ImageType::raw, {2, 1, PixelFormat::rgb565}, pixels);
  ASSERT_TRUE(file);
  EXPECT_EQ(*file, (std::vector<std::uint8_t>{1, 2, 3, 4}));
}

TEST(Decode, TruncatedPngIsRefusedOrWhole) {
  std::vector<std::byte> noise;
  std::uint32_t state = 1;
  for (int i = 0; i < 512; ++i) {
    state = state * 1664525 + 1013904223;
    noise.push_back(static_cast<std::byte>(state >> 24));
  }
  const auto file = encode(ImageType::png, {16, 16, PixelFormat::rgb565}, noise);
  ASSERT_TRUE(file);
  const auto whole = decode_image(*file);
  ASSERT_TRUE(whole);
  for (std::size_t length = 0; length < file->size(); ++length) {
    // A buffer of exactly this length, so that a sanitizer sees a read beyond it.
    const std::vector<std::uint8_t> head(file->begin(), file->begin() + static_cast<std::ptrdiff_t>(length));
    const auto image = decode_image(head);
    if (length < file->size() * 9 / 10) {
      EXPECT_FALSE(image) << length;
    }
    // Only check sums and the end mark may be missing.
    if (image) {
      EXPECT_EQ(image->rgb, whole->rgb) << length;
    }
  }
}

TEST(Decode, JpegAndItsTruncation) {
  const std::vector<std::uint8_t> grey(3 * 20 * 10, 200);
  const tjhandle jpeg = tjInitCompress();
  unsigned char* data = nullptr;
  unsigned long size = 0;
  ASSERT_EQ(tjCompress2(jpeg, grey.data(), 20, 0, 10, TJPF_RGB, &data, &size, TJSAMP_444, 95, 0), 0);
  const std::vector<std::uint8_t> file(data, data + size);
  tjFree(data);
  tjDestroy(jpeg);

  const auto image = decode_image(file);
  ASSERT_TRUE(image) << image.failure().message;
  EXPECT_EQ(image->width, 20U);
  EXPECT_EQ(image->height, 10U);
  for (const std::uint8_t value : image->rgb) EXPECT_NEAR(value, 200, 2);
  EXPECT_FALSE(decode_image(std::span(file).first(file.size() / 2)));
}

/// 3x2 pixels: red, green, blue; white, black, grey. What else is read of them is in `alpha`.
const std::vector<std::uint8_t> kSixPixels{255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255, 0, 0, 0, 128, 128, 128};

/// Every shorter file is refused, and the whole one is these pixels.
void expect_whole_only(const std::vector<std::uint8_t>& file, const std::vector<std::uint8_t>& alpha = {}) {
  const Result<RgbImage> image = decode_image(file);
  ASSERT_TRUE(image) << image.failure().message;
  EXPECT_EQ(image->width, 3U);
  EXPECT_EQ(image->height, 2U);
  EXPECT_EQ(image->rgb, kSixPixels);
  EXPECT_EQ(image->alpha, alpha);
  for (std::size_t length = 0; length < file.size(); ++length) {
    EXPECT_FALSE(decode_image({file.data(), length})) << length;
  }
}

/// 65535x1 was "not whole", and 16384x8192 took ten seconds and a gigabyte.
TEST(Decode, TooManyPixelsAreSaidByTheHeaderAlone) {
  const auto png = [](std::uint32_t width, std::uint32_t height) {
    std::vector<std::uint8_t> file{0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n', 0, 0, 0, 13, 'I', 'H', 'D', 'R'};
    const auto append = [&file](std::uint32_t value) {
      for (int shift = 24; shift >= 0; shift -= 8) file.push_back(static_cast<std::uint8_t>(value >> shift));
    };
    append(width), append(height);
    file.insert(file.end(), {8, 6, 0, 0, 0});
    append(checksum(std::as_bytes(std::span(file).subspan(12))));
    return file;
  };
  const auto targa = [](unsigned width, unsigned height) {
    const auto byte = [](unsigned value) { return static_cast<std::uint8_t>(value & 255); };
    return std::vector<std::uint8_t>{
        0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, byte(width), byte(width >> 8), byte(height), byte(height >> 8), 24, 0};
  };
  const struct {
    std::vector<std::uint8_t> file;
    std::string words;
  } cases[] = {{png(65535, 1), "is too large: 65535x1 pixels; at most 16,384 a side and 67,108,864 together are read"},
               {png(1, 0x7FFFFFFF), "is too large: 1x2147483647 pixels"},
               {png(16384, 8192), "is too large: 16384x8192 pixels"},
               {png(16384, 4096), "is not a whole PNG picture"},
               {png(8192, 8192), "is not a whole PNG picture"},
               {targa(65535, 1), "is too large: 65535x1 pixels"},
               {targa(16384, 4097), "is too large: 16384x4097 pixels"},
               {targa(16384, 4096), "is not a whole TGA picture (it is cut off)"}};
  for (const auto& [file, words] : cases) {
    const Result<RgbImage> image = decode_image(file);
    ASSERT_FALSE(image);
    EXPECT_EQ(image.failure().message.rfind(words, 0), 0U) << image.failure().message;
  }
}

TEST(Decode, Targa) {
  // From the bottom up, blue first: that is the format's default.
  const std::vector<std::uint8_t> head{0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 3, 0, 2, 0, 24, 0};
  std::vector<std::uint8_t> plain = head;
  plain.insert(plain.end(), {255, 255, 255, 0, 0, 0, 128, 128, 128, 0, 0, 255, 0, 255, 0, 255, 0, 0});
  expect_whole_only(plain);
  // With alpha, from the top down.
  std::vector<std::uint8_t> alpha = head;
  alpha[16] = 32, alpha[17] = 0x28;
  for (std::size_t i = 0; i < 6; ++i) {
    const std::uint8_t* const pixel = &kSixPixels[3 * i];
    alpha.insert(alpha.end(), {pixel[2], pixel[1], pixel[0], static_cast<std::uint8_t>(40 * i)});
  }
  expect_whole_only(alpha, {0, 40, 80, 120, 160, 200});
  // A run of six and nothing else.
  std::vector<std::uint8_t> runs = head;
  runs[2] = 10;
  runs.insert(runs.end(), {0x85, 30, 20, 10});
  const Result<RgbImage> one = decode_image(runs);
  ASSERT_TRUE(one) << one.failure().message;
  EXPECT_EQ(one->rgb,
            (std::vector<std::uint8_t>{10, 20, 30, 10, 20, 30, 10, 20, 30, 10, 20, 30, 10, 20, 30, 10, 20, 30}));
  // Cut off in its palette, its text, or its runs.
  std::vector<std::uint8_t> text = runs;
  text[0] = 255;
  EXPECT_FALSE(decode_image(text));
  std::vector<std::uint8_t> short_runs = runs;
  short_runs[18] = 0x84;
  EXPECT_FALSE(decode_image(short_runs));
  std::vector<std::uint8_t> palette = head;
  palette[1] = palette[2] = 1, palette[5] = 200, palette[7] = 24, palette[16] = 8;
  palette.insert(palette.end(), 30, 0);
  EXPECT_FALSE(decode_image(palette));
  // A small file that claims to be large.
  runs[13] = runs[15] = 0x30;
  EXPECT_FALSE(decode_image(runs));
}

TEST(Decode, Bitmap) {
  std::vector<std::uint8_t> file{'B', 'M', 78, 0, 0, 0, 0, 0, 0, 0, 54, 0, 0, 0, 40, 0, 0,  0,
                                 3,   0,   0,  0, 2, 0, 0, 0, 1, 0, 24, 0, 0, 0, 0,  0, 24, 0,
                                 0,   0,   0,  0, 0, 0, 0, 0, 0, 0, 0,  0, 0, 0, 0,  0, 0,  0};
  file.insert(file.end(), {255, 255, 255, 0, 0, 0, 128, 128, 128, 0, 0, 0, 0, 0, 255, 0, 255, 0, 255, 0, 0, 0, 0, 0});
  expect_whole_only(file);
}

/// A negative height says that the first row is the highest.
TEST(Decode, BitmapFromTheTopDown) {
  std::vector<std::uint8_t> file{'B', 'M', 78, 0, 0,    0,    0,    0,    0, 0, 54, 0, 0, 0, 40, 0, 0,  0,
                                 3,   0,   0,  0, 0xFE, 0xFF, 0xFF, 0xFF, 1, 0, 24, 0, 0, 0, 0,  0, 24, 0,
                                 0,   0,   0,  0, 0,    0,    0,    0,    0, 0, 0,  0, 0, 0, 0,  0, 0,  0};
  file.insert(file.end(), {0, 0, 255, 0, 255, 0, 255, 0, 0, 0, 0, 0, 255, 255, 255, 0, 0, 0, 128, 128, 128, 0, 0, 0});
  expect_whole_only(file);
}

TEST(Decode, Webp) {
  const auto encoded = [](const std::vector<std::uint8_t>& pixels, bool alpha) {
    std::uint8_t* out = nullptr;
    const std::size_t size = alpha ? WebPEncodeLosslessRGBA(pixels.data(), 3, 2, 12, &out)
                                   : WebPEncodeLosslessRGB(pixels.data(), 3, 2, 9, &out);
    std::vector<std::uint8_t> file(out, out + size);
    WebPFree(out);
    return file;
  };
  expect_whole_only(encoded(kSixPixels, false));
  std::vector<std::uint8_t> rgba;
  for (std::size_t i = 0; i < 6; ++i) {
    rgba.insert(rgba.end(), {kSixPixels[3 * i], kSixPixels[3 * i + 1], kSixPixels[3 * i + 2], 200});
  }
  expect_whole_only(encoded(rgba, true), std::vector<std::uint8_t>(6, 200));
}

TEST(Decode, OtherBytesAreRefused) {
  const std::string text = "BM this is no picture that we read";
  EXPECT_FALSE(decode_image({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}));
  EXPECT_FALSE(decode_image({}));
}

TEST(Decode, OtherFormatsAreNamed) {
  const auto said = [](std::string_view text) {
    const auto image = decode_image({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
    return image ? "" : image.failure().message;
  };
  EXPECT_EQ(said("\xABKTX 20\xBB\r\n\x1A\n"), "is a picture in KTX 2; PNG, JPEG, WebP, BMP and TGA are read");
  EXPECT_EQ(said(std::string("\0\0\0\x20", 4) + "ftypavif"),
            "is a picture in AVIF; PNG, JPEG, WebP, BMP and TGA are read");
  EXPECT_EQ(said("abc"), "is not a picture in PNG, JPEG, WebP, BMP or TGA");
}

TEST(Resample, PowersOfTwoAreLeftAlone) {
  const RgbImage image{2, 1, {1, 2, 3, 4, 5, 6}};
  EXPECT_EQ(resample_to_power_of_two(image).rgb, image.rgb);
}

TEST(Resample, OddSidesGrowAndKeepAPlainColour) {
  RgbImage image{3, 5, {}};
  for (int i = 0; i < 15; ++i) image.rgb.insert(image.rgb.end(), {10, 200, 77});
  const RgbImage scaled = resample_to_power_of_two(image);
  EXPECT_EQ(scaled.width, 4U);
  EXPECT_EQ(scaled.height, 8U);
  ASSERT_EQ(scaled.rgb.size(), 96U);
  for (std::size_t i = 0; i < scaled.rgb.size(); i += 3) {
    EXPECT_EQ(scaled.rgb[i], 10);
    EXPECT_EQ(scaled.rgb[i + 1], 200);
    EXPECT_EQ(scaled.rgb[i + 2], 77);
  }
}

/// Small palettes were interpolated: a mesh that takes the middle of a texel got a mix of colours.
TEST(Resample, CentresOfAPalettesTexelsKeepTheirColours) {
  using Sides = std::pair<std::uint32_t, std::uint32_t>;
  for (const auto& [width, height] :
       {Sides{3, 1}, Sides{5, 1}, Sides{1, 3}, Sides{6, 2}, Sides{20, 1}, Sides{7, 9}, Sides{63, 65}, Sides{1000, 3}}) {
    RgbImage image{width, height, {}};
    const auto colour = [](std::uint32_t x, std::uint32_t y) {
      return std::array{static_cast<std::uint8_t>(97 * x), static_cast<std::uint8_t>(x / 4),
                        static_cast<std::uint8_t>(89 * y)};
    };
    for (std::uint32_t y = 0; y < height; ++y) {
      for (std::uint32_t x = 0; x < width; ++x) {
        const auto own = colour(x, y);
        image.rgb.insert(image.rgb.end(), own.begin(), own.end());
        image.alpha.push_back(own[0]);
      }
    }
    const RgbImage scaled = resample_to_power_of_two(image);
    for (std::uint32_t y = 0; y < height; ++y) {
      for (std::uint32_t x = 0; x < width; ++x) {
        const std::uint32_t u = (2 * x + 1) * scaled.width / (2 * width),
                            v = (2 * y + 1) * scaled.height / (2 * height);
        const auto own = colour(x, y);
        EXPECT_TRUE(std::equal(own.begin(), own.end(), scaled.pixel(u, v))) << width << " " << x << " " << y;
        EXPECT_EQ(scaled.alpha_at(u, v), own[0]);
      }
    }
  }
}

TEST(Resample, LargeSidesAreAveraged) {
  RgbImage image{4096, 1, {}};
  for (int i = 0; i < 4096; ++i) image.rgb.insert(image.rgb.end(), 3, i % 2 == 0 ? 100 : 200);
  const RgbImage scaled = resample_to_power_of_two(image);
  EXPECT_EQ(scaled.width, 2048U);
  EXPECT_EQ(scaled.height, 1U);
  for (const std::uint8_t value : scaled.rgb) ASSERT_EQ(value, 150);
}

class WriteFile : public FolderTest {
 protected:
  static std::span<const std::uint8_t> content() {
    static const std::vector<std::uint8_t> kBytes{'n', 'e', 'w'};
    return kBytes;
  }
};

TEST_F(WriteFile, ReplacesAndLeavesNothingElse) {
  file("a", "old");
  ASSERT_TRUE(write_file(path("a"), content(), "-o"));
  EXPECT_EQ(read(path("a")), "new");
  EXPECT_EQ(files(), std::vector<std::string>{"a"});
}

/// The temporary name was longer than a name may be.
TEST_F(WriteFile, NamesOfAnyLengthThatTheSystemTakes) {
  const std::string longest(255, 'n');
  ASSERT_TRUE(write_file(path(longest), content(), "-o"));
  EXPECT_EQ(files(), std::vector<std::string>{longest});
  const auto longer = write_file(path(longest + 'n'), content(), "-o");
  ASSERT_FALSE(longer);
  EXPECT_NE(longer.failure().message.find("File name too long"), std::string::npos) << longer.failure().message;
  EXPECT_EQ(files(), std::vector<std::string>{longest});
}

TEST_F(WriteFile, WritesThroughLinks) {
  file("a", "old");
  std::filesystem::create_symlink("a", path("link"));
  ASSERT_TRUE(write_file(path("link"), content(), "-o"));
  EXPECT_TRUE(std::filesystem::is_symlink(path("link")));
  EXPECT_EQ(read(path("a")), "new");
}

TEST_F(WriteFile, DevicesStayDevices) {
  ASSERT_TRUE(write_file("/dev/null", content(), "-o"));
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
  const auto full = write_file("/dev/full", content(), "-o");
  ASSERT_FALSE(full);
  EXPECT_EQ(full.failure().status, ExitStatus::output);
  EXPECT_NE(full.failure().message.find("/dev/full"), std::string::npos);
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));
}

TEST_F(WriteFile, OutputWhoseFileWasDeletedKeepsItsLink) {
  file("deleted", "old and longer");
  const int output = ::open(path("deleted").c_str(), O_RDONLY | O_CLOEXEC);
  ASSERT_GE(output, 0);
  std::filesystem::remove(path("deleted"));
  // As /dev/stdout is a link.
  std::filesystem::create_symlink("/proc/self/fd/" + std::to_string(output), path("link"));
  ASSERT_TRUE(write_file(path("link"), content(), "-o"));
  EXPECT_TRUE(std::filesystem::is_symlink(path("link")));
  char written[8] = {};
  EXPECT_EQ(::pread(output, written, sizeof written, 0), 3);
  EXPECT_STREQ(written, "new");
  ::close(output);
}
TEST_F(WriteFile, MissingFolderAndFolderAsFileFail) {
  EXPECT_FALSE(write_file(path("no/such/a"), content(), "-o"));
  std::filesystem::create_directory(path("d"));
  EXPECT_FALSE(write_file(path("d"), content(), "-o"));
  EXPECT_TRUE(files().empty());
}

}  // namespace
}  // namespace zstrip::sim::test
