// A desktop of X11 without a screen: Xvfb. There is no window manager.
#include "x11_desktop.hpp"

#include <X11/Xlib.h>
#include <X11/Xutil.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <stdexcept>
#include <thread>

#include "started_program.hpp"

namespace zstrip::linux_window {

using namespace std::chrono_literals;

struct X11Desktop::Parts {
  // The number of a free display comes on standard output.
  StartedProgram server{{"Xvfb", "-displayfd", "1", "-screen", "0", "800x600x24", "-nolisten", "tcp"}, {}};
  std::string name = ":" + server.read_line();
  Display* display = XOpenDisplay(name.c_str());
  int corner = 0;

  Parts() {
    if (display == nullptr) throw std::runtime_error("no display " + name);
    // Programs have windows for a moment, too, which are gone when their name is asked for.
    XSetErrorHandler([](Display*, XErrorEvent*) { return 0; });
  }
  ~Parts() { XCloseDisplay(display); }

  /// 0: there is none, or it is not shown.
  Window shown_window(const std::string& title) const {
    Window root = 0, parent = 0, *windows = nullptr, found = 0;
    unsigned count = 0;
    XQueryTree(display, DefaultRootWindow(display), &root, &parent, &windows, &count);
    for (unsigned i = 0; i < count; ++i) {
      char* text = nullptr;
      XWindowAttributes attributes{};
      if (XFetchName(display, windows[i], &text) == 0) continue;
      if (title == text && XGetWindowAttributes(display, windows[i], &attributes) != 0 &&
          attributes.map_state == IsViewable)
        found = windows[i];
      XFree(text);
    }
    if (windows != nullptr) XFree(windows);
    return found;
  }
  Window window(const std::string& title) const {
    for (int tries = 0; tries < 200; ++tries) {
      if (const Window found = shown_window(title); found != 0) return found;
      std::this_thread::sleep_for(50ms);
    }
    throw std::runtime_error("no window '" + title + "'");
  }
};

X11Desktop::X11Desktop() : parts_(std::make_unique<Parts>()) {}
X11Desktop::~X11Desktop() = default;

std::string X11Desktop::variable() const { return "DISPLAY=" + parts_->name; }

boards::ColourPicture X11Desktop::seen(const std::string& title) {
  const Window root = DefaultRootWindow(parts_->display), window = title.empty() ? root : parts_->window(title);
  XWindowAttributes attributes{};
  XGetWindowAttributes(parts_->display, window, &attributes);
  // Somewhere else each time, so that it moves for a desktop that has just begun to watch it.
  parts_->corner = 1 - parts_->corner;
  XWarpPointer(parts_->display, 0, root, 0, 0, 0, 0, parts_->corner, 0);
  const int width = attributes.width, height = attributes.height;
  XImage* const image = XGetImage(parts_->display, window, 0, 0, static_cast<unsigned>(width),
                                  static_cast<unsigned>(height), AllPlanes, ZPixmap);
  if (image == nullptr) throw std::runtime_error("the window cannot be read");
  boards::ColourPicture picture{width, height, {}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const unsigned long pixel = XGetPixel(image, x, y);
      picture.pixels.push_back({static_cast<std::uint8_t>(pixel >> 16), static_cast<std::uint8_t>(pixel >> 8),
                                static_cast<std::uint8_t>(pixel)});
    }
  }
  XDestroyImage(image);
  return picture;
}

void X11Desktop::cover_and_uncover(const std::string& title) {
  XWindowAttributes below{};
  XGetWindowAttributes(parts_->display, parts_->window(title), &below);
  XSetWindowAttributes attributes{};
  attributes.override_redirect = True;
  attributes.background_pixel = 0xFF00FF;
  const Window cover =
      XCreateWindow(parts_->display, DefaultRootWindow(parts_->display), below.x, below.y,
                    static_cast<unsigned>(below.width), static_cast<unsigned>(below.height), 0, CopyFromParent,
                    InputOutput, nullptr, CWOverrideRedirect | CWBackPixel, &attributes);
  XMapRaised(parts_->display, cover);
  XSync(parts_->display, False);
  XDestroyWindow(parts_->display, cover);
  XSync(parts_->display, False);
}

void X11Desktop::close(const std::string& title) {
  const Window window = parts_->window(title);
  XEvent event{};
  event.xclient.type = ClientMessage;
  event.xclient.window = window;
  event.xclient.message_type = XInternAtom(parts_->display, "WM_PROTOCOLS", False);
  event.xclient.format = 32;
  event.xclient.data.l[0] = static_cast<long>(XInternAtom(parts_->display, "WM_DELETE_WINDOW", False));
  event.xclient.data.l[1] = CurrentTime;
  XSendEvent(parts_->display, window, False, NoEventMask, &event);
  XSync(parts_->display, False);
}

}  // namespace zstrip::linux_window
