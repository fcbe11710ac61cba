// Nobody has seen this firmware run: each register and bit that the Picos' and the STM32F4's firmware names, against
// the values of the makers' headers in docs/hardware-review.csv.
#include <gtest/gtest.h>

#include <cctype>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "pico/chip.hpp"
#include "pico2/rp2350.hpp"
#include "stm32/f4_registers.hpp"
#include "stm32/spi.hpp"
#include "stm32/usart.hpp"
#include "stm32/watchdog.hpp"

namespace zstrip::boards {
namespace {

/// A row of docs/hardware-review.csv: what the maker's headers say, and what the firmware's header has.
struct Fact {
  const char* chip;
  const char* name;
  std::uint32_t ours;
  std::uint32_t makers;
};

constexpr Fact kFacts[] = {
#include "hardware_review.inc"
};

std::string contents(const std::filesystem::path& file) {
  std::ifstream stream(std::filesystem::path(ZSTRIP_ROOT) / file);
  EXPECT_TRUE(stream) << file;
  return std::string(std::istreambuf_iterator<char>(stream), {});
}

TEST(BoardReview, ConstantsAreTheMakers) {
  for (const Fact& fact : kFacts) EXPECT_EQ(fact.ours, fact.makers) << fact.chip << ": " << fact.name;
  EXPECT_EQ(board::rp2040::pin_control(19), 0x40014000 + 0x9C) << "IO_BANK0_GPIO19_CTRL_OFFSET";
  EXPECT_EQ(board::rp2350::pin_control(19), 0x40028000 + 0x9C) << "IO_BANK0_GPIO19_CTRL_OFFSET";
  EXPECT_EQ(board::rp2350::pad(19), 0x40038000 + 0x50) << "PADS_BANK0_GPIO19_OFFSET";
  EXPECT_EQ(board::stm32::gpio_f4('A'), 0x40020000U) << "GPIOA_BASE";
  EXPECT_EQ(board::stm32::gpio_f4('E'), 0x40021000U) << "GPIOE_BASE";
  using Usart2 = board::stm32::Usart<0x40004400>;
  EXPECT_EQ(Usart2::kStatus, 0x40004400U) << "USART2->SR";
  EXPECT_EQ(Usart2::kData, 0x40004404U) << "USART2->DR";
  EXPECT_EQ(Usart2::kBaudRate, 0x40004408U) << "USART2->BRR";
  EXPECT_EQ(Usart2::kControl1, 0x4000440CU) << "USART2->CR1";
}

/// Names that begin with k and a capital and are given a value.
std::set<std::string> constants_of(const std::string& header) {
  std::set<std::string> names;
  for (std::size_t end = header.find(" = "); end != std::string::npos; end = header.find(" = ", end + 1)) {
    std::size_t begin = end;
    while (begin > 0 && (std::isalnum(static_cast<unsigned char>(header[begin - 1])) || header[begin - 1] == '_'))
      --begin;
    const std::string name = header.substr(begin, end - begin);
    if (name.size() > 1 && name[0] == 'k' && name[1] >= 'A' && name[1] <= 'Z') names.insert(name);
  }
  return names;
}

// None is forgotten: a new one is looked up, and written into the table.
TEST(BoardReview, EveryConstantOfTheHeadersIsThere) {
  for (const auto& [chip, file] : {std::pair{"RP2040", "firmware/boards/pico/rp2040.hpp"},
                                   {"RP2350", "firmware/boards/pico2/rp2350.hpp"},
                                   {"RP2040 and RP2350", "firmware/boards/pico/chip.hpp"},
                                   {"STM32F4", "firmware/boards/stm32/f4_registers.hpp"}}) {
    std::set<std::string> known;
    for (const Fact& fact : kFacts) {
      if (std::string_view(fact.chip) == chip) known.insert(fact.name);
    }
    EXPECT_EQ(constants_of(contents(file)), known) << file;
  }
}

}  // namespace
}  // namespace zstrip::boards
