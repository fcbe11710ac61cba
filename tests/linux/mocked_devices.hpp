// Devices that are not there: umockdev passes the system calls for them to functions of the test. The program has to be
// started by umockdev-wrapper.
#pragma once

#include <umockdev.h>

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>

namespace zstrip::linux_mock {

class MockedDevices {
 public:
  MockedDevices();
  ~MockedDevices();
  MockedDevices(const MockedDevices&) = delete;
  MockedDevices& operator=(const MockedDevices&) = delete;

  /// 0 or errno. `argument` is the caller's.
  using Control = std::function<int(unsigned long request, void* argument)>;
  /// /dev/NAME, a character device of `subsystem`. With `memory` it is a file of so many bytes, which can be mapped,
  /// and which polls as readable.
  void add(const std::string& subsystem, const std::string& name, int major, int minor, Control control,
           std::size_t memory = 0);
  /// Where a device's memory is.
  std::filesystem::path file(const std::string& name) const;

 private:
  UMockdevTestbed* testbed_;
};

}  // namespace zstrip::linux_mock
