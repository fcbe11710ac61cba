// zstrip-panel on framebuffers and graphics cards of real kernels: what the emulated screen shows, pixel for pixel.
#include <gtest/gtest.h>

#include <string>

#include "guest.hpp"

namespace zstrip::linux_guest {
namespace {

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::string size_text(int width, int height) { return std::to_string(width) + "x" + std::to_string(height); }

/// The last of some frames, held on the screen.
void expect_shown(Guest& guest, const std::string& display, int frames, int width, int height) {
  SCOPED_TRACE(display);
  const Guest::Answer shown =
      guest.run("shows /scene.zsc --turn " + kTurn + " --display " + display + " --frames " + std::to_string(frames));
  EXPECT_TRUE(contains(shown.text, std::to_string(frames) + " frames of " + size_text(width, height))) << shown.text;
  EXPECT_EQ(guest.screen_differs(host_frame(frames - 1, width, height)), "");
}

void expect_text_console(Guest& guest, bool is_text) {
  const std::string list = guest.run("zstrip-panel --list").text;
  EXPECT_TRUE(contains(list, is_text ? "Text console: shown" : "Text console: off")) << list;
}

/// Shown, and after the signal `name` all as before: the console, and the modes.
void expect_shown_and_undone(Guest& guest, const std::string& display, int frames, int width, int height,
                             const std::string& name = "INT", int status = 0) {
  const std::string before = guest.run("zstrip-panel --list").text;
  expect_shown(guest, display, frames, width, height);
  expect_text_console(guest, false);
  EXPECT_EQ(guest.run("ends " + name).status, status) << display;
  expect_text_console(guest, true);
  EXPECT_EQ(guest.run("zstrip-panel --list").text, before) << display;
}

void expect_refused(Guest& guest, const std::string& arguments, int status, const std::string& words) {
  const Guest::Answer answer = guest.run("zstrip-panel /scene.zsc --frames 1 --display " + arguments);
  EXPECT_EQ(answer.status, status) << arguments << "\n" << answer.text;
  EXPECT_TRUE(contains(answer.text, words)) << arguments << "\n" << answer.text;
}

template <Machine machine>
class OnMachine : public testing::Test {
 protected:
  void SetUp() override {
    if (const std::string why = missing(machine); !why.empty()) GTEST_SKIP() << why;
  }
};
using LinuxScreens = OnMachine<Machine::amd64>;
using LinuxScreensArmhf = OnMachine<Machine::armhf>;
using LinuxScreensArm64 = OnMachine<Machine::arm64>;

// cirrus: a card of 16 bits a pixel.
TEST_F(LinuxScreens, Cirrus) {
  Guest guest({.modules = "cirrus", .devices = {"-device", "cirrus-vga"}});
  const std::string list = guest.run("zstrip-panel --list").text;
  EXPECT_TRUE(contains(list, "fbdev:/dev/fb0  1024x768, 16 bits a pixel, driver cirrusdrmfb")) << list;
  EXPECT_TRUE(contains(list, "connector=VGA-1: 1024x768")) << list;

  expect_shown_and_undone(guest, "fbdev:/dev/fb0", 2, 1024, 768);
  expect_shown_and_undone(guest, "drm:/dev/dri/card0,size=640x480", 3, 640, 480, "TERM");
  expect_shown_and_undone(guest, "drm,size=800x600,format=xrgb8888,connector=VGA-1", 2, 800, 600);

  // Signals that nobody catches but for the console: 128 + 6, 128 + 11.
  expect_shown_and_undone(guest, "fbdev:/dev/fb0", 1, 1024, 768, "ABRT", 134);
  expect_shown_and_undone(guest, "fbdev:/dev/fb0", 1, 1024, 768, "SEGV", 139);

  // Two at once.
  expect_shown(guest, "drm,size=640x480", 1, 640, 480);
  expect_refused(guest, "drm", 3, "/dev/dri/card0 cannot show pictures: it is busy; a desktop or another program");
  EXPECT_EQ(guest.run("ends INT").status, 0);

  expect_refused(guest, "drm,size=641x480", 3, "the screen at VGA-1 has no mode of 641x480, only 1024x768, ");
  expect_refused(guest, "drm,connector=DP-1", 3, "/dev/dri/card0 has no connector DP-1, only VGA-1");
  expect_refused(guest, "drm:/dev/dri/card1", 3, "/dev/dri/card1 cannot be opened: there is no such device");
  expect_refused(guest, "drm:/dev/null", 3, "/dev/null sets no modes");
  expect_refused(guest, "fbdev,size=1600x1200", 3,
                 "/dev/fb0 does not take 1600x1200 with 16 bits a pixel; it has 1024x768 with 16 bits a pixel");
  expect_refused(guest, "fbdev:/dev/null", 3, "/dev/null is not a framebuffer");
  guest.run("head -c 100 /scene.zsc >/short.zsc");
  EXPECT_EQ(guest.run("zstrip-panel /short.zsc --display fbdev").status, 4);
}

/// Without permission: what to do about it.
void expect_permission_is_asked_for(Guest& guest) {
  guest.run("chmod 755 /; echo user:x:1000:1000::/:/bin/sh >/etc/passwd");
  const auto as_user = [&guest](const std::string& display) {
    return guest.run("su user -c 'zstrip-panel /scene.zsc --frames 1 --display " + display + "'");
  };
  for (const auto& [display, group] :
       {std::pair("fbdev:/dev/fb0", "join the group 'video'"), {"drm:/dev/dri/card0", "join the group 'video'"}}) {
    const Guest::Answer answer = as_user(display);
    EXPECT_EQ(answer.status, 3) << answer.text;
    EXPECT_TRUE(contains(answer.text, "no permission")) << answer.text;
    EXPECT_TRUE(contains(answer.text, group)) << answer.text;
  }
  // With it, but not for the console: pictures, and a warning.
  guest.run("chmod 666 /dev/fb0");
  const Guest::Answer answer = as_user("fbdev:/dev/fb0");
  EXPECT_EQ(answer.status, 0) << answer.text;
  EXPECT_TRUE(contains(answer.text, "its text may appear on the picture")) << answer.text;
}

// bochs: a card of 32 bits a pixel.
TEST_F(LinuxScreens, BochsWithAndWithoutPermission) {
  Guest guest({.modules = "bochs", .devices = {"-device", "bochs-display"}});
  expect_shown_and_undone(guest, "fbdev", 1, 1280, 800);
  expect_shown_and_undone(guest, "drm,size=640x480", 3, 640, 480);
  expect_permission_is_asked_for(guest);
}

// cirrusfb: a driver of framebuffers as they were before DRM, which sets modes of 16 and 24
// bits; 32 are beyond the clock of this card. LinuxScreens.BochsWithAndWithoutPermission has those.
TEST_F(LinuxScreens, EveryDepthOfAFramebuffer) {
  Guest guest({.modules = "cirrusfb", .devices = {"-device", "cirrus-vga"}});
  const std::string list = guest.run("zstrip-panel --list").text;
  ASSERT_TRUE(contains(list, "driver CL ")) << list;
  expect_refused(
      guest, "fbdev", 3,
      "/dev/fb0 has 8 bits a pixel that are no true colour; another depth may be: depth=16 or depth=24 or depth=32");
  expect_shown_and_undone(guest, "fbdev,depth=16", 1, 640, 480);
  expect_shown_and_undone(guest, "fbdev,depth=24", 1, 640, 480);
  expect_refused(guest, "fbdev,depth=32", 3, "does not take 640x480 with 32 bits a pixel; it has 640x480 with 8 bits");
  expect_shown_and_undone(guest, "fbdev:/dev/fb0,size=800x600,depth=16", 2, 800, 600);
}

Guest::Options virtio_gpu(Machine machine) {
  return {.machine = machine,
          .modules = "virtio_pci,virtio_gpu",
          .devices = {"-device", "virtio-gpu-pci,xres=640,yres=480"}};
}

TEST_F(LinuxScreensArmhf, VirtioGpu) {
  Guest guest(virtio_gpu(Machine::armhf));
  expect_refused(guest, "sdl:", 3, "this zstrip-panel was built without windows; install libsdl2-dev");
  expect_shown_and_undone(guest, "fbdev", 1, 640, 480);
  expect_shown_and_undone(guest, "drm", 2, 640, 480);
}

// Of arm64, where NEON draws; and its kernels with the registers that this operating system saves.
TEST_F(LinuxScreensArm64, VirtioGpuAndKernelsOfNeon) {
  Guest guest(virtio_gpu(Machine::arm64));
  expect_shown_and_undone(guest, "fbdev", 1, 640, 480);
  expect_shown(guest, "drm", 2, 640, 480);
  const Guest::Answer kernels = guest.run("zstrip-kernels");
  EXPECT_EQ(kernels.status, 0) << kernels.text;
  EXPECT_TRUE(contains(kernels.text, " are equal, ")) << kernels.text;
  EXPECT_EQ(guest.run("ends INT").status, 0);
}

// A card with three connectors. The emulator has a screen at the first; the kernel is told that one is at the second.
TEST_F(LinuxScreensArmhf, HeadsOfOneCard) {
  Guest guest({.machine = Machine::armhf,
               .modules = "virtio_pci,virtio_gpu",
               .kernel = "video=Virtual-2:e",
               .devices = {"-device", "virtio-gpu-pci,id=card,max_outputs=3,xres=800,yres=600"}});
  const std::string list = guest.run("zstrip-panel --list").text;
  EXPECT_TRUE(contains(list, "connector=Virtual-1: 800x600, ")) << list;
  EXPECT_TRUE(contains(list, "connector=Virtual-2: ")) << list;
  EXPECT_TRUE(contains(list, "connector=Virtual-3: no screen\n")) << list;
  expect_refused(guest, "drm,connector=HDMI-A-1", 3,
                 "/dev/dri/card0 has no connector HDMI-A-1, only Virtual-1, Virtual-2, Virtual-3 (no screen)");
  expect_refused(guest, "drm,connector=Virtual-3", 3, "/dev/dri/card0: no screen is connected to Virtual-3");
  expect_refused(guest, "drm,connector=all,size=641x480", 3, "the screen at Virtual-1 has no mode of 641x480");

  const auto expect_heads = [&guest, &list](const std::string& keys, int frames, int width, int height, int first,
                                            int last) {
    SCOPED_TRACE(keys);
    const Guest::Answer shown = guest.run("shows /scene.zsc --turn " + kTurn + " --display drm," + keys + " --frames " +
                                          std::to_string(frames));
    EXPECT_TRUE(contains(shown.text, std::to_string(frames) + " frames of " + size_text(width, height))) << shown.text;
    const boards::ColourPicture expected = host_frame(frames - 1, width, height);
    for (int head = first; head <= last; ++head) EXPECT_EQ(guest.head_differs(head, expected), "") << "head " << head;
    EXPECT_EQ(guest.run("ends INT").status, 0);
    expect_text_console(guest, true);
    EXPECT_EQ(guest.run("zstrip-panel --list").text, list);
  };
  expect_heads("connector=Virtual-2,size=1024x768", 2, 1024, 768, 1, 1);
  expect_heads("connector=Virtual-1,size=640x480", 3, 640, 480, 0, 0);
  expect_heads("connector=all,size=640x480", 5, 640, 480, 0, 1);
  expect_heads("connector=all", 4, 800, 600, 0, 1);
}

}  // namespace
}  // namespace zstrip::linux_guest
