// Devices that are not there: umockdev passes the system calls for them to functions of the test. The program has to be
// started by umockdev-wrapper.
#pragma once

#include <umockdev.h>

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
  /// /dev/NAME, a character device of `subsystem`.
  void add(const std::string& subsystem, const std::string& name, int major, int minor, Control control);

 private:
  UMockdevTestbed* testbed_;
};

}  // namespace zstrip::linux_mock
