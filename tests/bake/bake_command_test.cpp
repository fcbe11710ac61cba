// `zstrip bake` as its users see it: files, reports, refusals.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <span>
#include <sstream>

#include "bake_fixture.hpp"
#include "blob_sample.hpp"
#include "zstrip/blob.hpp"

namespace zstrip::sim::test {
namespace {

TEST_F(Bake, BytesByKindAreThoseOfTheFile) {
  const Json baked = report({"bake", kHouseModel, "-o", "house.zsc"});
  const Json& flash = baked.at("flash_bytes");
  std::uint64_t sum = 0;
  for (const auto& [kind, bytes] : flash.items()) {
    if (kind != "total") sum += bytes.get<std::uint64_t>();
  }
  EXPECT_EQ(flash.at("total"), sum);
  EXPECT_EQ(flash.at("total"), std::filesystem::file_size(path("house.zsc")));
  EXPECT_EQ(flash.at("triangles"), 6 * baked.at("counts").at("triangles").get<int>());
  EXPECT_EQ(flash.at("positions"), 6 * baked.at("counts").at("vertices").get<int>());
  EXPECT_EQ(flash.at("textures"), 0);
  // With 32-bit addresses a Mesh has 80 bytes, one for each of the three materials.
  EXPECT_EQ(baked.at("plan").at("ram_bytes").at("lent_tables"), 3 * 80);
}

/// The reported error, found once more from the file's text and the blob.
TEST_F(Bake, AccuracyIsWhatTheBlobShows) {
  const std::string obj = sphere_obj(24, 13);
  const Json accuracy = report({"bake", file("sphere.obj", obj), "-o", "sphere.zsc"}).at("accuracy");

  struct Point {
    double x, y, z;
  };
  std::vector<Point> vertices;
  std::istringstream lines(obj);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string kind;
    Point p{};
    if (words >> kind >> p.x >> p.y >> p.z && kind == "v") vertices.push_back(p);
  }
  const auto extremes = [&](double Point::*axis) {
    const auto [low, high] = std::minmax_element(vertices.begin(), vertices.end(),
                                                 [axis](const Point& a, const Point& b) { return a.*axis < b.*axis; });
    return std::pair{(*low).*axis, (*high).*axis};
  };
  double size = 0;
  Point centre{};
  for (double Point::*axis : {&Point::x, &Point::y, &Point::z}) {
    const auto [low, high] = extremes(axis);
    size = std::max(size, high - low);
    centre.*axis = (low + high) / 2;
  }
  EXPECT_NEAR(accuracy.at("size").get<double>(), size, 1e-5);

  const std::string bytes = read(path("sphere.zsc"));
  std::vector<std::uint64_t> blob(bytes.size() / 8 + 1), memory(scene_blob_memory(4, 4) / 8 + 1);
  std::copy(bytes.begin(), bytes.end(), reinterpret_cast<char*>(blob.data()));
  SceneBlob opened;
  ASSERT_TRUE(open_scene_blob(std::as_bytes(std::span(blob)).first(bytes.size()),
                              std::as_writable_bytes(std::span(memory)), opened));
  double worst = 0;
  for (const Mesh& mesh : opened.scene.meshes) {
    for (const Position& p : mesh.positions) {
      const auto real = [size](double middle, std::int16_t steps, Fixed half) {
        return middle + steps / 32768.0 * half / 65536.0 * size / 2;
      };
      const Point at{real(centre.x, p.x, mesh.half_extent.x), real(centre.y, p.y, mesh.half_extent.y),
                     real(centre.z, p.z, mesh.half_extent.z)};
      double nearest = size;
      for (const Point& v : vertices) nearest = std::min(nearest, std::hypot(at.x - v.x, at.y - v.y, at.z - v.z));
      worst = std::max(worst, nearest);
    }
  }
  EXPECT_GT(worst, 0);
  EXPECT_LT(worst, size / 32768);
  EXPECT_NEAR(accuracy.at("position").get<double>(), worst, worst * 0.02);
  // Half a step of 1/127 in each of three axes, seen from the origin.
  EXPECT_GT(accuracy.at("normal_degrees"), 0.1);
  EXPECT_LT(accuracy.at("normal_degrees"), 0.4);
}

TEST_F(Bake, EffectsAndWhy) {
  const auto effects = [this](const std::string& scene, const std::vector<std::string>& options) {
    std::vector<std::string> arguments{"bake", scene, "-o", "scene.hpp"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    std::string text;
    const Json baked = report(arguments);
    for (const Json& found : baked.at("effects")) {
      text += found.at("name").get<std::string>() + found.at("materials").dump() + '\n';
    }
    return text;
  };
  EXPECT_EQ(effects(kHouseModel, {}), "lighting[\"walls\",\"roof\",\"wood\"]\ngouraud[\"walls\",\"roof\",\"wood\"]\n");
  EXPECT_EQ(effects("triangle", {"--mode", "binned", "--strip-rows", "16"}),
            "gouraud[\"number 0\"]\nvertex_colours[\"number 0\"]\nbins[]\n");
  EXPECT_NE(effects(kColoursModel, {"--ortho"}).find("vertex_colours"), std::string::npos);
  EXPECT_NE(effects(kColoursModel, {"--ortho"}).find("orthographic[]"), std::string::npos);
  EXPECT_NE(effects("room", {}).find("textures[\"number 0\",\"number 1\"]"), std::string::npos);
}

TEST_F(Bake, SetsOfLinesAreCountedAmongTheTablesToLend) {
  const Json baked = report({"bake", ZSTRIP_SCENE_FILES "/lines.toml", "-o", "scene.zsc"});
  const std::string bytes = read(path("scene.zsc"));
  std::vector<std::uint64_t> blob(bytes.size() / 8 + 1), memory(10000);
  std::memcpy(blob.data(), bytes.data(), bytes.size());
  SceneBlob opened;
  ASSERT_TRUE(open_scene_blob(std::as_bytes(std::span(blob)).first(bytes.size()),
                              std::as_writable_bytes(std::span(memory)), opened));
  const Scene& scene = opened.scene;
  ASSERT_GT(scene.lines.size(), 3U);
  EXPECT_EQ(baked.at("plan").at("ram_bytes").at("lent_tables"),
            80 * scene.meshes.size() + 12 * scene.textures.size() + 64 * scene.lines.size());
}

TEST_F(Bake, MeshesThatNothingLightsHaveNoNormals) {
  const auto normals = [this](const std::string& keys) {
    file("scene.toml", "[[model]]\nname = 'pot'\nbuilt_in = 'teapot'\n[[material]]\nname = 'own'\n" + keys +
                           "[[instance]]\nmodel = 'pot'\nmaterial = 'own'\n");
    return report({"bake", "scene.toml", "-o", "scene.zsc"}).at("flash_bytes").at("normals").get<std::size_t>();
  };
  EXPECT_GT(normals("lit = true\n"), 0U);
  EXPECT_EQ(normals("lit = false\n"), 0U);
  EXPECT_GT(normals("lit = false\n[[light]]\ndirection = [0, -1, 0]\n[[instance]]\nmodel = 'pot'\n"), 0U)
      << "a lit instance of the same mesh reads them";
  EXPECT_GT(normals("lit = false\nenvironment = '" ZSTRIP_SCENE_FILES "/gallery/watch/studio.png'\n"), 0U);
}

TEST_F(Bake, SummaryInWords) {
  const Outcome outcome = zstrip({"bake", kHouseModel, "-o", "house.hpp", "--size", "128x64", "--ram", "14K"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  for (const char* part : {"flash", "positions: at most", "of the model's size", "normals: at most", "degrees off",
                           "lighting: lit, with normals: material 'walls' and 2 more", "RAM", "written    house.hpp"}) {
    EXPECT_NE(outcome.out.find(part), std::string::npos) << part << '\n' << outcome.out;
  }
}

TEST_F(Bake, SameSceneSameBytes) {
  for (const char* ending : {".zsc", ".hpp", ".ino", ".cpp"}) {
    const std::string name = "scene" + std::string(ending);  // a program's text names its own file
    for (const char* folder : {"a", "b"}) {
      std::filesystem::create_directory(path(folder));
      report({"bake", kHouseModel, "-o", folder + ("/" + name), "--size", "240x240"});
    }
    EXPECT_EQ(read(path("a/" + name)), read(path("b/" + name))) << ending;
  }
}

/// What of the options the text of a program says; the rest are constants of its header.
TEST_F(Bake, ProgramsHaveThePanelTheNamespaceAndTheSkin) {
  const auto text = [this](const std::string& scene, const std::string& name, std::vector<std::string> options) {
    options.insert(options.begin(), {"bake", scene, "-o", name, "--quiet"});
    const Outcome outcome = zstrip(options);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    return read(path(name));
  };
  const auto has = [](const std::string& whole, const std::string& part) {
    EXPECT_NE(whole.find(part), std::string::npos) << part << "\n" << whole;
  };
  has(text(kHouseModel, "a.ino", {"--size", "240x240"}), "kPanel{.width = 240, .height = 240, .inverted = true};");
  const std::string sideways =
      text(kHouseModel, "b.ino", {"--size", "320x170", "--format", "rgb444", "--namespace", "house"});
  has(sideways, "kPanel{.width = 170, .height = 320, .column_offset = 35,\n");
  has(sideways, "    .orientation = {.rotation = zstrip::hal::Rotation::by_90},\n");
  has(sideways, "    .format = zstrip::hal::DisplayFormat::rgb444, .inverted = true};");
  has(sideways, "player.open({house::kScene, house::kCamera");
  EXPECT_EQ(sideways.find("baked::"), std::string::npos);
  // Not wider than the controller's memory, but a module's glass on its side.
  const std::string narrow = text(kHouseModel, "e.ino", {"--size", "240x135"});
  has(narrow, "kPanel{.width = 135, .height = 240, .column_offset = 52, .row_offset = 40,\n");
  has(narrow, "    .orientation = {.rotation = zstrip::hal::Rotation::by_90},");
  const std::string figure = ZSTRIP_SCENE_FILES "/figure/figure.gltf";
  for (const char* name : {"c.ino", "c.cpp"})
    has(text(figure, name, {"--size", "240x240"}), "baked::pose_skins(player.time())");
  // What is between @ in a file's name is no namespace.
  has(text(file("a@b.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"), "d.cpp", {}),
      "// a@b.obj in 320x240 pixels, rgb565.");
}

/// Files that their owner has changed stay; the scene is written anew.
TEST_F(Bake, AFolderIsAWholeProgramAndKeepsWhatWasChanged) {
  const auto bake_into = [this](const std::string& folder, std::vector<std::string> options) {
    options.insert(options.begin(), {"bake", kHouseModel, "-o", folder, "--quiet"});
    const Outcome outcome = zstrip(options);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return outcome.err;
  };
  const auto has = [this](const std::string& name, const std::string& part) {
    const std::string whole = read(path(name));
    EXPECT_NE(whole.find(part), std::string::npos) << part << "\n" << name << "\n" << whole;
  };
  EXPECT_EQ(bake_into("own/", {}), "");
  has("own/own.ino", "kPanel{.width = 240, .height = 240, .inverted = true};");
  has("own/scene.hpp", "The camera is placed for 240x240 pixels, rgb565_swapped.");
  has("own/scene.hpp", "effect::unclipped");  // as with --turntable
  EXPECT_EQ(bake_into("tft/", {"--display", "tft_espi", "--project", "platformio", "--size", "480x320"}), "");
  has("tft/tft.ino", "tft.setRotation(1);");
  has("tft/tft_espi.hpp", "class TftEspi");
  has("tft/platformio.ini", "TFT_WIDTH=320");
  EXPECT_EQ(bake_into("gfx/", {"--display", "arduino_gfx", "--size", "240x135"}), "");
  has("gfx/gfx.ino", "Arduino_ST7789 gfx(&bus, kReset, 1, true, 135, 240, 52, 40, 53, 40);");
  EXPECT_EQ(bake_into("lgfx/", {"--display", "lovyangfx", "--size", "240x135"}), "");
  has("lgfx/lgfx.ino", "glass.offset_x = 52;\n    glass.offset_y = 40;\n");
  EXPECT_EQ(bake_into("m5/", {"--display", "m5gfx", "--project", "platformio", "--size", "320x240"}), "");
  has("m5/m5.ino", "device.setRotation(1);");
  has("m5/lovyangfx.hpp", "class LovyanGfx");
  has("m5/platformio.ini", "default_envs = esp32\n");
  EXPECT_EQ(bake_into("nested/pico/", {"--project", "pico"}), "");
  has("nested/pico/CMakeLists.txt", "target_link_libraries(pico PRIVATE zstrip::player pico_stdlib");
  has("nested/pico/main.cpp", "player.open({baked::kScene");
  has("nested/pico/pico_spi_dma.hpp", "class PicoSpiDma");

  EXPECT_EQ(bake_into("both/", {"--project", "pico", "--cores", "2"}), "");
  has("both/CMakeLists.txt", "target_link_libraries(both PRIVATE zstrip::player pico_multicore pico_stdlib");
  has("both/main.cpp", "multicore_launch_core1([] {");
  EXPECT_EQ(bake_into("esp/", {"--project", "esp_idf", "--size", "240x135"}), "");
  has("esp/CMakeLists.txt", "project(esp)");
  has("esp/main/main.cpp", "esp_lcd_panel_mirror(glass, true, false);\n  esp_lcd_panel_set_gap(glass, 40, 53);\n");
  has("esp/main/esp_lcd.hpp", "class EspLcd");
  EXPECT_EQ(bake_into("rgb/", {"--project", "esp_idf", "--display", "rgb_panel", "--size", "800x480"}), "");
  has("rgb/scene.hpp", ".strip_rows = 10,");
  has("rgb/main/main.cpp", "adapters::EspLcdRgb panel(");
  has("rgb/main/glass.hpp", "constexpr unsigned kHsyncPulse");
  has("rgb/main/esp_lcd_rgb.hpp", "class EspLcdRgb");
  has("rgb/CMakeLists.txt", "idf.py set-target esp32s3");
  EXPECT_EQ(bake_into("dsi/", {"--project", "esp_idf", "--display", "mipi_dsi_panel"}), "");
  has("dsi/scene.hpp", "1024, 600, zstrip::PixelFormat::rgb565}");
  has("dsi/main/esp_lcd_dsi.hpp", "class EspLcdDsi");
  has("dsi/main/idf_component.yml", "espressif/esp_lcd_ek79007");
  has("dsi/sdkconfig.defaults", "CONFIG_SPIRAM=y");

  const std::string sketch = read(path("own/own.ino")), scene = read(path("own/scene.hpp"));
  file("own/own.ino", "// pins of mine");
  file("own/scene.hpp", "// of another model");
  EXPECT_NE(bake_into("own", {}).find("'own/own.ino' stays as it is"), std::string::npos);
  EXPECT_EQ(read(path("own/own.ino")), "// pins of mine");
  EXPECT_EQ(read(path("own/scene.hpp")), scene);
  std::filesystem::remove(path("own/own.ino"));
  EXPECT_EQ(bake_into("own", {}), "");
  EXPECT_EQ(read(path("own/own.ino")), sketch);
}

TEST_F(Bake, Refusals) {
  const auto expect = [this](const std::vector<std::string>& arguments, int status, const char* words) {
    const Outcome outcome = zstrip(arguments);
    EXPECT_EQ(outcome.status, status) << words << outcome.err;
    EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_EQ(outcome.out, "");
  };
  expect({"bake", kHouseModel}, 2, "--output");
  expect({"bake", kHouseModel, "-o", "house.txt"}, 2, ".hpp");
  expect({"bake", kHouseModel, "-o", "house.hpp", "--namespace", "My-House"}, 2, "--namespace");
  expect({"bake", kHouseModel, "-o", "house.hpp", "--namespace", "zstrip"}, 2, "--namespace");
  expect({"bake", kHouseModel, "-o", "house.hpp", "--namespace", "a__b"}, 2, "--namespace");
  expect({"bake", kHouseModel, "-o", "house.hpp", "--namespace", "class"}, 2, "no word of C++");
  expect({"bake", "teapot", "-o", "house.hpp", "--up", "z"}, 2, "--up");
  expect({"bake", kHouseModel, "-o", "house.ino", "--size", "241x321"}, 2, "ST7789");
  expect({"bake", kHouseModel, "-o", "house.ino", "--size", "128x64", "--format", "mono"}, 2, "rgb565_swapped");
  expect({"bake", kHouseModel, "-o", "house.ino", "--size", "135x240", "--format", "rgb444"}, 2, "even width");
  expect({"bake", kHouseModel, "-o", "house.ino", "--namespace", "panel"}, 2, "--namespace panel");
  expect({"bake", kHouseModel, "-o", "a folder/"}, 2, "the folder's name is that of the program");
  expect({"bake", kHouseModel, "-o", "house.ino", "--display", "tft_espi"}, 2, "-o FOLDER/");
  expect({"bake", kHouseModel, "-o", "house", "--project", "pico"}, 2, "in / (a folder");
  expect({"bake", kHouseModel, "-o", "house/", "--display", "u8g2"}, 2, "--display");
  expect({"bake", kHouseModel, "-o", "house/", "--project", "pico", "--display", "lovyangfx"}, 2, "has st7789");
  expect({"bake", kHouseModel, "-o", "house/", "--display", "tft_espi", "--format", "rgb666"}, 2, "rgb565_swapped");
  expect({"bake", kHouseModel, "-o", "house/", "--project", "pico", "--size", "480x320"}, 2, "ST7789");
  expect({"bake", kHouseModel, "-o", "house/", "--project", "pico", "--namespace", "bus"}, 2, "--namespace bus");
  expect({"bake", kHouseModel, "-o", "house/", "--cores", "2"}, 2, "--cores 2 is of --project pico");
  expect({"bake", kHouseModel, "-o", "house.hpp", "--cores", "2"}, 2, "-o FOLDER/");
  expect({"bake", kHouseModel, "-o", "house/", "--project", "esp_idf", "--format", "rgb666"}, 2, "esp_lcd takes");
  expect({"bake", kHouseModel, "-o", "house/", "--display", "rgb_panel"}, 2, "--project esp_idf --display rgb_panel");
  const auto expect_rgb = [&](const char* option, const char* value, const char* words) {
    expect({"bake", kHouseModel, "-o", "house/", "--project", "esp_idf", "--display", "rgb_panel", option, value}, 2,
           words);
  };
  expect_rgb("--size", "480x271", "choose an even height");
  expect_rgb("--strip-rows", "20", "choose a divisor of 136, such as 17");
  expect_rgb("--strip-columns", "64", "take whole rows");
  expect_rgb("--format", "rgb565_swapped", "take rgb565");
  expect_rgb("--namespace", "glass", "--namespace glass");
  expect({"bake", kHouseModel, "-o", "house/", "--json", "house/scene.hpp"}, 2, "--json");
  expect({"bake", kHouseModel, "-o", "main.cpp", "--namespace", "player"}, 2, "--namespace player");
  expect({"bake", kHouseModel, "-o", "house.ino", "--visibility", "painter"}, 2, "no --visibility painter");
  expect({"bake", kHouseModel, "-o", "main.cpp", "--visibility", "painter"}, 2, "no --visibility painter");
  expect({"bake", kHouseModel, "-o", "house.zsc", "--visibility", "painter"}, 2, "a blob keeps only painter-newell");
  expect({"bake", kHouseModel, "-o", "house.uf2", "--visibility", "painter-bsp"}, 2, "draws with a z-buffer");
  expect({"bake", kHouseModel, "-o", "house.hpp", "--size", "0x0"}, 2, "--size");
  expect({"bake", "room", "-o", "room.hpp", "--textures", "palette"}, 2, "--textures");
  expect({"bake", "none.obj", "-o", "house.hpp"}, 4, "none.obj");
  expect({"bake", kHouseModel, "-o", "house.hpp", "--ram", "100"}, 5, "bytes");
  expect({"bake", kHouseModel, "-o", "nowhere/house.hpp"}, 6, "nowhere");
  expect({"bake", kHouseModel, "-o", "house.hpp", "--json", "house.hpp"}, 2, "--json");
  EXPECT_EQ(files(), std::vector<std::string>()) << "nothing is left behind";
}

/// Was a header whose frames were Error::store_full.
TEST_F(Bake, AShadowsPoolThatIsTooSmallIsRefused) {
  const auto scene = [this](const char* name, int pool) {
    std::string text = read(ZSTRIP_SCENE_FILES "/shadows.toml");
    const std::string before = "pool = 24000";
    EXPECT_NE(text.find(before), std::string::npos);
    text.replace(text.find(before), before.size(), "pool = " + std::to_string(pool));
    text.replace(text.find("models/"), 0, ZSTRIP_SCENE_FILES "/");
    return file(name, text);
  };
  for (const char* output : {"scene.hpp", "scene.zsc"}) {
    const Outcome small = zstrip({"bake", scene("small.toml", 2000), "-o", output});
    EXPECT_EQ(small.status, 5);
    EXPECT_NE(small.err.find("does not fit into its pool of 2,000 bytes"), std::string::npos) << small.err;
    EXPECT_FALSE(std::filesystem::exists(path(output)));
    EXPECT_EQ(zstrip({"bake", scene("enough.toml", 24000), "-o", output}).status, 0);
  }
}

TEST_F(Bake, DamagedBlobsAreInputErrors) {
  report({"bake", kHouseModel, "-o", "house.zsc"});
  const std::string whole = read(path("house.zsc"));
  const auto expect = [this](const std::string& content, const char* words) {
    const std::string blob = file("damaged.zsc", content);
    for (const char* command : {"render", "plan"}) {
      const Outcome outcome = zstrip({command, blob});
      EXPECT_EQ(outcome.status, 4) << outcome.err;
      EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
    }
  };
  expect("", "byte 0");
  expect(whole.substr(0, whole.size() / 2), "is not a complete baked scene");
  expect(whole + "more", "is not a complete baked scene (byte 4)");
  std::string flipped = whole;
  flipped[whole.size() / 2] = static_cast<char>(flipped[whole.size() / 2] ^ 1);
  expect(flipped, "is not a complete baked scene (byte 8)");
  std::string other = whole;
  for (const int version : {3, 4, 7}) {
    other[2] = static_cast<char>(version);
    expect(other, (std::to_string(version) + ", and this zstrip reads version 6; bake it again").c_str());
    expect(other, "zstrip bake MODEL -o FILE.zsc");
  }
  std::vector<Piece> pieces = pieces_of({whole.begin(), whole.end()});
  pieces.insert(pieces.begin(), {"AbCd", {1}});
  const Bytes newer = blob_of(pieces);
  expect({newer.begin(), newer.end()}, "a section 'AbCd' that this zstrip does not know; take a newer zstrip");
  EXPECT_EQ(zstrip({"render", "none.zsc"}).status, 4);
}

}  // namespace
}  // namespace zstrip::sim::test
