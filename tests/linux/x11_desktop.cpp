// A desktop of X11 without a screen: Xvfb.
#include "x11_desktop.hpp"

#include <X11/Xlib.h>
#include <X11/Xutil.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <thread>
#include <vector>

#include "started_program.hpp"

namespace zstrip::linux_window {

using namespace std::chrono_literals;

struct X11Desktop::Parts {
  // The number of a free display comes on standard output.
  StartedProgram server;
  std::string name = ":" + server.read_line();
  Display* display = XOpenDisplay(name.c_str());
  std::optional<StartedProgram> manager;
  int corner = 0;

  Parts(const std::string& size, const std::string& manager_name)
      : server({"Xvfb", "-displayfd", "1", "-screen", "0", size + "x24", "-nolisten", "tcp"}, {}) {
    if (display == nullptr) throw std::runtime_error("no display " + name);
    // Programs have windows for a moment, too, which are gone when their name is asked for.
    XSetErrorHandler([](Display*, XErrorEvent*) { return 0; });
    if (manager_name.empty()) return;
    manager.emplace(std::vector{manager_name}, std::vector{"DISPLAY=" + name});
    wait_for([this] { return is_managed(); }, manager_name + " does not start");
  }
  ~Parts() {
    XCloseDisplay(display);
    manager.reset();
  }

  static void wait_for(const auto& happened, const std::string& otherwise) {
    for (int tries = 0; tries < 200; ++tries) {
      if (happened()) return;
      std::this_thread::sleep_for(50ms);
    }
    throw std::runtime_error(otherwise);
  }

  bool is_managed() const {
    Atom type = 0;
    int format = 0;
    unsigned long items = 0, rest = 0;
    unsigned char* value = nullptr;
    XGetWindowProperty(display, DefaultRootWindow(display), XInternAtom(display, "_NET_SUPPORTING_WM_CHECK", False), 0,
                       1, False, AnyPropertyType, &type, &format, &items, &rest, &value);
    if (value != nullptr) XFree(value);
    return items > 0;
  }

  bool is_shown(Window window, const std::string& title) const {
    char* text = nullptr;
    if (XFetchName(display, window, &text) == 0) return false;
    XWindowAttributes attributes{};
    const bool is_it =
        title == text && XGetWindowAttributes(display, window, &attributes) != 0 && attributes.map_state == IsViewable;
    XFree(text);
    return is_it;
  }
  /// The parts of `window`, which a manager's frame has, too.
  std::vector<Window> parts_of(Window window) const {
    Window root = 0, parent = 0, *windows = nullptr;
    unsigned count = 0;
    if (XQueryTree(display, window, &root, &parent, &windows, &count) == 0) return {};
    std::vector<Window> found(windows, windows + count);
    if (windows != nullptr) XFree(windows);
    return found;
  }
  /// 0: there is none, or it is not shown.
  Window shown_window(const std::string& title) const {
    std::vector<Window> windows = parts_of(DefaultRootWindow(display));
    for (std::size_t i = 0; i < windows.size(); ++i) {
      if (is_shown(windows[i], title)) return windows[i];
      for (const Window part : parts_of(windows[i])) windows.push_back(part);
    }
    return 0;
  }
  /// Of the window, or the manager's frame around it.
  Window outermost(Window window) const {
    for (;;) {
      Window root = 0, parent = 0, *windows = nullptr;
      unsigned count = 0;
      if (XQueryTree(display, window, &root, &parent, &windows, &count) == 0) return window;
      if (windows != nullptr) XFree(windows);
      if (parent == root) return window;
      window = parent;
    }
  }
  Window window(const std::string& title) const {
    Window found = 0;
    wait_for([&] { return (found = shown_window(title)) != 0; }, "no window '" + title + "'");
    return found;
  }
};

X11Desktop::X11Desktop(const std::string& size, const std::string& manager)
    : parts_(std::make_unique<Parts>(size, manager)) {}
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

X11Desktop::Place X11Desktop::place(const std::string& title) {
  XWindowAttributes frame{};
  XGetWindowAttributes(parts_->display, parts_->outermost(parts_->window(title)), &frame);
  const int border = 2 * frame.border_width;
  return {frame.x, frame.y, frame.x + frame.width + border, frame.y + frame.height + border};
}

void X11Desktop::resize(const std::string& title, int width, int height) {
  XResizeWindow(parts_->display, parts_->window(title), static_cast<unsigned>(width), static_cast<unsigned>(height));
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
