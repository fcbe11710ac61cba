// In place of firmware/boards/cortex_m/registers.hpp: what the Pico 2's program reads and writes goes to a model of its
// chip (chip_model.hpp).
#pragma once

#include <cstdint>

// Instructions of Arm in the program's sources: nothing here.
asm(".ifndef zstrip_arm_instructions\n"
    ".set zstrip_arm_instructions, 1\n"
    ".macro dsb\n.endm\n"
    ".macro wfi\n.endm\n"
    ".endif");

namespace zstrip::pico2 {

std::uint32_t read_register(std::uint32_t address);
void write_register(std::uint32_t address, std::uint32_t value);

}  // namespace zstrip::pico2

namespace zstrip::board {

class Register {
 public:
  explicit Register(std::uint32_t address) : address_(address) {}
  // As the variable that it is on the board.
  operator std::uint32_t() const { return pico2::read_register(address_); }
  void operator=(std::uint32_t value) { pico2::write_register(address_, value); }

 private:
  std::uint32_t address_;
};

inline Register register_at(std::uint32_t address) { return Register(address); }

}  // namespace zstrip::board
