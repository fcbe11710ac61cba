// Opens the files of devices, and explains refusals of Linux to the user.
#include "zstrip_hal_linux/device.hpp"

#include <fcntl.h>
#include <sys/ioctl.h>

#include <cerrno>
#include <cstring>

namespace zstrip::hal {
namespace {

/// Returns the group that owns devices of this kind on Debian and Raspberry Pi OS.
const char* group(DeviceKind kind) {
  switch (kind) {
    case DeviceKind::framebuffer:
    case DeviceKind::graphics_card: return "video";
    case DeviceKind::spi: return "spi";
    case DeviceKind::i2c: return "i2c";
    case DeviceKind::gpio: return "gpio";
    case DeviceKind::console: return "tty";
  }
  return "root";
}

const char* missing(DeviceKind kind) {
  switch (kind) {
    case DeviceKind::framebuffer: return "the kernel has no framebuffer there";
    case DeviceKind::graphics_card: return "the kernel has no graphics driver there";
    case DeviceKind::spi: return "enable SPI and spidev for this chip select in the device tree";
    case DeviceKind::i2c: return "enable I2C in the device tree and load the module i2c-dev";
    case DeviceKind::gpio: return "the kernel has no GPIO chip there";
    case DeviceKind::console: return "the kernel has no text console there";
  }
  return "";
}

const char* busy(DeviceKind kind) {
  return kind == DeviceKind::graphics_card ? "a desktop or another program shows pictures on it; end that first"
                                           : "another program or a driver of the kernel uses it; end that first";
}

}  // namespace

Fault device_fault(DeviceKind kind, const std::string& path, std::string_view doing, int error) {
  std::string text = path + " cannot " + std::string(doing) + ": ";
  switch (error) {
    case EACCES:
    case EPERM:
      if (kind == DeviceKind::graphics_card && doing != "be opened") return {text + busy(kind)};
      return {text + "no permission; join the group '" + group(kind) + "' (usermod -aG " + group(kind) +
              " USER, then log in again) or run as root"};
    case ENOENT:
    case ENODEV:
    case ENXIO: return {text + "there is no such device; " + missing(kind)};
    case EBUSY: return {text + "it is busy; " + busy(kind)};
    default: return {text + std::strerror(error)};
  }
}

Outcome<FileDescriptor> open_device(DeviceKind kind, const std::string& path) {
  FileDescriptor file(open(path.c_str(), O_RDWR | O_CLOEXEC | O_NOCTTY));
  if (!file) return device_fault(kind, path, "be opened", errno);
  return file;
}

int device_control(int file, unsigned long request, void* argument) {
  for (;;) {
    if (ioctl(file, request, argument) >= 0) return 0;
    if (errno != EINTR) return errno;
  }
}

}  // namespace zstrip::hal
