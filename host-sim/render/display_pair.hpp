// Two displays that get the same strips: the picture in memory, and a panel.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "zstrip_hal/display.hpp"

namespace zstrip::sim {

/// Both have the same size and format. Returns the first error of either. Both refer to displays that outlive the pair.
/// The first one keeps all pixels that the second one remembers.
template <hal::Display First, hal::Display Second>
class DisplayPair {
 public:
  DisplayPair(First& first, Second& second) : first_(first), second_(second) {}

  std::uint16_t width() const { return first_.width(); }
  std::uint16_t height() const { return first_.height(); }
  hal::DisplayFormat format() const { return first_.format(); }

  hal::Error begin_frame() { return either(first_.begin_frame(), second_.begin_frame()); }
  hal::Error write(const hal::Area& area, std::span<std::byte> pixels) {
    return either(first_.write(area, pixels), second_.write(area, pixels));
  }
  static constexpr std::size_t kStrips = Second::kStrips;
  bool shows(const hal::Area& area, std::uint32_t fingerprint) { return second_.shows(area, fingerprint); }
  hal::Error wait() { return either(first_.wait(), second_.wait()); }
  hal::Error end_frame() { return either(first_.end_frame(), second_.end_frame()); }

 private:
  static hal::Error either(hal::Error first, hal::Error second) { return first != hal::Error::none ? first : second; }

  First& first_;
  Second& second_;
};

}  // namespace zstrip::sim
