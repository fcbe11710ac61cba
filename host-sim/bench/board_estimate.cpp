// Shares the time of a frame among its strips by their pixels.
#include "bench/board_estimate.hpp"

#include <fmt/format.h>

#include <cmath>

#include "bench/board_prediction.hpp"

namespace zstrip::sim {
namespace {

/// Returns the bytes of window commands and pixels.
std::uint64_t bytes_on_bus(const std::vector<Rect>& strips, const View& view) {
  std::uint64_t bytes = 0;
  for (const Rect& area : strips) {
    bytes += kWindowBytes + std::uint64_t{bytes_per_row(static_cast<std::uint16_t>(area.width()), view.format)} *
                                static_cast<std::uint64_t>(area.height());
  }
  return bytes;
}

/// Returns the bytes of a board's memory that the plan takes, and kReservedRam for the rest of the program.
std::uint64_t ram_on(const BoardModel& board, const EstimatedFrame& frame) {
  return std::uint64_t{frame.plan.bytes()} +
         (board.dma ? 2U : 1U) * std::uint64_t{frame.plan.strip_pixel_bytes(frame.view)} + kReservedRam;
}

/// Returns at least so many digits, without an exponent.
std::string rate_in_digits(double rate, int digits) {
  return rate < std::pow(10, digits) - 0.5 ? fmt::format("{:.{}g}", rate, digits) : fmt::format("{:.0f}", rate);
}

}  // namespace

std::vector<Rect> strips_of(const Plan& plan, const View& view) {
  std::vector<Rect> strips;
  for (std::uint16_t strip = 0; strip < plan.strips; ++strip) strips.push_back(plan.strip_area(strip, view));
  return strips;
}

BoardTime time_on(const BoardModel& board, double cycles, double bus_mhz, const EstimatedFrame& frame) {
  return {static_cast<double>(frame.instructions) * cycles / (board.core_mhz * 1e6),
          static_cast<double>(8 * bytes_on_bus(strips_of(frame.plan, frame.view), frame.view)) / (bus_mhz * 1e6)};
}

std::vector<StripTimes> times_on(const BoardModel& board, double cycles, double bus_mhz, const EstimatedFrame& frame) {
  const BoardTime time = time_on(board, cycles, bus_mhz, frame);
  const std::vector<Rect> strips = strips_of(frame.plan, frame.view);
  std::vector<StripWork> works;
  std::int64_t pixels = 0;
  const auto pixels_of = [](const Rect& area) { return std::int64_t{area.width()} * area.height(); };
  for (const Rect& area : strips) pixels += pixels_of(area);
  for (const Rect& area : strips) {
    const double share = static_cast<double>(pixels_of(area)) / static_cast<double>(pixels);
    works.push_back({time.draw * share, time.send * share});
  }
  return strip_timeline(0, works, board.dma);
}

BoardRate rate_on(const BoardModel& board, double bus_mhz, const EstimatedFrame& frame) {
  BoardRate rate{.board = board.name, .needed_ram = ram_on(board, frame)};
  if (rate.needed_ram <= board.ram_bytes && frame.cycles) {
    const EstimatedFrame known{frame.plan, frame.view, static_cast<std::uint64_t>(*frame.cycles)};
    rate.least = rate.most = 1 / times_on(board, 1, bus_mhz, known).back().send_end;
  } else if (rate.needed_ram <= board.ram_bytes) {
    rate.least = 1 / times_on(board, board.cycles_per_estimate.high, bus_mhz, frame).back().send_end;
    rate.most = 1 / times_on(board, board.cycles_per_estimate.low, bus_mhz, frame).back().send_end;
  }
  return rate;
}

std::string BoardRate::words() const {
  if (!fits()) return fmt::format("needs {} KB", (needed_ram + 1023) / 1024);
  if (least == most) return rate_in_digits(most, 3);
  const std::string low = rate_in_digits(least, 2), high = rate_in_digits(most, 2);
  return low == high ? low : fmt::format("{} to {}", low, high);
}

}  // namespace zstrip::sim
