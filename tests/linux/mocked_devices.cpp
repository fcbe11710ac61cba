// Devices that are not there.
#include "mocked_devices.hpp"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <utility>

namespace zstrip::linux_mock {
namespace {

gboolean on_control(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer data) {
  const auto& control = *static_cast<MockedDevices::Control*>(data);
  // The caller is in this process: its argument can be used where it lies.
  void* argument = nullptr;
  std::memcpy(&argument, umockdev_ioctl_client_get_arg(client)->data, sizeof argument);
  const int error = control(umockdev_ioctl_client_get_request(client), argument);
  umockdev_ioctl_client_complete(client, error == 0 ? 0 : -1, error);
  return TRUE;
}

}  // namespace

MockedDevices::MockedDevices() : testbed_(umockdev_testbed_new()) {
  if (umockdev_in_mock_environment() == 0) throw std::runtime_error("start this program with umockdev-wrapper");
}

MockedDevices::~MockedDevices() { g_object_unref(testbed_); }

std::filesystem::path MockedDevices::file(const std::string& name) const {
  gchar* root = umockdev_testbed_get_root_dir(testbed_);
  std::filesystem::path path = std::filesystem::path(root) / "dev" / name;
  g_free(root);
  return path;
}

void MockedDevices::add(const std::string& subsystem, const std::string& name, int major, int minor, Control control,
                        std::size_t memory) {
  const std::string number = std::to_string(major) + ":" + std::to_string(minor);
  // The files of a kernel end with a newline, which libgpiod takes off.
  const std::string text = "P: /devices/mock/" + name + "\nN: " + name + (memory != 0 ? "=00" : "") +
                           "\nE: SUBSYSTEM=" + subsystem + "\nE: DEVNAME=/dev/" + name +
                           "\nE: MAJOR=" + std::to_string(major) + "\nE: MINOR=" + std::to_string(minor) +
                           "\nA: dev=" + number + "\\n\n";
  GError* error = nullptr;
  if (umockdev_testbed_add_from_string(testbed_, text.c_str(), &error) == 0) throw std::runtime_error(error->message);
  if (memory != 0) std::filesystem::resize_file(file(name), memory);
  // Where libgpiod looks; umockdev makes links only for classes.
  gchar* root = umockdev_testbed_get_root_dir(testbed_);
  const std::filesystem::path bus = std::filesystem::path(root) / "sys/bus" / subsystem / "devices";
  g_free(root);
  std::filesystem::create_directories(bus);
  std::error_code exists;
  std::filesystem::create_symlink("../../../devices/mock/" + name, bus / name, exists);

  UMockdevIoctlBase* handler = umockdev_ioctl_base_new();
  g_signal_connect_data(
      handler, "handle-ioctl", G_CALLBACK(on_control), new Control(std::move(control)),
      [](gpointer data, GClosure*) { delete static_cast<Control*>(data); }, GConnectFlags{});
  const std::string path = "/dev/" + name;
  const bool attached = umockdev_testbed_attach_ioctl(testbed_, path.c_str(), handler, &error) != 0;
  g_object_unref(handler);
  if (!attached) throw std::runtime_error(error->message);
}

}  // namespace zstrip::linux_mock
