// Sets up bochs-display. Sources: QEMU docs/specs/standard-vga (the registers), PCI Local Bus Specification 3.0,
// section 6 (the header of a device).
#include "riscv_virt/bochs_display.hpp"

#include "cortex_m/registers.hpp"

namespace zstrip::board {
namespace {

// Configuration space: 4 KB for each of 8 functions of 32 devices.
constexpr std::uint32_t kConfiguration = 0x30000000;
constexpr std::uint32_t kDevices = 32, kDeviceBytes = 1U << 15;
constexpr std::uint32_t kIdentity = 0x00, kCommand = 0x04, kBar0 = 0x10, kBar2 = 0x18;
constexpr std::uint32_t kBochsDisplay = 0x11111234;
constexpr std::uint32_t kMemorySpace = 1U << 1;
constexpr std::uint32_t kRegisters = 0x41000000;  // of the device, after its pixels

// Numbers of registers of 16 bits.
enum class Dispi : std::uint32_t { width = 1, height = 2, bits = 3, enable = 4, virtual_width = 6, y_offset = 9 };
constexpr std::uint16_t kEnabled = 1U << 0, kLinear = 1U << 6;

void set(Dispi number, std::uint16_t value) {
  constexpr std::uint32_t kDispi = kRegisters + 0x500;
  *reinterpret_cast<volatile std::uint16_t*>(kDispi + 2 * static_cast<std::uint32_t>(number)) = value;
}

bool find_and_map() {
  for (std::uint32_t device = 0; device < kDevices; ++device) {
    const std::uint32_t header = kConfiguration + device * kDeviceBytes;
    if (register_at(header + kIdentity) != kBochsDisplay) continue;
    register_at(header + kBar0) = kBochsPixels;
    register_at(header + kBar2) = kRegisters;
    register_at(header + kCommand) = kMemorySpace;
    return true;
  }
  return false;
}

}  // namespace

bool start_bochs_display(std::uint16_t width, std::uint16_t height, std::uint16_t bits) {
  if (!find_and_map()) return false;
  set(Dispi::enable, 0);
  set(Dispi::width, width);
  set(Dispi::height, height);
  set(Dispi::bits, bits);
  set(Dispi::virtual_width, width);
  set(Dispi::y_offset, 0);
  set(Dispi::enable, kEnabled | kLinear);
  return true;
}

}  // namespace zstrip::board
