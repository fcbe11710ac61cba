// A model of an RGB (parallel) panel: a glass without memory that shows the rows it receives, while its clock runs.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "panel/panel_model.hpp"

namespace zstrip::sim {

/// The blanking around the pixels of a row, in pixels, or around the rows of a frame, in rows. The pulse comes first,
/// then the back porch, the pixels and the front porch.
struct RgbPorches {
  unsigned pulse = 0, back = 0, front = 0;
  constexpr unsigned total() const { return pulse + back + front; }
};

/// The signals of a controller.
struct RgbTimings {
  std::uint16_t width = 0, height = 0;
  Nanoseconds pixel{};  ///< one cycle of the pixel clock
  RgbPorches columns, rows;

  constexpr Nanoseconds row_time() const { return (width + columns.total()) * pixel; }
  constexpr Nanoseconds frame_time() const { return (height + rows.total()) * row_time(); }
};

/// The signals that a panel allows.
struct RgbLimits {
  struct Range {
    unsigned least = 0, most = 0;
  };
  std::uint16_t width = 0, height = 0;
  Nanoseconds shortest_pixel{}, longest_pixel{};
  Range column_pulse, column_back, column_front;  ///< `back` has the pulse in it
  Range row_pulse, row_back, row_front;           ///< the same
};

/// 480x272 pixels, as modules with an ST7262 and similar controllers have them.
inline constexpr RgbLimits kRgb480x272{.width = 480,
                                       .height = 272,
                                       .shortest_pixel = 83ns,
                                       .longest_pixel = 125ns,
                                       .column_pulse = {2, 43},
                                       .column_back = {3, 47},
                                       .column_front = {2, 75},
                                       .row_pulse = {2, 12},
                                       .row_back = {2, 16},
                                       .row_front = {2, 37}};
/// The usual timings of such a module.
inline constexpr RgbTimings kRgbTimings480x272{
    .width = 480, .height = 272, .pixel = 111ns, .columns = {4, 43, 8}, .rows = {4, 12, 8}};

/// Rows arrive whole. The model is told the timings of the signals once, as a controller is.
class RgbModel final : public PanelModel {
 public:
  /// The time after which a glass without signals has lost its picture; assumed.
  static constexpr Nanoseconds kFading = 100ms;

  explicit RgbModel(const RgbLimits& limits = kRgb480x272);

  /// The signals begin.
  void start(const RgbTimings& timings);
  /// The edge of VSYNC, at the time now().
  void begin_frame();
  /// A row of pixels in RGB565, low byte first, at the time now().
  void receive_row(std::span<const std::byte> pixels);

  RgbImage seen() const override { return glass_; }
  std::string darkness() const override;
  Nanoseconds shortest_cycle() const override { return limits_.shortest_pixel; }
  /// It has no commands, and nothing to interrupt.
  void interrupted() override {}

 private:
  void receive_byte(Wire wire, std::uint8_t byte) override;
  void reset() override {}
  Nanoseconds shortest_reset() const override { return 10us; }
  void check(const char* what, unsigned value, const RgbLimits::Range& range);

  RgbLimits limits_;
  RgbImage glass_;
  std::uint32_t row_ = 0;  // of the frame, the next one
  bool has_frame_ = false, has_signals_ = false;
  Nanoseconds last_row_{};
};

}  // namespace zstrip::sim
