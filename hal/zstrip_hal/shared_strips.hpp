// Shares the strips of a frame between two cores: a free core draws the next strip, and finished strips are sent in
// order.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>

#include "zstrip_hal/display.hpp"
#include "zstrip_hal/error.hpp"
#include "zstrip_hal/present.hpp"

namespace zstrip::hal {

/// One of the two cores.
enum class Core : std::uint8_t { first, second };

/// Mutual exclusion of two cores by loads and stores alone, because a Cortex-M0 has nothing else: G. L. Peterson,
/// "Myths about the mutual exclusion problem", 1981. Hold it for a few instructions only: the other core waits in a
/// loop. Threads that share a core would waste each other's time.
class TwoCoreLock {
 public:
  /// Waits until the other core has unlocked.
  void lock(Core core) {
    const auto own = static_cast<std::uint8_t>(core);
    wants_[own].store(true);
    last_.store(own);
    while (wants_[1U - own].load() && last_.load() == own) {
    }
  }
  /// Call it on the core that locked.
  void unlock(Core core) { wants_[static_cast<std::uint8_t>(core)].store(false); }

 private:
  std::atomic<bool> wants_[2] = {false, false};
  std::atomic<std::uint8_t> last_ = 0;  ///< the core that wanted the lock last; it lets the other one go first
};

/// Holds the lock as long as it lives.
class TwoCoreHold {
 public:
  /// Waits as lock() does.
  TwoCoreHold(TwoCoreLock& lock, Core core) : lock_(lock), core_(core) { lock_.lock(core_); }
  ~TwoCoreHold() { lock_.unlock(core_); }
  TwoCoreHold(const TwoCoreHold&) = delete;
  TwoCoreHold& operator=(const TwoCoreHold&) = delete;

 private:
  TwoCoreLock& lock_;
  Core core_;
};

/// Three buffers with the properties of those in StripBuffers: two are drawn into while one is sent.
using TwoCoreBuffers = std::array<std::span<std::byte>, 3>;

/// The result of one step of a core.
enum class Progress : std::uint8_t {
  idle,    ///< the core must wait for the other one
  worked,  ///< a strip was drawn or sent
  over,    ///< all strips are begun; the other core may still draw or send
};

/// The state of a frame that is being drawn and sent. `DrawStatus`: of the renderers, as in PresentResult.
template <class DrawStatus>
class SharedStrips {
 public:
  /// Starts a frame that `display` has begun. Call it while no core works. All arguments must live until both cores
  /// are done.
  template <Display Panel>
  void open(Panel& display, const StripAreas& areas, std::uint16_t count, const TwoCoreBuffers& buffers) {
    areas_ = areas, count_ = count, buffers_ = buffers, format_ = display.format();
    display_ = &display;
    send_ = [](void* to, const Area& area, std::span<std::byte> pixels) {
      Panel& panel = *static_cast<Panel*>(to);
      const Error before = panel.wait();
      return before != Error::none || pixels.empty() ? before : panel.write(area, pixels);
    };
    next_ = written_ = free_ = 0;
    is_drawn_ = {};
    is_display_used_ = fails_ = false;
    result_ = {};
  }

  /// Executes one task that `core` can do now, with its renderer.
  template <StripRenderer Renderer>
  Progress step(Core core, Renderer& renderer) {
    const auto [task, strip] = take(core);
    switch (task) {
      case Task::none: return Progress::idle;
      case Task::over: return Progress::over;
      case Task::draw: draw(core, renderer, strip); break;
      case Task::send:
      case Task::wait: send(core, task, strip); break;
    }
    return Progress::worked;
  }

  /// Ends the frame with an error of the next strip to be sent, unless it has already ended with an error.
  void fail(Core core, const DrawStatus& draw, Error display) {
    const TwoCoreHold hold(lock_, core);
    keep({draw, display, written_ < count_ ? written_ : static_cast<std::uint16_t>(count_ - 1U)});
  }
  /// Returns success, or the first error.
  PresentResult<DrawStatus> result(Core core) {
    const TwoCoreHold hold(lock_, core);
    return result_;
  }
  /// True while a core is inside a function of the display.
  bool is_display_used(Core core) {
    const TwoCoreHold hold(lock_, core);
    return is_display_used_;
  }

 private:
  enum class Task : std::uint8_t { none, over, draw, send, wait };
  struct StripTask {
    Task task = Task::none;
    std::uint16_t strip = 0;
  };
  static constexpr std::uint16_t kBuffers = 3;

  StripTask take(Core core) {
    const TwoCoreHold hold(lock_, core);
    if (fails_) return {Task::over};
    if (written_ < next_ && is_drawn_[written_ % kBuffers] && !is_display_used_) {
      is_display_used_ = true;
      return {Task::send, written_};
    }
    if (next_ == count_) return {Task::over};
    if (next_ - free_ < kBuffers) return {Task::draw, next_++};
    if (free_ == written_ || is_display_used_) return {};
    is_display_used_ = true;
    return {Task::wait, written_};
  }
  template <StripRenderer Renderer>
  void draw(Core core, Renderer& renderer, std::uint16_t strip) {
    const DrawStatus status = renderer.draw_strip(strip, buffers_[strip % kBuffers]);
    const TwoCoreHold hold(lock_, core);
    is_drawn_[strip % kBuffers] = true;
    if (!status) keep({status, Error::none, strip});
  }
  /// Sends `strip`, or only waits for the one before it.
  void send(Core core, Task task, std::uint16_t strip) {
    const Area area = areas_.area(strip);
    const std::size_t bytes = task == Task::wait ? 0 : area.height * bytes_per_row(area.width, format_);
    const Error error = send_(display_, area, buffers_[strip % kBuffers].first(bytes));
    const TwoCoreHold hold(lock_, core);
    is_display_used_ = false;
    free_ = strip;
    if (task == Task::send) ++written_, is_drawn_[strip % kBuffers] = false;
    if (error != Error::none) keep({{}, error, strip});
  }
  /// Call it with the lock held.
  void keep(const PresentResult<DrawStatus>& error) {
    if (!fails_) result_ = error;
    fails_ = true;
  }

  TwoCoreLock lock_;
  void* display_ = nullptr;
  Error (*send_)(void* display, const Area& area, std::span<std::byte> pixels) = nullptr;
  StripAreas areas_{{}, 0, 0};
  TwoCoreBuffers buffers_{};
  DisplayFormat format_ = DisplayFormat::rgb565;
  std::uint16_t count_ = 0;
  // The lock guards the members below. Strip s is drawn into buffer s % kBuffers. All strips before `next_` are drawn
  // or being drawn, all before `written_` are sent or being sent, all before `free_` have certainly been sent.
  std::uint16_t next_ = 0, written_ = 0, free_ = 0;
  std::array<bool, kBuffers> is_drawn_{};  // the strip in this buffer waits to be sent
  bool is_display_used_ = false;
  bool fails_ = false;
  PresentResult<DrawStatus> result_{};
};

}  // namespace zstrip::hal
