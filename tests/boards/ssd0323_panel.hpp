// A model of the SSD0323 with its panel of 128x64, after the data sheet: takes what comes over the bus and says what
// would be seen. Unlike the emulator's it minds the set-up: a panel that was not switched on and configured is dark.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "grey_picture.hpp"
#include "zstrip_hal/bus.hpp"

namespace zstrip::boards {

class Ssd0323Panel {
 public:
  // The bus; the panel takes everything at once.
  hal::Error write_command(std::span<const std::byte> bytes);
  hal::Error write_data(std::span<const std::byte> bytes);
  hal::Error wait() { return hal::Error::none; }

  /// What the eye sees, if the controller is set up for a panel of 128x64 and on.
  std::optional<GreyPicture> seen() const;
  /// The first thing that the data sheet does not allow; empty if there was none.
  const std::string& complaint() const { return complaint_; }

 private:
  static constexpr int kColumns = 64;  // of two pixels
  static constexpr int kRows = 80;
  void execute();
  void complain(const std::string& what);

  std::vector<std::uint8_t> command_;  // so far: its code and parameters
  std::array<std::uint8_t, kColumns* kRows> memory_ = noise();
  int first_column_ = 0, last_column_ = kColumns - 1, column_ = 0;
  int first_row_ = 0, last_row_ = kRows - 1, row_ = 0;
  std::optional<std::uint8_t> contrast_, remap_, start_line_, offset_, multiplex_;
  bool on_ = false, normal_ = false, supplied_ = false, grey_table_ = false;
  std::string complaint_;

  static std::array<std::uint8_t, kColumns * kRows> noise();
};

static_assert(hal::CommandDataBus<Ssd0323Panel>);

}  // namespace zstrip::boards
