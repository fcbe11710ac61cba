// Tests the start-up code and the memory functions on the board itself. A word from the host selects the test: "memory"
// compares memcpy, memmove, memset and memcmp with bytewise loops and checks .data and .bss; "fault" reads an address
// without memory and "overflow" uses up the stack: both must end in a fault report; "return" and "fpu" continue after a
// fault; "wait" waits for one cycle of the clock; "kernels" prints the names of the contracts of tests/kernels for
// which this processor has code of its own, a line each; "kernel=" and such a name compares assembly with its C++. Exit
// status: 0 passed, 1 a difference, 2 an unknown word.
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>

#include "contracts.hpp"
#include "cortex_m/console.hpp"
#include "cortex_m/registers.hpp"
#include "cortex_m/semihosting.hpp"
#include "cortex_m/systick.hpp"
#include "portable/fault_return.hpp"

namespace {

using zstrip::board::print;
using zstrip::board::print_decimal;
using namespace std::literals;  // words that know their length

constexpr std::size_t kSize = 64;
using Buffer = std::array<unsigned char, kSize>;

volatile std::uint32_t initialised = 0x12345678;
volatile std::uint32_t zeroed;

/// Returns a buffer in which bytes close to each other differ.
Buffer pattern(unsigned seed) {
  Buffer buffer;
  for (std::size_t index = 0; index < kSize; ++index) buffer[index] = static_cast<unsigned char>(seed + 37 * index);
  return buffer;
}

bool equal(const Buffer& a, const Buffer& b) {
  for (std::size_t index = 0; index < kSize; ++index) {
    if (a[index] != b[index]) return false;
  }
  return true;
}

int sign(int value) { return (value > 0) - (value < 0); }

/// Compares all four functions for these offsets and this length with their definition, byte by byte.
bool check(std::size_t to, std::size_t from, std::size_t length) {
  const Buffer before = pattern(1);
  const Buffer source = pattern(2);

  Buffer expected = before, copied = before;
  for (std::size_t index = 0; index < length; ++index) expected[to + index] = source[from + index];
  if (std::memcpy(&copied[to], &source[from], length) != &copied[to] || !equal(copied, expected)) return false;

  Buffer expected_move = before, moved = before;
  for (std::size_t index = 0; index < length; ++index) expected_move[to + index] = before[from + index];
  if (std::memmove(&moved[to], &moved[from], length) != &moved[to] || !equal(moved, expected_move)) return false;

  Buffer expected_set = before, set = before;
  for (std::size_t index = 0; index < length; ++index) expected_set[to + index] = 0xA5;
  if (std::memset(&set[to], 0x7A5, length) != &set[to] || !equal(set, expected_set)) return false;

  Buffer left = pattern(3), right{};
  for (std::size_t index = 0; index < length; ++index) right[from + index] = left[to + index];
  if (std::memcmp(&left[to], &right[from], length) != 0) return false;
  for (std::size_t wrong = 0; wrong < length; ++wrong) {
    const unsigned char original = right[from + wrong];
    right[from + wrong] = static_cast<unsigned char>(original ^ 0x80U);
    const int result = std::memcmp(&left[to], &right[from], length);
    if (sign(result) != (left[to + wrong] < right[from + wrong] ? -1 : 1)) return false;
    right[from + wrong] = original;
  }
  return true;
}

int check_memory() {
  if (initialised != 0x12345678 || zeroed != 0) {
    print("self-test: .data or .bss is not set up\n");
    return 1;
  }
  for (std::size_t to = 0; to < 8; ++to) {
    for (std::size_t from = 0; from < 8; ++from) {
      for (std::size_t length = 0; length <= kSize - 8; ++length) {
        if (check(to, from, length)) continue;
        print("self-test: wrong at offsets ");
        print_decimal(to);
        print(", ");
        print_decimal(from);
        print(", length ");
        print_decimal(length);
        print("\n");
        return 1;
      }
    }
  }
  print("self-test: memory is right\n");
  return 0;
}

[[gnu::noinline]] int read_nowhere() {
  const std::uint32_t value = zstrip::board::register_at(0x3F000000);
  print_decimal(value);
  return 1;
}

int come_back() {
  if (!zstrip::board::mark_fault_return()) return read_nowhere();
  print("self-test: back from ");
  print(zstrip::board::FaultWords::all());
  print("\n");
  return 0;
}

#ifdef __ARM_FP
/// True if an FP instruction changes the memory below the caller's stack frame.
[[gnu::noinline]] bool fp_writes_to_stack() {
  constexpr std::uint32_t kPaint = 0x5AA55AA5;
  volatile std::uint32_t words[96];  // more than the frames of read_nowhere() and of a fault in it
  for (volatile std::uint32_t& word : words) word = kPaint;
  asm volatile("vmov s1, %0" ::"r"(1) : "s1", "memory");
  bool changed = false;
  for (const volatile std::uint32_t& word : words) changed = changed || word != kPaint;
  return changed;
}

int come_back_to_fpu() {
  if (!zstrip::board::mark_fault_return()) {
    asm volatile("vmov s0, %0" ::"r"(1) : "s0", "memory");  // from here on exception frames have room for FPU registers
    return read_nowhere();
  }
  const bool wrong = fp_writes_to_stack();
  print(wrong ? "self-test: FPU registers went to the stack\n" : "self-test: the stack is untouched\n");
  return wrong ? 1 : 0;
}
#else
int come_back_to_fpu() {
  print("self-test: no FPU\n");
  return 0;
}
#endif

/// Waits with a clock so slow that the wait is one of its cycles.
int wait_one_cycle() {
  zstrip::board::SysTickClock(1'000'000).wait(1);
  print("self-test: waited\n");
  return 0;
}

/// Uses 256 bytes of stack a level; `depth` keeps the compiler from proving that it never ends.
std::uint32_t overflow_stack(std::uint32_t depth) {
  volatile std::uint32_t frame[64];
  frame[depth % 64] = depth;
  if (depth == 0xFFFFFFFF) return depth;
  return overflow_stack(depth + 1) + frame[depth % 64];
}

int come_back_and_fault() {
  if (!zstrip::board::mark_fault_return()) return read_nowhere();
  print("self-test: again\n");
  return read_nowhere();
}

int compare_kernel(const zstrip::kernels_test::Contract& contract) {
  const zstrip::kernels_test::Outcome outcome = contract.compare(contract.on_boards);
  print("self-test: ");
  print(contract.name.data());  // the name is a literal, and so is `differs`
  if (!outcome.difference.empty()) {
    print(", case ");
    print_decimal(outcome.number);
    print(": ");
    print(outcome.difference.data());
    print(" differs\n");
    return 1;
  }
  print(": ");
  print_decimal(outcome.compared);
  print(contract.has_own ? " are equal\n" : " by C++ alone\n");
  return !contract.has_own || outcome.compared >= contract.least ? 0 : 1;
}

int print_kernels() {
  for (const zstrip::kernels_test::Contract& contract : zstrip::kernels_test::contracts()) {
    if (!contract.has_own) continue;
    print(contract.name.data());
    print("\n");
  }
  return 0;
}

/// Returns the exit status of main().
int compare_kernel_named(std::string_view name) {
  for (const zstrip::kernels_test::Contract& contract : zstrip::kernels_test::contracts()) {
    if (name == contract.name) return compare_kernel(contract);
  }
  print("self-test: no such kernel\n");
  return 2;
}

}  // namespace

int main() {
  static std::array<char, 64> buffer;
  const std::string_view word = zstrip::board::read_command_line(buffer).value_or(""sv);
  if (word == "memory"sv) return check_memory();
  if (word == "fault"sv) return read_nowhere();
  if (word == "return"sv) return come_back();
  if (word == "twice"sv) return come_back_and_fault();
  if (word == "fpu"sv) return come_back_to_fpu();
  if (word == "wait"sv) return wait_one_cycle();
  if (word == "overflow"sv) return static_cast<int>(overflow_stack(zeroed)) | 1;
  if (word == "kernels"sv) return print_kernels();
  constexpr std::string_view kKernel = "kernel="sv;
  if (word.starts_with(kKernel)) return compare_kernel_named(word.substr(kKernel.size()));
  print("self-test: say memory, fault, return, twice, fpu, wait, overflow, kernels or kernel=NAME\n");
  return 2;
}
