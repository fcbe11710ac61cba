// Models that are made smaller: textures shrunk, triangles removed, and what may not change by it.
#include <string>

#include "reduced_model.hpp"

namespace zstrip::sim::test {
namespace {

using Reduction = ReducedModel;

TEST_F(Reduction, TexturesAreShrunkToTheSizeAskedForAndLookAlike) {
  texture("colours.tga", 256);
  const std::string model = textured_sphere(24, 12);
  const Json whole = report({"bake", model, "-o", "whole.zsc"});
  const Json small = report({"bake", model, "-o", "small.zsc", "--texture-size", "64"});
  EXPECT_EQ(whole.at("flash_bytes").at("textures"), 2 * 256 * 256);
  EXPECT_EQ(small.at("flash_bytes").at("textures"), 2 * 64 * 64);
  EXPECT_EQ(small.at("flash_bytes").at("total"), read(path("small.zsc")).size());
  const Json shrunk = {{"textures", 1}, {"texels_before", 256 * 256}, {"texels", 64 * 64}};
  EXPECT_EQ(small.at("shrunk"), shrunk);
  EXPECT_EQ(whole.at("shrunk"), nullptr);
  EXPECT_EQ(report({"bake", model, "-o", "same.zsc", "--texture-size", "512"}).at("flash_bytes"),
            whole.at("flash_bytes"));
  const RgbImage before = picture(model, {});
  EXPECT_LT(mean_difference(before, picture(model, {"--texture-size", "64"})), 1.5);
  EXPECT_GT(mean_difference(before, picture(model, {"--texture-size", "1"})), 5);
  EXPECT_EQ(zstrip({"plan", model, "--texture-size", "64", "--triangles", "50%"}).status, 0);
}

TEST_F(Reduction, TexturesBecomeColoursOfVertices) {
  texture("colours.tga", 256);
  const std::string model = textured_sphere(24, 12);
  const Json whole = report({"bake", model, "-o", "whole.zsc"});
  const Json folded = report({"bake", model, "-o", "folded.zsc", "--texture-size", "0"});
  EXPECT_EQ(folded.at("flash_bytes").at("textures"), 0);
  EXPECT_LT(folded.at("flash_bytes").at("total"), 16 * 1024);
  const Json shrunk = {{"textures", 1}, {"texels_before", 256 * 256}, {"texels", 0}};
  EXPECT_EQ(folded.at("shrunk"), shrunk);
  const auto is_drawn = [](const Json& record, const char* effect) {
    return record.at("effects").dump().find(std::string("\"") + effect + '"') != std::string::npos;
  };
  EXPECT_TRUE(is_drawn(whole, "textures"));
  EXPECT_FALSE(is_drawn(folded, "textures"));
  EXPECT_LT(mean_difference(picture(model, {}), picture(model, {"--texture-size", "0"})), 2.5) << "the seam, too";
}

/// Each face shows one texel of a texture, or has a material of the same colour.
TEST_F(Reduction, AFlatTextureLosesNothing) {
  std::string bytes(18, '\0');
  bytes[2] = 2;
  bytes[12] = 2;
  bytes[14] = 1;
  bytes[16] = 24;
  bytes += {'\x20', '\x40', '\xE0', '\xE0', '\x40', '\x20'};
  file("two.tga", bytes);
  const std::string shape = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nv 0 0 1\n";
  file("t.mtl", "newmtl a\nKd 1 1 1\nmap_Kd two.tga\n");
  const std::string textured = file("t.obj", "mtllib t.mtl\n" + shape +
                                                 "vt 0.25 0.5\nvt 0.75 0.5\nusemtl a\nf 1/1 2/1 5/1\nf 3/1 4/1 5/1\n"
                                                 "f 2/2 3/2 5/2\nf 4/2 1/2 5/2\n");
  const std::vector<std::string> same{"--orbit", "4,-30,30", "--background", "101820"};
  std::vector<std::string> folded = same;
  folded.insert(folded.end(), {"--texture-size", "0"});
  EXPECT_LT(mean_difference(picture(textured, same), picture(textured, folded)), 2.5) << "the rounding of texels";
  EXPECT_GT(mean_difference(picture(textured, same), picture(textured, {"--orbit", "4,-30,30"})), 5) << "it is seen";
}

TEST_F(Reduction, RemovedTrianglesOpenNoCrackAtSeamsOrBetweenMaterials) {
  texture("colours.tga", 64);
  const std::string model = textured_sphere(48, 24);
  const Json record = report({"bake", model, "-o", "small.zsc", "--triangles", "20%"});
  const Json& reduced = record.at("reduced");
  EXPECT_EQ(reduced.at("triangles_before"), 2208);
  EXPECT_LE(reduced.at("triangles"), 442);
  EXPECT_EQ(record.at("counts").at("triangles"), reduced.at("triangles"));
  EXPECT_GT(reduced.at("error"), 0);
  EXPECT_LT(reduced.at("error"), 0.1) << "the radius is 1";
  EXPECT_GT(reduced.at("error_pixels"), reduced.at("error").get<double>() * 50) << "a radius has over 50 pixels";
  for (const char* angle : {"0", "60", "120", "180", "240", "300"}) {
    const RgbImage image =
        picture(model, {"--triangles", "20%", "--background", "ff00ff", "--orbit", std::string("5,") + angle + ",80"});
    int inside = 0, cracks = 0;
    for (std::uint32_t y = 0; y < image.height; ++y) {
      const auto is_background = [&](std::uint32_t x) {
        const std::uint8_t* pixel = image.pixel(x, y);
        return pixel[0] == 255 && pixel[1] == 0 && pixel[2] == 255;
      };
      std::uint32_t first = 0, last = image.width;
      while (first < last && is_background(first)) ++first;
      while (last > first && is_background(last - 1)) --last;
      for (std::uint32_t x = first; x < last; ++x) ++(is_background(x) ? cracks : inside);
    }
    EXPECT_GT(inside, 5000) << angle;
    EXPECT_EQ(cracks, 0) << angle;
  }
}

TEST_F(Reduction, VertexColoursStayWhereTheyChange) {
  std::string text;
  const int side = 17;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const bool spot = x > 5 && x < 11 && y > 5 && y < 11;
      text += "v " + std::to_string(x) + " " + std::to_string(y) + " 0 " + (spot ? "1 0 0" : "0 0 1") + "\n";
    }
  }
  for (int y = 0; y + 1 < side; ++y) {
    for (int x = 0; x + 1 < side; ++x) {
      const int i = y * side + x + 1;
      const auto n = [](int v) { return " " + std::to_string(v); };
      text += "f" + n(i) + n(i + 1) + n(i + side + 1) + "\nf" + n(i) + n(i + side + 1) + n(i + side) + "\n";
    }
  }
  const std::string model = file("spot.obj", text);
  const Json record = report({"bake", model, "-o", "small.zsc", "--triangles", "60%"});
  EXPECT_LE(record.at("reduced").at("triangles"), 2 * 16 * 16 * 0.6 + 1);
  EXPECT_LT(mean_difference(picture(model, {}), picture(model, {"--triangles", "60%"})), 0.5);
}

TEST_F(Reduction, SizesThatNoModelCanHaveAreUsageErrors) {
  for (const char* size : {"00.5", "100", "4096", "-64", "64x", ""}) {
    const Outcome outcome = zstrip({"bake", kHouseModel, "-o", "house.zsc", std::string("--texture-size=") + size});
    EXPECT_EQ(outcome.status, 2) << size;
  }
  for (const char* count : {"0", "-1", "0%", "101%", "nan%", "1.5", "%", "99999999999999999999"}) {
    const Outcome outcome = zstrip({"bake", kHouseModel, "-o", "house.zsc", std::string("--triangles=") + count});
    EXPECT_EQ(outcome.status, 2) << count;
  }
  const Outcome built_in = zstrip({"plan", "teapot", "--triangles", "50%"});
  EXPECT_EQ(built_in.status, 2);
  EXPECT_NE(built_in.err.find("--triangles is for model files"), std::string::npos) << built_in.err;
  const Outcome more = zstrip({"bake", kHouseModel, "-o", "house.zsc", "--triangles", "1"});
  EXPECT_EQ(more.status, 0);
  EXPECT_NE(more.err.find("are left, more than asked for"), std::string::npos) << more.err;
}

}  // namespace
}  // namespace zstrip::sim::test
