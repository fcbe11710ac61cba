// A panel on I2C through the kernel's driver.
#include "zstrip_hal_linux/i2cdev.hpp"

#include <linux/i2c-dev.h>
#include <linux/i2c.h>
#include <sys/ioctl.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>

namespace zstrip::hal {
namespace {

constexpr DeviceKind kKind = DeviceKind::i2c;

std::string in_hex(std::uint8_t address) {
  char text[8];
  std::snprintf(text, sizeof text, "0x%02x", static_cast<unsigned>(address));
  return text;
}

/// Errors with which the kernel's drivers report a missing acknowledge; drivers differ. Some report none of these for
/// a line that is held low.
bool is_refusal(int error) { return error == ENXIO || error == EREMOTEIO || error == EIO || error == ETIMEDOUT; }

/// Makes a system call whose argument is a number.
int control(int file, unsigned long request, unsigned long argument) {
  return ioctl(file, request, argument) < 0 ? errno : 0;
}

}  // namespace

Outcome<I2cdevBus> I2cdevBus::open(const std::string& path, std::uint8_t address) {
  Outcome<FileDescriptor> file = open_device(kKind, path);
  if (!file) return file.fault();
  unsigned long functions = 0;
  if (const int error = device_control(file->get(), I2C_FUNCS, &functions); error != 0)
    return Fault{path + " is not an I2C bus"};
  if ((functions & I2C_FUNC_I2C) == 0)
    return Fault{path + " is a controller for SMBus, which cannot send pictures; use another bus"};
  // Sets the address only to find out whether a kernel driver has claimed it: each transfer carries its own address.
  if (const int error = control(file->get(), I2C_SLAVE, address); error != 0) {
    if (error != EBUSY) return device_fault(kKind, path, "talk to the address " + in_hex(address), error);
    return Fault{path + ": the address " + in_hex(address) +
                 " is busy; a driver of the kernel has the panel: take its node out of the device tree"};
  }
  constexpr unsigned kUnit = 10;  // ms
  if (const int error = control(file->get(), I2C_TIMEOUT, kTimeout / kUnit); error != 0)
    return device_fault(kKind, path, "be given a time-out", error);
  I2cdevBus bus(std::move(*file), address);
  bus.message_ = {std::byte{0}};
  if (const int error = bus.transfer(); is_refusal(error)) {
    return Fault{path + ": no device answers at the address " + in_hex(address) +
                 "; check wires, supply and address (i2cdetect -y lists what answers), and that nothing holds SCL or "
                 "SDA low"};
  } else if (error != 0) {
    return device_fault(kKind, path, "talk to the address " + in_hex(address), error);
  }
  return bus;
}

int I2cdevBus::transfer() {
  i2c_msg message{};
  message.addr = address_;
  message.len = static_cast<std::uint16_t>(message_.size());
  message.buf = reinterpret_cast<std::uint8_t*>(message_.data());
  i2c_rdwr_ioctl_data transfers{&message, 1};
  return device_control(file_.get(), I2C_RDWR, &transfers);
}

Error I2cdevBus::write(std::byte control, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const std::span<const std::byte> part = bytes.first(std::min(bytes.size(), kMessageBytes - 1));
    message_.assign(1, control);
    message_.insert(message_.end(), part.begin(), part.end());
    if (const int error = transfer(); error != 0) return error == ETIMEDOUT ? Error::timeout : Error::bus;
    bytes = bytes.subspan(part.size());
  }
  return Error::none;
}

}  // namespace zstrip::hal
